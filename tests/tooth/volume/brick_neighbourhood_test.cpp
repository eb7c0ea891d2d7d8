// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/brick_neighbourhood.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

/// A brick and its neighbours except one. Nodes are removed up to a height.
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
        EXPECT_EQ(nodes.hasRemoved(), height >= 0);
        for (int z = -1; z <= kBrickSide; ++z) {
            for (int y = -1; y <= kBrickSide; ++y) {
                for (int x = -1; x <= kBrickSide; ++x) {
                    const bool isThere = !(x == kBrickSide && y >= 0 && y < kBrickSide && z >= 0 && z < kBrickSide);
                    EXPECT_EQ(nodes.removedRow(y, z) >> (x + 1) & 1U, isThere && z < height ? 1U : 0U);
                    EXPECT_EQ(nodes.isRemoved(BrickNeighbourhood::index(x, y, z)), isThere && z < height);
                }
            }
        }
    }
}

TEST(BrickNeighbourhood, KnowsWhichCornersOfACellAreRemoved) {
    const BrickKey middle{3, -2, 7};
    const BrickMap bricks = bricksRemovedBelow(4, middle.moved(1, 0, 0));
    const BrickNeighbourhood nodes(bricks, middle, 0.1);
    for (int z = -1; z < kBrickSide; ++z) {
        for (int y = -1; y < kBrickSide; ++y) {
            for (int x = -1; x < kBrickSide; ++x) {
                const int cell = BrickNeighbourhood::index(x, y, z);
                EXPECT_EQ(BrickNeighbourhood::placeOf(cell), (BrickNeighbourhood::Place{x, y, z}));
                unsigned removed = 0;
                for (int corner = 0; corner < 8; ++corner) {
                    const int node =
                        BrickNeighbourhood::index(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2));
                    if (nodes.isRemoved(node)) removed |= 1U << corner;
                }
                EXPECT_EQ(nodes.removedCorners(cell), removed);
            }
        }
    }
}

TEST(BrickNeighbourhood, KnowsHowFarNodesAreFromTheToothsSurface) {
    const BrickKey middle{3, -2, 7};
    const BrickKey absent = middle.moved(1, 0, 0);
    BrickMap bricks = bricksRemovedBelow(0, absent);
    for (int i = 0; i < 27; ++i) {
        Brick* brick = bricks.find(middle.neighbour(i));
        if (brick == nullptr) continue;
        for (int node = 0; node < kBrickNodes; ++node)
            brick->tooth[node] = -0.001F * static_cast<float>(100 * i + node);
        brick->maxToothDistance = -0.1F * static_cast<float>(i);
    }
    const BrickNeighbourhood nodes(bricks, middle, 0.1);
    EXPECT_EQ(nodes.tooth(BrickNeighbourhood::index(2, 3, 4)), -0.001F * (1300 + nodeIndex(2, 3, 4)));
    EXPECT_EQ(nodes.tooth(BrickNeighbourhood::index(-1, 8, 0)), -0.001F * (1500 + nodeIndex(7, 0, 0)));
    EXPECT_EQ(nodes.tooth(BrickNeighbourhood::index(8, 3, 4)), static_cast<float>(kToothBand * 0.1));
    for (const float distance : {-1.6F, -1.55F, 0.0F, 0.5F}) {
        const auto row = nodes.toothRow(3, 4);
        for (int x = 0; x <= kBrickSide; ++x) {
            const float tooth = nodes.tooth(BrickNeighbourhood::index(x, 3, 4));
            EXPECT_EQ(row.above(distance) >> (x + 1) & 1U, tooth > distance ? 1U : 0U);
            EXPECT_EQ(row.below(distance) >> (x + 1) & 1U, tooth < distance ? 1U : 0U);
        }
    }
    EXPECT_FALSE(nodes.isDeeperThan(0));  // one neighbour is absent
    bricks.insert(absent, std::make_unique<Brick>());
    EXPECT_FALSE(BrickNeighbourhood(bricks, middle, 0.1).isDeeperThan(0));  // its depth is unknown
    bricks.find(absent)->maxToothDistance = -1.4F;
    EXPECT_TRUE(BrickNeighbourhood(bricks, middle, 0.1).isDeeperThan(1.2F));
    EXPECT_FALSE(BrickNeighbourhood(bricks, middle, 0.1).isDeeperThan(1.35F));  // the brick itself is not so deep
}

TEST(BrickNeighbourhoodAsserts, NodesAndEdgesOutsideAreRefused) {
    EXPECT_ASSERT(static_cast<void>(BrickNeighbourhood::index(kBrickSide + 1, 0, 0)));
    EXPECT_ASSERT(static_cast<void>(BrickNeighbourhood::placeOf(BrickNeighbourhood::kNodes)));
    const BrickKey middle{3, -2, 7};
    const BrickMap bricks = bricksRemovedBelow(4, middle.moved(1, 0, 0));
    const BrickNeighbourhood nodes(bricks, middle, 0.1);
    EXPECT_ASSERT(static_cast<void>(nodes.removedCorners(BrickNeighbourhood::index(kBrickSide, 0, 0))));
    EXPECT_ASSERT(static_cast<void>(nodes.boundary(BrickNeighbourhood::index(0, 0, 0), 2)));  // both ends are removed
}

TEST(BrickMapAsserts, ABrickIsInsertedOnceAndInRange) {
    BrickMap bricks;
    bricks.insert({1, 2, 3}, nullptr);
    EXPECT_ASSERT(bricks.insert({1, 2, 3}, nullptr));
    EXPECT_ASSERT(bricks.insert({kMaxBrickCoordinate, 0, 0}, nullptr));
    EXPECT_ASSERT(static_cast<void>(BrickKey{}.neighbour(27)));
}

TEST(LatticeAsserts, TheSpacingIsPositiveAndBoxesHoldAPoint) {
    EXPECT_ASSERT(Lattice(-0.1));
    EXPECT_ASSERT(static_cast<void>(Lattice(0.1).bricksTouching(Box3())));
    EXPECT_ASSERT(static_cast<void>(Lattice(0.1).brickAt(Vec3::Constant(std::nan("")))));
}

}  // namespace
}  // namespace tactooth
