// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/brick.h"

#include <gtest/gtest.h>

#include <random>

namespace tactooth {
namespace {

Vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Vec3(normal(random), normal(random), normal(random)).normalized();
}

TEST(PackedDirection, UnpacksToTheSameDirection) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 direction = randomDirection(random);
        const PackedDirection packed(direction);
        EXPECT_LT((packed.unpack() - direction).norm(), 6e-5);
        EXPECT_LT((packed.unpackSingle().cast<double>() - packed.unpack()).norm(), 2e-7);
    }
}

TEST(PackedDirection, TheAxesAreExact) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            const PackedDirection packed(sign * Vec3::Unit(axis));
            EXPECT_EQ(packed.unpack(), Vec3(sign * Vec3::Unit(axis)));
            EXPECT_EQ(packed.unpackSingle(), Vec3f(static_cast<float>(sign) * Vec3f::Unit(axis)));
        }
    }
}

TEST(PackedDirection, SizesOfFourAreThoseOfEachToTheLastBit) {
    std::mt19937 random(2);
    for (int i = 0; i < 500; ++i) {
        std::array<PackedDirection, 4> four;
        for (PackedDirection& one : four) one = PackedDirection(randomDirection(random));
        const auto sizes = PackedDirection::sizesOf(four);
        for (int lane = 0; lane < 4; ++lane) {
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_EQ(sizes[axis][lane], std::abs(four[lane].unpack()[axis]));
            }
        }
    }
}

}  // namespace
}  // namespace tactooth
