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
    return true;
}

std::map<BrickKey, CutField> CutJournal::rollBack() {
    TACTOOTH_ASSERT(!pages_.empty());
    if (pages_.back().empty() && pages_.size() > 1) pages_.pop_back();
    std::map<BrickKey, CutField> page = std::move(pages_.back());
    pages_.pop_back();
    return page;
}

std::size_t CutJournal::bytes() const {
    std::size_t bricks = 0;
    for (const auto& page : pages_) bricks += page.size();
    return bricks * (sizeof(BrickKey) + sizeof(CutField));
}

}  // namespace tactooth
