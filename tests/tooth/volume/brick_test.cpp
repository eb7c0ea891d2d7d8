// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/brick.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

Vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Vec3(normal(random), normal(random), normal(random)).normalized();
}

TEST(OctahedralNormal, UnpacksToTheSameDirection) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 direction = randomDirection(random);
        const OctahedralNormal packed(direction);
        EXPECT_LT((packed.unpack() - direction).norm(), 6e-5);
        EXPECT_LT((packed.unpackSingle().cast<double>() - packed.unpack()).norm(), 2e-7);
    }
}

TEST(OctahedralNormal, TheAxesAreExact) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            const OctahedralNormal packed(sign * Vec3::Unit(axis));
            EXPECT_EQ(packed.unpack(), Vec3(sign * Vec3::Unit(axis)));
            EXPECT_EQ(packed.unpackSingle(), Vec3f(static_cast<float>(sign) * Vec3f::Unit(axis)));
        }
    }
}

TEST(OctahedralNormal, SizesOfFourAreThoseOfEachToTheLastBit) {
    std::mt19937 random(2);
    for (int i = 0; i < 500; ++i) {
        std::array<OctahedralNormal, 4> four;
        for (OctahedralNormal& one : four) one = OctahedralNormal(randomDirection(random));
        const auto sizes = OctahedralNormal::absComponentsOf(four);
        for (int lane = 0; lane < 4; ++lane) {
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_EQ(sizes[axis][lane], std::abs(four[lane].unpack()[axis]));
            }
        }
    }
}

TEST(OctahedralNormal, EightUnpackedAtOnceAreThoseOfEachToTheLastBit) {
    std::mt19937 random(6);
    for (int i = 0; i < 500; ++i) {
        std::array<OctahedralNormal, 8> eight;
        for (OctahedralNormal& one : eight) one = OctahedralNormal(randomDirection(random));
        float lanes[3][8];
        OctahedralNormal::unpack(eight).store(lanes);
        for (int lane = 0; lane < 8; ++lane) {
            for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(lanes[axis][lane], eight[lane].unpackSingle()[axis]);
        }
    }
}

TEST(OctahedralNormal, EightAtOnceAreThoseOfEachToAStep) {
    std::mt19937 random(3);
    for (int i = 0; i < 500; ++i) {
        std::array<Vec3, 8> directions;
        float lanes[3][8];
        for (int lane = 0; lane < 8; ++lane) {
            directions[lane] = i == 0 ? Vec3((lane < 4 ? 1 : -1) * Vec3::Unit(lane % 3)) : randomDirection(random);
            for (int axis = 0; axis < 3; ++axis) lanes[axis][lane] = static_cast<float>(directions[lane][axis]);
        }
        const auto packed = OctahedralNormal::pack(Vec3x8::load(lanes));
        for (int lane = 0; lane < 8; ++lane) {
            EXPECT_LT((packed[lane].unpack() - directions[lane]).norm(), 6.2e-5);
            if (i == 0) {
                EXPECT_EQ(packed[lane], OctahedralNormal(directions[lane]));
            }
        }
    }
}

TEST(Brick, KnowsTheRemovedNodesOfTheFieldThatItTakesOver) {
    std::mt19937 random(4);
    CutField field = CutField::untouched(0.1);
    for (float& distance : field.cut) distance = static_cast<float>(static_cast<int>(random() % 3) - 1);  // -1, 0 or 1
    Brick brick;
    brick.setRemoved(5);  // of the previous field
    brick.setField(field);
    for (int node = 0; node < kBrickNodes; ++node) {
        const auto [x, y, z] = placeOf(node);
        EXPECT_EQ(brick.removedRow(y, z) >> x & 1U, field.cut[node] < 0 ? 1U : 0U) << node;
    }
}

TEST(BrickAsserts, NodesOutsideTheBrickAreRefused) {
    EXPECT_ASSERT(static_cast<void>(nodeIndex(kBrickSide, 0, 0)));
    EXPECT_ASSERT(static_cast<void>(nodeIndex(0, -1, 0)));
    EXPECT_ASSERT(static_cast<void>(placeOf(kBrickNodes)));
    EXPECT_ASSERT(static_cast<void>(nodeStride(3)));
    NodeBits bits;
    EXPECT_ASSERT(bits.set(-1));
    EXPECT_ASSERT(bits.setRow(0, kBrickSide, 1));
    EXPECT_ASSERT(bits.setRow(0, 0, 0x100));
}

TEST(BrickAsserts, ADirectionIsFiniteAndASpacingPositive) {
    EXPECT_ASSERT(OctahedralNormal(Vec3(0, std::nan(""), 1)));
    EXPECT_ASSERT(static_cast<void>(CutField::untouched(0)));
}

TEST(BrickAsserts, ValidationFindsAWrongDistanceAndAWrongBit) {
    Brick brick;
    brick.setField(CutField::untouched(0.1));
    brick.tooth.fill(-0.1F);
    brick.maxToothDistance = -0.1F;
    brick.toothNormal.fill(OctahedralNormal(Vec3::UnitX()));
    brick.neighbourFraction.fill(0);
    brick.validate(0.1);
    Brick wrong = brick;
    wrong.setRemoved(7);
    EXPECT_ASSERT(wrong.validate(0.1));
    wrong = brick;
    wrong.cut[3] = 1;  // beyond the band
    EXPECT_ASSERT(wrong.validate(0.1));
    wrong = brick;
    wrong.boundary[2][5].place = 1.5F;
    EXPECT_ASSERT(wrong.validate(0.1));
    wrong = brick;
    wrong.maxToothDistance = 0;
    EXPECT_ASSERT(wrong.validate(0.1));
}

}  // namespace
}  // namespace tactooth
