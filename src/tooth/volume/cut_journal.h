// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "tooth/volume/brick_map.h"

namespace tactooth {

/// What bricks were like before they were cut, back to each of a number of marks. Keeps a copy of a brick once a mark,
/// when it is cut for the first time after it.
class CutJournal {
public:
    /// How many marks are kept; the oldest one goes when another is set.
    static constexpr std::size_t kMaxCheckpoints = 24;

    /// Does nothing, and says false, if nothing has changed since the last one.
    bool mark();
    [[nodiscard]] std::size_t marks() const { return pages_.size(); }

    /// To be called before a brick is changed.
    void keep(const BrickKey& key, const CutField& before) {
        if (!pages_.empty()) pages_.back().try_emplace(key, before);
    }

    /// The bricks changed since the last mark before any change, as they were then; forgets the mark. There must be
    /// one.
    [[nodiscard]] std::map<BrickKey, CutField> rollBack();

    void clear() { pages_.clear(); }
    /// Asserts that no more marks are kept than may be, that the last page alone may be empty, and that each brick that
    /// was kept still exists with a valid field. Looks at every node of them.
    void validate(const BrickMap& bricks, double spacing) const;
    [[nodiscard]] std::size_t bytes() const;

private:
    std::vector<std::map<BrickKey, CutField>> pages_;
};

}  // namespace tactooth
