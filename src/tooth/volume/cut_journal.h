// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "tooth/volume/brick_map.h"
#include "tooth/volume/field_change.h"

namespace tactooth {

/// The steps of cutting, for undo and redo. A step is all that changes between two marks. While a step is under way,
/// the journal keeps a copy of each brick from before its first change. Of a finished step it keeps only the nodes that
/// differ.
class CutJournal {
public:
    /// Bytes of all finished steps. Beyond it the oldest steps are forgotten. Enough for a thousand strokes along a
    /// cavity that is 3 mm long, with voxels of 0.025 mm.
    static constexpr std::size_t kMaxBytes = std::size_t{512} << 20;

    /// `spacing` of the nodes, mm. `maxBytes` is for tests.
    explicit CutJournal(double spacing, std::size_t maxBytes = kMaxBytes) : spacing_(spacing), maxBytes_(maxBytes) {}

    /// The next change begins a step of its own. Changes before the first mark belong to no step.
    void mark(const BrickMap& bricks);

    /// Must be called before a brick is changed.
    void keep(const BrickKey& key, const CutField& before) {
        if (!isMarked_) return;
        redo_.clear();
        open_.try_emplace(key, before);
    }

    /// Number of steps that can be undone and redone.
    [[nodiscard]] std::size_t undoable() const { return undo_.size() + (open_.empty() ? 0 : 1); }
    [[nodiscard]] std::size_t redoable() const { return redo_.size(); }

    using Fields = std::vector<std::pair<BrickKey, CutField>>;
    /// Returns the bricks of the last step, in their state before it. There must be such a step. The next change
    /// begins another one.
    [[nodiscard]] Fields undo(const BrickMap& bricks);
    /// Returns the bricks of the step that was undone last, in their state after it. There must be such a step.
    [[nodiscard]] Fields redo(const BrickMap& bricks);

    /// Asserts that each brick of a step exists, and that the copies have valid fields. Looks at every node.
    void validate(const BrickMap& bricks) const;
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Step {
        std::vector<std::pair<BrickKey, FieldChange>> changes;
        std::size_t bytes = 0;
        void add(const BrickKey& key, FieldChange change);
    };

    void finish(const BrickMap& bricks);
    [[nodiscard]] Fields exchange(std::vector<Step>& from, std::vector<Step>& to, const BrickMap& bricks) const;

    double spacing_;
    std::size_t maxBytes_;
    bool isMarked_ = false;              // there was a mark
    std::map<BrickKey, CutField> open_;  // the step under way: bricks before their first change
    std::vector<Step> undo_;             // finished steps, oldest first: what restores the state before each
    std::vector<Step> redo_;             // undone steps, the last one at the end: what restores the state after each
};

}  // namespace tactooth
