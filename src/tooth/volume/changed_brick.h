// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "geometry/util/assert.h"
#include "tooth/volume/brick_key.h"

namespace tactooth {

/// A brick in which a carve has moved the border of the removed region, and which bricks have a node in a cell that
/// this concerns.
struct ChangedBrick {
    BrickKey key;
    std::uint32_t affected = 0;  ///< bit i: BrickKey::neighbour(i)

    [[nodiscard]] static ChangedBrick all(const BrickKey& key) { return {key, (1U << 27) - 1}; }
    [[nodiscard]] bool isNone() const { return affected == 0; }
    /// A node was removed: all cells around it.
    void addNode(int node);
    /// The border was moved on the lattice edge from a node to the next one on `axis`: the four cells around that.
    void addEdge(int node, int axis);
    void add(const ChangedBrick& other) {
        TACTOOTH_ASSERT(other.key == key);
        affected |= other.affected;
    }

    /// Calls `visit(i)` for the bricks that are affected, by their numbers as neighbours.
    template <class Visit>
    void forEachAffected(const Visit& visit) const {
        TACTOOTH_ASSERT(affected < 1U << 27);
        for (std::uint32_t left = affected; left != 0; left &= left - 1) visit(std::countr_zero(left));
    }
};

/// One entry a brick that covers all changes of it, in ascending order of their keys; bricks without one are left out.
[[nodiscard]] std::vector<ChangedBrick> merged(std::vector<ChangedBrick> changes);

}  // namespace tactooth
