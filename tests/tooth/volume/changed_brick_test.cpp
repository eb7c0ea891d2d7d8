// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/changed_brick.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "support/expect_assert.h"
#include "tooth/volume/lattice.h"

namespace tactooth {
namespace {

/// The bricks that have a node from `low` to `high`, as bits of BrickKey::neighbour. Places count from the brick's
/// first node.
std::uint32_t bricksWithNodes(const std::array<int, 3>& low, const std::array<int, 3>& high) {
    std::uint32_t bricks = 0;
    for (int x = low[0]; x <= high[0]; ++x) {
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int z = low[2]; z <= high[2]; ++z) {
                const BrickKey key = LatticeNode({x, y, z}).key;
                bricks |= 1U << (13 + key.x + 3 * key.y + 9 * key.z);
            }
        }
    }
    return bricks;
}

TEST(ChangedBrick, ConcernsTheBricksWithANodeInACellAroundWhatHasChanged) {
    for (int node = 0; node < kBrickNodes; ++node) {
        std::array<int, 3> before, after;
        for (int axis = 0; axis < 3; ++axis) {
            before[axis] = placeOf(node)[axis] - 1;
            after[axis] = placeOf(node)[axis] + 1;
        }
        ChangedBrick removed{{}};
        removed.addNode(node);
        ASSERT_EQ(removed.affected, bricksWithNodes(before, after)) << node;
        for (int axis = 0; axis < 3; ++axis) {
            std::array<int, 3> first = before;
            ++first[axis];  // no cell around an edge begins before the edge
            ChangedBrick moved{{}};
            moved.addEdge(node, axis);
            ASSERT_EQ(moved.affected, bricksWithNodes(first, after)) << node << " on axis " << axis;
        }
    }
}

TEST(ChangedBrick, ListsEachBrickOnce) {
    const BrickKey key{4, -2, 7};
    ChangedBrick changed{key};
    EXPECT_TRUE(changed.isNone());
    changed.addNode(nodeIndex(0, 3, 3));
    changed.addNode(nodeIndex(3, 7, 3));
    changed.addNode(nodeIndex(0, 3, 3));
    std::vector<BrickKey> affected;
    changed.forEachAffected([&](int i) { affected.push_back(key.neighbour(i)); });
    EXPECT_EQ(affected,
              (std::vector<BrickKey>{key.moved(-1, 0, 0), key, key.moved(0, 1, 0)}));  // and no diagonal neighbour

    std::size_t all = 0;
    ChangedBrick::all(key).forEachAffected([&](int) { ++all; });
    EXPECT_EQ(all, 27U);
}

TEST(ChangedBrickAsserts, ChangesOfTwoBricksAreNotAddedUp) {
    ChangedBrick changed{{1, 2, 3}};
    EXPECT_ASSERT(changed.add(ChangedBrick{{1, 2, 4}}));
    EXPECT_ASSERT(changed.addEdge(0, 3));
    EXPECT_ASSERT(changed.addNode(kBrickNodes));
}

}  // namespace
}  // namespace tactooth
