// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/depth_stop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/servo_tick.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::kTick;

Pose at(double x, double z) { return {Vec3(x, 0, z), Quat::Identity()}; }

/// A block of 10 mm with its top at z = 0, and a floor 1 mm below it.
class DepthStopTest : public testing::Test {
protected:
    DepthStopTest() {
        control_.setSurface(std::make_shared<SurfacePart>(test::box(Vec3(-5, -5, -10), Vec3(5, 5, 0))));
        control_.setDepth(1);
    }
    /// Moves the device in a straight line, and returns the tool at its end.
    Pose move(const Pose& from, const Pose& to, double speed) {
        const int ticks = static_cast<int>(std::ceil((to.position - from.position).norm() / (speed * kTick)));
        Pose tool = from;
        for (int i = 0; i <= ticks; ++i) {
            const Vec3 place = from.position + static_cast<double>(i) / ticks * (to.position - from.position);
            tool = stop_.hold({place, from.rotation}, &control_, kTick);
        }
        return tool;
    }

    DepthControl control_;
    DepthStop stop_;
};

TEST_F(DepthStopTest, TheToolStopsAtTheFloorHoweverFastTheHandIs) {
    for (const double speed : {1.0, 20.0, 300.0}) {
        stop_ = {};
        EXPECT_NEAR(move(at(0, 2), at(0, -2.5), speed).position.z(), -1, 1e-9) << speed;
        EXPECT_NEAR(stop_.beyond(), 1.5, 1e-9);
    }
}

TEST_F(DepthStopTest, ASpringAlongTheShaftActsOnTheHand) {
    (void)move(at(0, 2), at(0, -1.8), 20);
    for (int i = 0; i < 3; ++i) (void)stop_.hold(at(0, -1.8), &control_, kTick);
    EXPECT_LT((stop_.force() - 0.8 * DepthStop::kStiffness * Vec3::UnitZ()).norm(), 1e-9);
    (void)stop_.hold(at(0, -1.81), &control_, kTick);  // at 10 mm/s
    EXPECT_NEAR(stop_.force().z(), 0.81 * DepthStop::kStiffness + 10 * DepthStop::kDamping, 1e-9);
}

TEST_F(DepthStopTest, ThereIsNoForceAboveTheFloorAndOnTheWayOut) {
    EXPECT_NEAR(move(at(0, 2), at(0, -0.99), 20).position.z(), -0.99, 1e-12);
    EXPECT_EQ(stop_.force(), Vec3::Zero());
    (void)move(at(0, -0.99), at(0, -2), 20);
    EXPECT_NEAR(move(at(0, -2), at(0, 1), 50).position.z(), 1, 1e-9);
    EXPECT_EQ(stop_.force(), Vec3::Zero());
    EXPECT_EQ(stop_.beyond(), 0);
}

TEST_F(DepthStopTest, AToolThatIsNotThereYetIsPressedALittleBeyondTheFloor) {
    (void)move(at(0, 2), at(0, -2), 20);
    const Vec3 above(0, 0, -0.5), there(0, 0, -1);
    double z = 0;
    for (int i = 0; i < 50; ++i) z = stop_.hold(at(0, -2), &control_, kTick, &above).position.z();
    EXPECT_LT(z, -1.02);
    EXPECT_GT(z, -1.1) << "no more can be cut too deep";
    for (int i = 0; i < 50; ++i) z = stop_.hold(at(0, -2), &control_, kTick, &there).position.z();
    EXPECT_NEAR(z, -1, 1e-9);
}

TEST_F(DepthStopTest, ALeaningShaftIsHeldAlongItself) {
    const Quat leaning(Eigen::AngleAxisd(0.4, Vec3::UnitY()));
    const Vec3 inward = leaning * -Vec3::UnitZ();
    const Pose from{-2 * inward, leaning}, to{3 * inward, leaning};
    const Pose tool = move(from, to, 30);
    EXPECT_LT((tool.position - 1 * inward).norm(), 1e-9);
    EXPECT_LT(stop_.force().cross(inward).norm(), 1e-9);
    EXPECT_LT(stop_.force().dot(inward), 0);
}

TEST_F(DepthStopTest, SwitchedOnInADeepCavityItLiftsTheToolSlowly) {
    (void)stop_.hold(at(0, -4), nullptr, kTick);
    double z = -4;
    int ticks = 0;
    while (z < -1 - 1e-9) {
        const double next = stop_.hold(at(0, -4), &control_, kTick).position.z();
        ASSERT_LT(next - z, 0.02) << "mm in a tick";
        ASSERT_GT(next, z);
        z = next;
        ASSERT_LT(++ticks, 1000);
    }
    EXPECT_GT(ticks, 100);
    EXPECT_NEAR(stop_.force().z(), 3 * DepthStop::kStiffness, 0.02);
}

TEST_F(DepthStopTest, SwitchedOffItLetsTheToolDownSlowly) {
    (void)move(at(0, 2), at(0, -2), 20);
    double z = -1;
    for (int i = 0; i < 200; ++i) {
        const double next = stop_.hold(at(0, -2), nullptr, kTick).position.z();
        EXPECT_LT(z - next, 0.02);
        z = next;
    }
    EXPECT_EQ(z, -2);
    EXPECT_EQ(stop_.force(), Vec3::Zero());
}

TEST_F(DepthStopTest, BesideTheToothNothingStops) {
    EXPECT_EQ(move(at(7, 2), at(7, -4), 20).position.z(), -4);
    EXPECT_EQ(stop_.force(), Vec3::Zero());
}

TEST_F(DepthStopTest, AFloorThatFollowsABallHoldsAToolThatSlidesOnIt) {
    control_.setSurface(std::make_shared<SurfacePart>(test::sphere(Vec3(0, 0, -6), 6, 200, 100)));
    (void)move(at(-3, 1), at(-3, -3.5), 20);
    for (double x = -3; x < 3; x += 0.02) {
        const Pose tool = stop_.hold(at(x, -3.5), &control_, kTick);
        EXPECT_NEAR(tool.position.z(), std::sqrt(36 - x * x) - 7, 0.02) << x;
    }
}

TEST_F(DepthStopTest, APoseThatIsNoneHasNoForceAndIsForgotten) {
    (void)move(at(0, 2), at(0, -2), 20);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(stop_.hold(at(0, nan), &control_, kTick).position.z()));
    EXPECT_EQ(stop_.force(), Vec3::Zero());
    EXPECT_EQ(stop_.beyond(), 0);
    (void)stop_.hold(at(0, -2), &control_, nan);
    EXPECT_EQ(stop_.force(), Vec3::Zero());
}

}  // namespace
}  // namespace tactooth
