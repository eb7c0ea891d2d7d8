// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/brick_neighbourhood.h"

#include <gtest/gtest.h>

#include <random>

namespace tactooth {
namespace {

using Share = BrickNeighbourhood::Share;

/// A brick and those around it but for one, where nodes are removed up to a height.
BrickMap bricksRemovedBelow(int height, const BrickKey& absent) {
    BrickMap bricks;
    const BrickKey middle{3, -2, 7};
    for (int i = 0; i < 27; ++i) {
        const BrickKey key = middle.neighbour(i);
        if (key == absent) continue;
        CutField field = CutField::untouched(0.1);
        for (int node = 0; node < kBrickNodes; ++node) {
            if (placeOf(node)[2] + kBrickSide * (key.z - middle.z) < height) field.cut[node] = -1;
        }
        auto brick = std::make_unique<Brick>();
        brick->setField(field);
        bricks.insert(key, std::move(brick));
    }
    return bricks;
}

TEST(BrickNeighbourhood, KnowsTheNodesOfTheBricksAround) {
    const BrickKey middle{3, -2, 7};
    const BrickKey absent = middle.moved(1, 0, 0);
    for (const int height : {-5, 0, 3, 8, 30}) {
        const BrickMap bricks = bricksRemovedBelow(height, absent);
        const BrickNeighbourhood nodes(bricks, middle, 0.1);
        for (int z = -1; z <= kBrickSide; ++z) {
            for (int y = -1; y <= kBrickSide; ++y) {
                for (int x = -1; x <= kBrickSide; ++x) {
                    const bool isThere = !(x == kBrickSide && y >= 0 && y < kBrickSide && z >= 0 && z < kBrickSide);
                    EXPECT_EQ(nodes.removedRow(y, z) >> (x + 1) & 1U, isThere && z < height ? 1U : 0U);
                }
            }
        }
    }
}

TEST(BrickNeighbourhood, TheShareRemovedIsThatOfTheNodesInABox) {
    const BrickKey middle{3, -2, 7};
    const BrickMap bricks = bricksRemovedBelow(4, {0, 0, 0});
    const BrickNeighbourhood nodes(bricks, middle, 0.1);
    std::mt19937 random(2);
    std::uniform_int_distribution<int> place(-4, 12);
    std::array<int, 3> seen{};
    for (int i = 0; i < 2000; ++i) {
        BrickNeighbourhood::Place low, high;
        for (int axis = 0; axis < 3; ++axis) {
            const int a = place(random);
            const int b = place(random);
            low[axis] = std::min(a, b), high[axis] = std::max(a, b);
        }
        // Places beyond the outermost nodes count as these.
        const int lowest = std::clamp(low[2], -1, kBrickSide);
        const int highest = std::clamp(high[2], -1, kBrickSide);
        const Share expected = highest < 4 ? Share::All : lowest >= 4 ? Share::None : Share::Some;
        ASSERT_EQ(nodes.removedShare(low, high), expected);
        ++seen[static_cast<std::size_t>(expected)];
    }
    for (const int count : seen) EXPECT_GT(count, 200);
}

}  // namespace
}  // namespace tactooth
