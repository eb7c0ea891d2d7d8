// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/cut_journal.h"

#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {

bool CutJournal::mark() {
    if (!pages_.empty() && pages_.back().empty()) return false;
    if (pages_.size() == kMaxCheckpoints) pages_.erase(pages_.begin());
    pages_.emplace_back();
    TACTOOTH_ASSERT(pages_.size() <= kMaxCheckpoints);
    return true;
}

std::map<BrickKey, CutField> CutJournal::rollBack() {
    TACTOOTH_ASSERT(!pages_.empty());
    if (pages_.back().empty() && pages_.size() > 1) pages_.pop_back();
    std::map<BrickKey, CutField> page = std::move(pages_.back());
    pages_.pop_back();
    return page;
}

void CutJournal::validate(const BrickMap& bricks, double spacing) const {
    TACTOOTH_ASSERT(pages_.size() <= kMaxCheckpoints);
    for (std::size_t i = 0; i < pages_.size(); ++i) {
        TACTOOTH_ASSERT(!pages_[i].empty() || i + 1 == pages_.size());
        for (const auto& [key, field] : pages_[i]) {
            TACTOOTH_ASSERT(bricks.find(key) != nullptr);
            field.validate(spacing);
        }
    }
}

std::size_t CutJournal::bytes() const {
    std::size_t bricks = 0;
    for (const auto& page : pages_) bricks += page.size();
    return bricks * (sizeof(BrickKey) + sizeof(CutField));
}

}  // namespace tactooth
