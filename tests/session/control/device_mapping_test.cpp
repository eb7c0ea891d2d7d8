// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/device_mapping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tactooth {
namespace {

constexpr double kRounding = 1e-12;

Pose at(double x, double y, double z, double turn = 0) {
    return {Vec3(x, y, z), Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ()))};
}

DeviceRegistration quarterTurnRegistration() {
    return {at(1, 2, 3), Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()))};
}

void expectNear(const Pose& a, const Pose& b) {
    EXPECT_LT((a.position - b.position).norm(), kRounding);
    EXPECT_LT(a.rotation.angularDistance(b.rotation), 1e-7);
}

TEST(DeviceMapping, WithoutARegistrationToolAndDeviceAreTheSame) {
    DeviceMapping frame;
    const Pose hand = at(0.1, 0.2, 0.3, 0.4);
    EXPECT_EQ(frame.toolFor(hand).position, hand.position);
    EXPECT_EQ(frame.toolFor(hand).rotation.coeffs(), hand.rotation.coeffs());
}

TEST(DeviceMapping, ARegisteredDeviceTakesTheToolWhereItIs) {
    DeviceMapping frame(quarterTurnRegistration());
    expectNear(frame.toolFor(at(100, 50, -30, 0.7)), at(1, 2, 3));
    expectNear(frame.toolFor(at(101, 50, -30, 0.7)), at(1, 3, 3));
    expectNear(frame.toolFor(at(101, 50, -30, 1.7)), at(1, 3, 3, 1));
}

TEST(DeviceMapping, ARegistrationWithADevicePositionPutsTheToolThere) {
    DeviceRegistration registration = quarterTurnRegistration();
    registration.hand = Vec3(100, 50, -30);
    DeviceMapping frame(registration);
    frame.setMotionScaling(2);
    expectNear(frame.toolFor(at(104, 50, -32, 0.7)), at(1, 4, 2));
    expectNear(frame.toolFor(at(100, 50, -30, 0.7)), at(1, 2, 3));
    const Pose before = frame.toolFor(at(104, 50, -30, 0.7));
    frame.setMotionScaling(1);
    expectNear(frame.toolFor(at(104, 50, -30, 0.7)), before);
}

TEST(DeviceMapping, AForceOnTheToolComesBackInTheHandsFrame) {
    DeviceMapping frame(quarterTurnRegistration());
    (void)frame.toolFor(at(0, 0, 0));
    const Wrench onDevice = frame.toDevice({Vec3(0, 1, 2), Vec3(0, 3, 0)});
    EXPECT_LT((onDevice.force - Vec3(1, 0, 2)).norm(), kRounding);
    EXPECT_LT((onDevice.torque - Vec3(3, 0, 0)).norm(), kRounding);
}

TEST(DeviceMapping, FineWorkMovesTheToolAThirdOfTheWayFromWhereItWas) {
    DeviceMapping frame(DeviceRegistration{at(5, 0, 0)});
    (void)frame.toolFor(at(0, 0, 0));
    (void)frame.toolFor(at(2, 0, 0));
    frame.setMotionScaling(3);
    expectNear(frame.toolFor(at(2, 0, 0)), at(7, 0, 0));
    expectNear(frame.toolFor(at(5, 0, 0)), at(8, 0, 0));
    frame.setMotionScaling(std::nan(""));
    EXPECT_EQ(frame.motionScaling(), 1);
    frame.setMotionScaling(-2);
    EXPECT_EQ(frame.motionScaling(), 1);
}

TEST(DeviceMapping, TheClutchHoldsTheToolAndLetsGoWithoutAJump) {
    DeviceMapping frame;
    const Pose before = frame.toolFor(at(0, 0, 1));
    frame.setClutch(true);
    EXPECT_TRUE(frame.isHeld());
    expectNear(frame.toolFor(at(-40, 3, 9, 1)), before);
    frame.setClutch(false);
    expectNear(frame.toolFor(at(-40, 3, 9, 1)), before);
    expectNear(frame.toolFor(at(-40, 3, 8, 1)), at(0, 0, 0));
}

TEST(DeviceMapping, AReadingThatIsNoNumberIsHandedOnAndLeavesNoTrace) {
    DeviceMapping frame(DeviceRegistration{at(1, 1, 1)});
    EXPECT_TRUE(std::isnan(frame.toolFor(at(std::nan(""), 0, 0)).position.x()));
    expectNear(frame.toolFor(at(9, 9, 9)), at(1, 1, 1));
    EXPECT_TRUE(std::isnan(frame.toolFor(at(0, std::nan(""), 0)).position.y()));
    expectNear(frame.toolFor(at(9, 9, 10)), at(1, 1, 2));
}

}  // namespace
}  // namespace tactooth
