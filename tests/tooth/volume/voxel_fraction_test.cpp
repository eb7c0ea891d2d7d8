// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/voxel_fraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/expect_assert.h"
#include "tooth/volume/brick.h"

namespace tactooth {
namespace {

Vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Vec3(normal(random), normal(random), normal(random)).normalized();
}

/// The reference: counts the points of a fine grid.
double countedFraction(const HalfSpace& half) {
    constexpr int kSide = 30;
    int inside = 0;
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
        const Vec3 point = (Vec3(i % kSide, i / kSide % kSide, i / (kSide * kSide)) + Vec3::Constant(0.5)) / kSide -
                           Vec3::Constant(0.5);
        inside += half.distance + half.normal.dot(point) < 0;
    }
    return static_cast<double>(inside) / (kSide * kSide * kSide);
}

TEST(VoxelFraction, AxisAlignedPlaneCutsInProportionToItsPlace) {
    EXPECT_NEAR(cubeFraction({0.0, Vec3::UnitX()}), 0.5, 1e-9);
    EXPECT_NEAR(cubeFraction({0.25, Vec3::UnitY()}), 0.25, 1e-3);
    EXPECT_NEAR(cubeFraction({-0.25, -Vec3::UnitZ()}), 0.75, 1e-3);
    EXPECT_EQ(cubeFraction({0.9, Vec3::UnitZ()}), 0.0);
    EXPECT_EQ(cubeFraction({-0.9, Vec3::UnitZ()}), 1.0);
}

TEST(VoxelFraction, RandomPlanesAgreeWithCounting) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> offset(-0.7, 0.7);
    for (int i = 0; i < 50; ++i) {
        const HalfSpace half{offset(random), randomDirection(random)};
        EXPECT_NEAR(cubeFraction(half), countedFraction(half), 5e-3);
    }
}

TEST(VoxelFraction, FourAtOnceAreTheSameNumbers) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> offset(-1, 1);
    int cut = 0;
    for (int i = 0; i < 500; ++i) {
        Eigen::Array4d distances;
        std::array<OctahedralNormal, 4> normals;
        for (int lane = 0; lane < 4; ++lane) {
            distances[lane] = offset(random);
            normals[lane] = OctahedralNormal(i % 7 == 0 ? Vec3::Unit(lane % 3) : randomDirection(random));
        }
        const Eigen::Array4d shares = cubeFractions(distances, OctahedralNormal::absComponentsOf(normals));
        for (int lane = 0; lane < 4; ++lane) {
            ASSERT_EQ(shares[lane], cubeFraction({distances[lane], normals[lane].unpack()}));
            cut += shares[lane] > 0 && shares[lane] < 1;
        }
    }
    EXPECT_GT(cut, 600);
    EXPECT_LT(cut, 1600);
}

TEST(VoxelFraction, TwoPerpendicularPlanesThroughTheCentreLeaveAQuarter) {
    EXPECT_NEAR(cubeFraction({0, Vec3::UnitX()}, {0, Vec3::UnitY()}), 0.25, 1e-9);
}

TEST(VoxelFraction, AHalfSpaceThatHoldsTheCubeDoesNotCount) {
    const HalfSpace half{0.1, Vec3(1, 2, 3).normalized()};
    EXPECT_EQ(cubeFraction(half, {-2, Vec3::UnitX()}), cubeFraction(half));
    EXPECT_EQ(cubeFraction(half, {2, Vec3::UnitX()}), 0.0);
}

TEST(VoxelFractionAsserts, ANormalIsOfUnitLength) {
    EXPECT_ASSERT(static_cast<void>(cubeFraction({0.1, Vec3(1, 1, 1)})));
    EXPECT_ASSERT(static_cast<void>(cubeFraction({std::nan(""), Vec3::UnitX()})));
}

}  // namespace
}  // namespace tactooth
