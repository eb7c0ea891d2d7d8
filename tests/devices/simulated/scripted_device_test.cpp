// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/simulated/scripted_device.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

DeviceKeyframe moment(double time, double x, double pedal = 0, std::uint32_t buttons = 0, double turn = 0) {
    return {time, {{Vec3(x, 0, 0), Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ()))}, pedal, buttons, true}};
}

TEST(ScriptedDevice, GoesInAStraightLineFromMomentToMoment) {
    ScriptedDevice device({moment(0, 0), moment(1, 10, 0.5), moment(3, 0, 0, 0, 1.0)});
    EXPECT_EQ(device.read(0).hand.position.x(), 0);
    EXPECT_NEAR(device.read(0.25).hand.position.x(), 2.5, 1e-12);
    EXPECT_NEAR(device.read(0.25).pedal, 0.25, 1e-12);
    const DeviceSample later = device.read(1.5);
    EXPECT_NEAR(later.hand.position.x(), 5, 1e-12);
    EXPECT_NEAR(later.hand.rotation.angularDistance(Quat::Identity()), 0.5, 1e-12);
}

TEST(ScriptedDevice, RestsAtItsLastMoment) {
    ScriptedDevice device({moment(0, 0), moment(1, 10)});
    EXPECT_FALSE(device.finished());
    EXPECT_EQ(device.read(1).hand.position.x(), 10);
    EXPECT_TRUE(device.finished());
    EXPECT_EQ(device.read(100).hand.position.x(), 10);
}

TEST(ScriptedDevice, ButtonsChangeWithTheMomentReached) {
    ScriptedDevice device({moment(0, 0, 0, 0), moment(1, 0, 0, 1), moment(2, 0, 0, 3)});
    EXPECT_EQ(device.read(0.999).buttons, 0U);
    EXPECT_EQ(device.read(0.002).buttons, 1U);
    EXPECT_EQ(device.read(0.9).buttons, 1U);
    EXPECT_EQ(device.read(0.2).buttons, 3U);
}

TEST(ScriptedDevice, TimeBeginsWithTheFirstMoment) {
    ScriptedDevice device({moment(5, 1), moment(6, 2)});
    EXPECT_NEAR(device.read(0.5).hand.position.x(), 1.5, 1e-12);
}

TEST(ScriptedDevice, TwoMomentsAtOneTimeAreAJump) {
    ScriptedDevice device({moment(0, 0), moment(1, 0), moment(1, 7), moment(2, 7)});
    EXPECT_EQ(device.read(0.999).hand.position.x(), 0);
    EXPECT_EQ(device.read(0.001).hand.position.x(), 7);
}

TEST(ScriptedDevice, OpeningStartsTheScriptAnew) {
    ScriptedDevice device({moment(0, 0), moment(1, 10)});
    (void)device.read(2);
    ASSERT_TRUE(device.open());
    EXPECT_FALSE(device.finished());
    EXPECT_NEAR(device.read(0.5).hand.position.x(), 5, 1e-12);
}

TEST(ScriptedDevice, ALossOfTheDeviceCanBeScripted) {
    DeviceKeyframe lost = moment(1, 0);
    lost.sample.connected = false;
    ScriptedDevice device({moment(0, 0), lost, moment(2, 0)});
    EXPECT_TRUE(device.read(0.5).connected);
    EXPECT_FALSE(device.read(1.0).connected);
    EXPECT_TRUE(device.read(1.0).connected);
}

TEST(ScriptedDevice, KeepsTheLastForce) {
    ForceLimits limits;
    limits.rampTime = 0;
    SafetyLimiter limiter(limits);
    ScriptedDevice device({moment(0, 0)});
    device.write(limiter.limit({Vec3(0.1, 0, 0), Vec3::Zero()}, 0.001, true, 0));
    EXPECT_EQ(device.lastForce(), Vec3(0.1, 0, 0));
}

}  // namespace
}  // namespace tactooth
