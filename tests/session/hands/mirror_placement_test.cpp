// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/mirror_placement.h"

#include <gtest/gtest.h>

#include <limits>

#include "hands/pinhole.h"

namespace tactooth {
namespace {

class MirrorPlacementTest : public testing::Test {
protected:
    MirrorPlacementTest() { mirror_.park(kParked); }
    [[nodiscard]] Vec3 normal() const { return mirror_.pose().rotation * Vec3::UnitZ(); }

    const Pose kParked{Vec3(2, -9, 3), Quat(Eigen::AngleAxisd(0.6, Vec3(1, 2, 0.5).normalized()))};
    test::Pinhole picture_;
    MirrorPlacement mirror_;
};

TEST_F(MirrorPlacementTest, WaitsWhereItWasParkedUntilItIsMoved) {
    EXPECT_EQ(mirror_.pose().position, kParked.position);
    const Pose other{Vec3(1, 1, 1), Quat::Identity()};
    mirror_.park(other);
    EXPECT_EQ(mirror_.pose().position, other.position);
    mirror_.approach(picture_, 1);
    const Vec3 held = mirror_.pose().position;
    mirror_.park(kParked);
    EXPECT_EQ(mirror_.pose().position, held) << "a mirror that is held stays";
    mirror_.reset();
    EXPECT_EQ(mirror_.pose().position, kParked.position);
}

TEST_F(MirrorPlacementTest, TheGlassStaysUnderTheMouse) {
    const Vec2 from = picture_.pixelOf(kParked.position);
    for (const Vec2& way : {Vec2(60, 0), Vec2(0, -80), Vec2(-120, 45)}) {
        mirror_.reset();
        mirror_.drag(picture_, from, from + way);
        EXPECT_LT((picture_.pixelOf(mirror_.pose().position) - from - way).norm(), 1e-6);
        EXPECT_TRUE(mirror_.pose().rotation.isApprox(kParked.rotation));
        const Vec3 toEye = picture_.eyeAxes() * Vec3::UnitZ();
        EXPECT_NEAR((mirror_.pose().position - kParked.position).dot(toEye), 0, 1e-9) << "no nearer, no farther";
    }
}

TEST_F(MirrorPlacementTest, TwoHalfMovesAreOneMove) {
    const Vec2 from(480, 410), half(500, 380), to(530, 360);
    mirror_.drag(picture_, from, half);
    mirror_.drag(picture_, half, to);
    const Vec3 inTwo = mirror_.pose().position;
    mirror_.reset();
    mirror_.drag(picture_, from, to);
    EXPECT_LT((mirror_.pose().position - inTwo).norm(), 1e-9);
}

TEST_F(MirrorPlacementTest, TiltTurnsTheGlassToWhereTheMouseGoes) {
    const Vec3 right = picture_.eyeAxes() * Vec3::UnitX();
    const Vec3 up = picture_.eyeAxes() * Vec3::UnitY();
    mirror_.place({kParked.position, Quat(picture_.eyeAxes())});  // it faces the eye
    mirror_.tilt(picture_, Vec2(50, 0));
    EXPECT_GT(normal().dot(right), 0.1);
    EXPECT_NEAR(normal().dot(up), 0, 1e-9);
    mirror_.tilt(picture_, Vec2(-50, 0));
    mirror_.tilt(picture_, Vec2(0, -50));
    EXPECT_GT(normal().dot(up), 0.1);
    EXPECT_EQ(mirror_.pose().position, kParked.position);
}

TEST_F(MirrorPlacementTest, StaysWithinReach) {
    for (int i = 0; i < 100; ++i) mirror_.drag(picture_, Vec2(500, 400), Vec2(900, 100));
    EXPECT_NEAR((mirror_.pose().position - kParked.position).norm(), MirrorPlacement::kReach, 1e-9);
    for (int i = 0; i < 100; ++i) mirror_.approach(picture_, 5);
    EXPECT_LE((mirror_.pose().position - kParked.position).norm(), MirrorPlacement::kReach + 1e-9);
}

TEST_F(MirrorPlacementTest, NumbersThatAreNoneMoveNothing) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    mirror_.drag(picture_, Vec2(nan, 1), Vec2(2, nan));
    mirror_.tilt(picture_, Vec2(nan, 0));
    mirror_.tilt(picture_, Vec2(0, 0));
    mirror_.approach(picture_, nan);
    EXPECT_EQ(mirror_.pose().position, kParked.position);
    EXPECT_TRUE(mirror_.pose().rotation.isApprox(kParked.rotation));
}

}  // namespace
}  // namespace tactooth
