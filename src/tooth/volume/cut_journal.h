// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "tooth/volume/brick_map.h"

namespace tactooth {

/// Copies of bricks before they were cut, for undo. After each mark it keeps one copy of a brick, made at its first
/// cut.
class CutJournal {
public:
    /// Number of marks that are kept. A further mark drops the oldest one.
    static constexpr std::size_t kMaxCheckpoints = 24;

    /// Sets a mark. Does nothing and returns false if nothing has changed since the last one.
    bool mark();
    [[nodiscard]] std::size_t marks() const { return pages_.size(); }

    /// Must be called before a brick is changed.
    void keep(const BrickKey& key, const CutField& before) {
        if (!pages_.empty()) pages_.back().try_emplace(key, before);
    }

    /// Returns the bricks that changed after the last mark with a change, in their state before, and forgets that mark.
    /// There must be a mark.
    [[nodiscard]] std::map<BrickKey, CutField> rollBack();

    void clear() { pages_.clear(); }
    /// Asserts the limit of marks, that only the last page may be empty, and that each kept brick still exists and has
    /// a valid field. Looks at every node. `spacing` in mm.
    void validate(const BrickMap& bricks, double spacing) const;
    [[nodiscard]] std::size_t bytes() const;

private:
    std::vector<std::map<BrickKey, CutField>> pages_;
};

}  // namespace tactooth
