// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "geometry/util/assert.h"
#include "tooth/volume/brick_key.h"

namespace tactooth {

/// A brick in which a carve has moved the boundary of the removed region, and the neighbours with a node in an affected
/// cell.
struct ChangedBrick {
    BrickKey key;
    std::uint32_t affected = 0;  ///< bit i: BrickKey::neighbour(i)

    [[nodiscard]] static ChangedBrick all(const BrickKey& key) { return {key, (1U << 27) - 1}; }
    [[nodiscard]] bool isNone() const { return affected == 0; }
    /// Adds all cells around a removed node.
    void addNode(int node);
    /// Adds the four cells around a lattice edge, from a node to the next one on `axis`, whose crossing was moved.
    void addEdge(int node, int axis);
    void add(const ChangedBrick& other) {
        TACTOOTH_ASSERT(other.key == key);
        affected |= other.affected;
    }

    /// Calls `visit(i)` for each affected brick, by its number as a neighbour.
    template <class Visit>
    void forEachAffected(const Visit& visit) const {
        TACTOOTH_ASSERT(affected < 1U << 27);
        for (std::uint32_t left = affected; left != 0; left &= left - 1) visit(std::countr_zero(left));
    }
};

/// Merges changes to one entry for each brick, in ascending order of the keys. Drops entries without a change.
[[nodiscard]] std::vector<ChangedBrick> merged(std::vector<ChangedBrick> changes);

}  // namespace tactooth
