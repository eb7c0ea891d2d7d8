// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/depth_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

const Vec3 kDown = -Vec3::UnitZ();

std::shared_ptr<const SurfacePart> partOf(TriangleMesh mesh) { return std::make_shared<SurfacePart>(std::move(mesh)); }

class DepthControlTest : public testing::Test {
protected:
    DepthControlTest() { depth_.setSurface(partOf(test::box(Vec3(-5, -5, -10), Vec3(5, 5, 5)))); }
    DepthControl depth_;
};

TEST_F(DepthControlTest, ADepthIsThatBelowTheUncutSurfaceAlongTheAxis) {
    EXPECT_NEAR(*depth_.depthOf(Vec3(1, 2, 3.5), kDown), 1.5, 1e-9);
    EXPECT_NEAR(*depth_.depthOf(Vec3(1, 2, 6.25), kDown), -1.25, 1e-9);
    EXPECT_NEAR(*depth_.depthOf(Vec3(4.5, 0, 0), -Vec3::UnitX()), 0.5, 1e-9);
    EXPECT_FALSE(depth_.depthOf(Vec3(7, 0, 3), kDown));
}

TEST_F(DepthControlTest, ASlantedAxisCountsAlongItself) {
    const Vec3 inward = Vec3(0.6, 0, -0.8);
    EXPECT_NEAR(*depth_.depthOf(Vec3(0, 0, 5) + 2.5 * inward, inward), 2.5, 1e-9);
}

TEST_F(DepthControlTest, TheFloorIsAsDeepAsWasSet) {
    depth_.setDepth(1.2);
    EXPECT_NEAR(*depth_.toFloor(Vec3(0, 0, 5), kDown), 1.2, 1e-9);
    EXPECT_NEAR(*depth_.toFloor(Vec3(0, 0, 3.5), kDown), -0.3, 1e-9);
    EXPECT_FALSE(depth_.toFloor(Vec3(7, 0, 3), kDown));
}

/// Closed form: a ball of radius 4 whose surface is at sqrt(16 - r^2).
TEST_F(DepthControlTest, AFloorFollowsTheSurfaceOfABall) {
    depth_.setSurface(partOf(test::sphere(Vec3::Zero(), 4, 400, 200)));
    depth_.setDepth(1);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> across(-2, 2);
    for (int i = 0; i < 200; ++i) {
        const double x = across(random), y = across(random);
        const Vec3 tip(x, y, 3);
        const double surface = std::sqrt(16 - x * x - y * y);
        EXPECT_NEAR(*depth_.toFloor(tip, kDown), 1 - (surface - 3), 0.005);
    }
}

TEST_F(DepthControlTest, AFlatFloorCountsFromThePlaceWhereTheCavityWasBegun) {
    depth_.setSurface(partOf(test::sphere(Vec3::Zero(), 4, 400, 200)));
    depth_.setDepth(1);
    depth_.setFloor(CavityFloor::Flat);
    depth_.beginAt(Vec3(0, 0, 6), kDown);
    EXPECT_NEAR(*depth_.toFloor(Vec3(2, 1, 3.5), kDown), 0.5, 0.005);
    EXPECT_NEAR(*depth_.toFloor(Vec3(9, 0, 3.5), kDown), 0.5, 0.005) << "beside the tooth it is the same plane";
    depth_.beginAt(Vec3(0.5, 0, 3.2), kDown);
    EXPECT_NEAR(*depth_.toFloor(Vec3(0, 0, 3), kDown), 0, 0.005) << "the cavity goes on";
    const double lower = std::sqrt(16 - 4.0);
    depth_.beginAt(Vec3(2, 0, 5), kDown);
    EXPECT_NEAR(*depth_.toFloor(Vec3(2, 0, lower), kDown), 1, 0.005) << "another cavity";
}

TEST_F(DepthControlTest, ThePlaceOfAnExerciseStays) {
    depth_.setFloor(CavityFloor::Flat);
    depth_.setDepth(1);
    depth_.setReference(Vec3(0, 0, 4.5));
    depth_.beginAt(Vec3(1, 1, 7), kDown);
    EXPECT_NEAR(*depth_.toFloor(Vec3(1, 1, 4.5), kDown), 1, 1e-12);
    depth_.setReference({});
    depth_.beginAt(Vec3(1, 1, 7), kDown);
    EXPECT_NEAR(*depth_.toFloor(Vec3(1, 1, 5), kDown), 1, 1e-9);
}

TEST_F(DepthControlTest, AnotherToothForgetsThePlaceTheSameOneDoesNot) {
    const auto tooth = partOf(test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
    depth_.setSurface(tooth);
    depth_.setFloor(CavityFloor::Flat);
    depth_.setDepth(1);
    depth_.setReference(Vec3(0, 0, 0.5));
    depth_.setSurface(tooth);
    EXPECT_NEAR(*depth_.toFloor(Vec3(0, 0, 1), kDown), 1.5, 1e-12);
    depth_.setSurface(partOf(test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1))));
    EXPECT_NEAR(*depth_.toFloor(Vec3(0, 0, 1), kDown), 1, 1e-9) << "without a place the floor follows the surface";
}

TEST_F(DepthControlTest, WithoutASurfaceNothingHasADepth) {
    depth_.setSurface(nullptr);
    EXPECT_FALSE(depth_.depthOf(Vec3::Zero(), kDown));
    EXPECT_FALSE(depth_.toFloor(Vec3::Zero(), kDown));
    depth_.setFloor(CavityFloor::Flat);
    depth_.beginAt(Vec3::Zero(), kDown);
    EXPECT_FALSE(depth_.toFloor(Vec3::Zero(), kDown));
}

TEST_F(DepthControlTest, TheDepthStaysWithinATooth) {
    depth_.setDepth(-1);
    EXPECT_EQ(depth_.depth(), 0);
    depth_.setDepth(100);
    EXPECT_EQ(depth_.depth(), DepthControl::kMaxDepth);
}

}  // namespace
}  // namespace tactooth
