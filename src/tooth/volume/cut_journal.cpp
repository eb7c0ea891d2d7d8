// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/cut_journal.h"

#include <utility>

#include "geometry/util/assert.h"

namespace tactooth {

void CutJournal::Step::add(const BrickKey& key, FieldChange change) {
    bytes += sizeof key + change.bytes();
    changes.emplace_back(key, std::move(change));
}

void CutJournal::mark(const BrickMap& bricks) {
    finish(bricks);
    isMarked_ = true;
}

void CutJournal::finish(const BrickMap& bricks) {
    if (open_.empty()) return;
    Step step;
    step.changes.reserve(open_.size());
    for (const auto& [key, before] : open_) {
        TACTOOTH_ASSERT(bricks.find(key) != nullptr);
        step.add(key, FieldChange::between(*bricks.find(key), before, spacing_));
    }
    open_.clear();
    undo_.push_back(std::move(step));
    std::size_t total = 0;
    for (const Step& kept : undo_) total += kept.bytes;
    while (total > maxBytes_ && undo_.size() > 1) {
        total -= undo_.front().bytes;
        undo_.erase(undo_.begin());
    }
}

/// Takes the last step of `from` and leaves its opposite in `to`.
CutJournal::Fields CutJournal::exchange(std::vector<Step>& from, std::vector<Step>& to, const BrickMap& bricks) const {
    TACTOOTH_ASSERT(!from.empty());
    Fields fields;
    Step opposite;
    for (const auto& [key, change] : from.back().changes) {
        TACTOOTH_ASSERT(bricks.find(key) != nullptr);
        const CutField& now = *bricks.find(key);
        CutField& then = fields.emplace_back(key, now).second;
        change.apply(then, spacing_);
        opposite.add(key, FieldChange::between(then, now, spacing_));
    }
    from.pop_back();
    to.push_back(std::move(opposite));
    return fields;
}

CutJournal::Fields CutJournal::undo(const BrickMap& bricks) {
    finish(bricks);
    return exchange(undo_, redo_, bricks);
}

CutJournal::Fields CutJournal::redo(const BrickMap& bricks) {
    TACTOOTH_ASSERT(open_.empty());
    return exchange(redo_, undo_, bricks);
}

void CutJournal::validate(const BrickMap& bricks) const {
    TACTOOTH_ASSERT(redo_.empty() || open_.empty());
    for (const auto& [key, field] : open_) {
        TACTOOTH_ASSERT(bricks.find(key) != nullptr);
        field.validate(spacing_);
    }
    // The last step states how the bricks were before it, the last undone step how they were after it.
    for (const std::vector<Step>* steps : {&undo_, &redo_}) {
        if (steps->empty()) continue;
        for (const auto& [key, change] : steps->back().changes) {
            TACTOOTH_ASSERT(bricks.find(key) != nullptr);
            const auto open = open_.find(key);
            CutField field = open != open_.end() ? open->second : *bricks.find(key);
            change.apply(field, spacing_);
            field.validate(spacing_);
        }
    }
}

std::size_t CutJournal::bytes() const {
    std::size_t bytes = open_.size() * (sizeof(BrickKey) + sizeof(CutField));
    for (const std::vector<Step>* steps : {&undo_, &redo_}) {
        for (const Step& step : *steps) bytes += step.bytes;
    }
    return bytes;
}

}  // namespace tactooth
