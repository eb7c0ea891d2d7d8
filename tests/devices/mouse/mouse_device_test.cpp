// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/mouse/mouse_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;
constexpr double kFollowRate = 60;  // 1/s

DeviceSample target(double x, double turn = 0) {
    return {{Vec3(x, 0, 0), Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ()))}, 0, 0, true};
}

TEST(MouseDevice, RestsAtItsStart) {
    MouseDevice mouse(Pose{Vec3(1, 2, 3), Quat::Identity()});
    for (int i = 0; i < 100; ++i) EXPECT_EQ(mouse.read(kTick).hand.position, Vec3(1, 2, 3));
    EXPECT_FALSE(mouse.info().rendersForce);
}

TEST(MouseDevice, FollowsAJumpAsACriticallyDampedSpring) {
    MouseDevice mouse{Pose{}};
    mouse.moveTo(target(10));
    for (int i = 1; i <= 200; ++i) {
        const double wt = kFollowRate * kTick * i;
        ASSERT_NEAR(mouse.read(kTick).hand.position.x(), 10 * (1 - (1 + wt) * std::exp(-wt)), 1e-9) << i;
    }
}

TEST(MouseDevice, ThePathDoesNotDependOnTheTicks) {
    MouseDevice fine{Pose{}};
    MouseDevice coarse{Pose{}};
    fine.moveTo(target(5));
    coarse.moveTo(target(5));
    for (int i = 0; i < 39; ++i) (void)fine.read(kTick);
    EXPECT_NEAR(fine.read(kTick).hand.position.x(), coarse.read(40 * kTick).hand.position.x(), 1e-12);
}

TEST(MouseDevice, NeverOvershootsAndArrives) {
    MouseDevice mouse{Pose{}};
    mouse.moveTo(target(10));
    double last = 0;
    for (int i = 0; i < 500; ++i) {
        const double x = mouse.read(kTick).hand.position.x();
        ASSERT_GE(x, last);
        ASSERT_LE(x, 10);
        last = x;
        if (i == 79) {
            EXPECT_GT(x, 9.5);
        }
    }
    EXPECT_NEAR(last, 10, 1e-9);
}

TEST(MouseDevice, StaysCalmWhateverTheTick) {
    MouseDevice mouse{Pose{}};
    mouse.moveTo(target(10, 2));
    for (const double elapsed : {0.0, 1e-9, 5.0, 1000.0}) {
        const Pose hand = mouse.read(elapsed).hand;
        EXPECT_TRUE(hand.position.allFinite());
        EXPECT_LE(hand.position.norm(), 10);
        EXPECT_NEAR(hand.rotation.norm(), 1, 1e-12);
    }
    EXPECT_NEAR(mouse.read(kTick).hand.position.x(), 10, 1e-9);
}

TEST(MouseDevice, TurnsWithTheTarget) {
    MouseDevice mouse{Pose{}};
    mouse.moveTo(target(0, 1.2));
    double left = 1.2;
    for (int i = 0; i < 400; ++i) {
        const double now = mouse.read(kTick).hand.rotation.angularDistance(target(0, 1.2).hand.rotation);
        ASSERT_LE(now, left + 1e-7);
        left = now;
    }
    EXPECT_LT(left, 1e-6);
}

TEST(MouseDevice, PedalAndButtonsComeAtOnce) {
    MouseDevice mouse{Pose{}};
    DeviceSample sample = target(1);
    sample.pedal = 0.7;
    sample.buttons = 2;
    mouse.moveTo(sample);
    EXPECT_EQ(mouse.read(kTick).pedal, 0.7);
    EXPECT_EQ(mouse.read(kTick).buttons, 2U);
}

TEST(MouseDevice, TheWindowMovesItWhileTheServoReads) {
    MouseDevice mouse{Pose{}};
    std::jthread window([&] {
        for (int i = 0; i <= 1000; ++i) mouse.moveTo(target(0.01 * i));
    });
    for (int i = 0; i < 1000; ++i) ASSERT_LE(mouse.read(kTick).hand.position.x(), 10);
    window.join();
    for (int i = 0; i < 500; ++i) (void)mouse.read(kTick);
    EXPECT_NEAR(mouse.read(kTick).hand.position.x(), 10, 1e-6);
}

TEST(MouseDevice, AGoalOrATimeThatIsNoNumberMovesNothingAndDoesNotStay) {
    const double bad = std::nan("");
    MouseDevice mouse{Pose{}};
    mouse.moveTo(target(bad));
    EXPECT_EQ(mouse.read(kTick).hand.position, Vec3::Zero());
    DeviceSample turned = target(0);
    turned.hand.rotation.x() = bad;
    mouse.moveTo(turned);
    EXPECT_TRUE(mouse.read(kTick).hand.rotation.coeffs().allFinite());
    mouse.moveTo(target(10));
    EXPECT_EQ(mouse.read(bad).hand.position, Vec3::Zero());
    for (int i = 0; i < 500; ++i) (void)mouse.read(kTick);
    EXPECT_NEAR(mouse.read(kTick).hand.position.x(), 10, 1e-6);
}

}  // namespace
}  // namespace tactooth
