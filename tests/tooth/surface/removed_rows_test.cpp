// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/removed_rows.h"

#include <gtest/gtest.h>

#include <random>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

using Coverage = RemovedRows::Coverage;

/// Three bricks side by side with random boxes of removed nodes.
BrickMap clumps(std::mt19937& random) {
    BrickMap bricks;
    std::uniform_int_distribution<int> side(0, kBrickSide - 1);
    for (int x = -1; x <= 1; ++x) {
        CutField field = CutField::untouched(0.1);
        std::array<int, 3> low, high;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = side(random) / 2;
            high[axis] = kBrickSide - 1 - side(random) / 2;
        }
        for (int node = 0; node < kBrickNodes; ++node) {
            const std::array<int, 3> place = placeOf(node);
            bool isIn = true;
            for (int axis = 0; axis < 3; ++axis) isIn &= place[axis] >= low[axis] && place[axis] <= high[axis];
            if (isIn) field.cut[node] = -1;
        }
        auto brick = std::make_unique<Brick>();
        brick->setField(field);
        bricks.insert({x, 0, 0}, std::move(brick));
    }
    return bricks;
}

/// The reference: node by node.
Coverage shareOf(const BrickNeighbourhood& nodes, const RemovedRows::Place& low, const RemovedRows::Place& high) {
    bool some = false;
    bool all = true;
    for (int z = low[2]; z <= high[2]; ++z) {
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int x = low[0]; x <= high[0]; ++x) {
                const bool isRemoved = nodes.isRemoved(BrickNeighbourhood::index(x, y, z));
                some |= isRemoved;
                all &= isRemoved;
            }
        }
    }
    return all ? Coverage::All : some ? Coverage::Some : Coverage::None;
}

TEST(RemovedRows, TheShareIsThatOfTheNodesInTheBox) {
    std::mt19937 random(2);
    std::uniform_int_distribution<int> place(-1, kBrickSide);
    std::array<int, 3> seen{};
    for (int i = 0; i < 400; ++i) {
        const BrickMap bricks = clumps(random);
        const BrickNeighbourhood nodes(bricks, {0, 0, 0}, 0.1);
        const RemovedRows rows(nodes);
        for (int box = 0; box < 50; ++box) {
            RemovedRows::Place low, high;
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = place(random);
                high[axis] = std::min(kBrickSide, low[axis] + place(random) / (box % 3 + 1));
                high[axis] = std::max(low[axis], high[axis]);
            }
            const Coverage expected = shareOf(nodes, low, high);
            ASSERT_EQ(rows.coverage(low, high), expected);
            ++seen[static_cast<std::size_t>(expected)];
        }
    }
    for (const int count : seen) EXPECT_GT(count, 200);
}

TEST(RemovedRowsAsserts, ABoxOfNodesIsNotTurnedRoundAndLiesInside) {
    std::mt19937 random(3);
    const BrickMap bricks = clumps(random);
    const BrickNeighbourhood nodes(bricks, {0, 0, 0}, 0.1);
    const RemovedRows rows(nodes);
    EXPECT_ASSERT(static_cast<void>(rows.coverage({2, 0, 0}, {1, 3, 3})));
    EXPECT_ASSERT(static_cast<void>(rows.coverage({0, 0, 0}, {1, 3, kBrickSide + 1})));
}

}  // namespace
}  // namespace tactooth
