// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/rate_controller.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;

RateCommand along(const Vec3& speed) { return {speed, Vec3::Zero()}; }

Pose after(RateController& hand, const RateCommand& wanted, double seconds) {
    Pose pose;
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kTick)); ++i) pose = hand.advance(wanted, kTick);
    return pose;
}

/// Pushes down with `speed` on a floor of `stiffness` N/mm for `seconds`; returns the force at the end, N.
double pressOnFloor(RateController& hand, double speed, double stiffness, double seconds) {
    double force = 0;
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kTick)); ++i) {
        const Pose pose = hand.advance(along(Vec3(0, 0, -speed)), kTick);
        force = stiffness * std::max(0.0, -pose.position.z());
        hand.setForce(Vec3(0, 0, force));
    }
    return force;
}

TEST(RateController, GoesAsFastAsIsWanted) {
    RateController hand;
    const double first = after(hand, along(Vec3(10, 0, 0)), 0.5).position.x();
    const double second = after(hand, along(Vec3(10, 0, 0)), 0.5).position.x();
    EXPECT_NEAR(second - first, 5, 1e-6);
    const Vec3 stopped = after(hand, {}, 0.5).position;
    EXPECT_NEAR((after(hand, {}, 0.5).position - stopped).norm(), 0, 1e-6);
}

TEST(RateController, PushingFurtherPressesHarderAndTheForceStaysWithTheStick) {
    RateController light, hard;
    const double lightly = pressOnFloor(light, 8, 1, 2);
    const double strongly = pressOnFloor(hard, 24, 1, 2);
    EXPECT_NEAR(lightly, 1, 0.01);
    EXPECT_NEAR(strongly, 3, 0.03);
    EXPECT_NEAR(pressOnFloor(light, 8, 1, 1), lightly, 1e-6);
}

TEST(RateController, ReleasingTheStickLeavesTheToothSoon) {
    RateController hand;
    ASSERT_GT(pressOnFloor(hand, 24, 1, 2), 2.9);
    EXPECT_LT(pressOnFloor(hand, 0, 1, 1), 0.01);
}

TEST(RateController, DoesNotShakeOnAStiffWallAtASlowRate) {
    RateController hand;
    (void)pressOnFloor(hand, 8, 5, 1);
    double last = 0;
    for (int i = 0; i < 200; ++i) {
        const double force = 5 * std::max(0.0, -hand.advance(along(Vec3(0, 0, -8)), 0.002).position.z());
        hand.setForce(Vec3(0, 0, force));
        if (i > 0) {
            ASSERT_NEAR(force, last, 0.01);
        }
        last = force;
    }
    EXPECT_NEAR(last, 1, 0.02);
}

TEST(RateController, StaysWithinItsReachAndDoesNotStandOnItsHead) {
    RateController hand;
    EXPECT_EQ(after(hand, along(Vec3(25, -25, 25)), 5).position, Vec3(20, -20, 20));
    const Pose leaned = after(hand, {Vec3::Zero(), Vec3(1, 0, 0)}, 5);
    EXPECT_NEAR(std::acos((leaned.rotation * Vec3::UnitZ()).z()), 1.2, 0.01);
    const Pose back = after(hand, {Vec3::Zero(), Vec3(-1, 0, 0)}, 1);
    EXPECT_LT(std::acos((back.rotation * Vec3::UnitZ()).z()), 0.4) << "and comes back";
}

TEST(RateController, TurnsAboutTheDevicesAxes) {
    RateController hand;
    const Pose turned = after(hand, {Vec3::Zero(), Vec3(0, 0, 0.5)}, 2);
    const double angle = Eigen::AngleAxisd(turned.rotation).angle();
    EXPECT_NEAR(angle, 0.5 * (2 - 1 / 40.0), 1e-3) << "less what the smoothing takes";
}

TEST(RateController, TimesThatAreNoneMoveNothing) {
    RateController hand;
    for (const double elapsed : {-1.0, 0.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(hand.advance(along(Vec3(10, 0, 0)), elapsed).position, Vec3::Zero()) << elapsed;
    }
    EXPECT_LT(hand.advance(along(Vec3(10, 0, 0)), 3600).position.x(), 1.01) << "goes on gently after a stall";
}

TEST(RateController, SpeedsThatAreNoNumberAreNoneAndDoNotStay) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        RateController hand;
        for (const RateCommand& rate :
             {RateCommand{Vec3(bad, 0, 0), Vec3::Zero()}, RateCommand{Vec3::Zero(), Vec3(0, bad, 0)}}) {
            EXPECT_EQ(hand.advance(rate, 0.001).position, Vec3::Zero());
        }
        EXPECT_GT(after(hand, along(Vec3(10, 0, 0)), 1).position.x(), 9);
    }
}

}  // namespace
}  // namespace tactooth
