// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/device_slots.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "devices/simulated/scripted_device.h"
#include "model/model_scene.h"
#include "session/hands/instrument_poses.h"

namespace tactooth {
namespace {

using test::StillDevice;

const Pose kStart{Vec3(1, 2, 3), Quat::Identity()};
const Box3 kWorkspace(Vec3(-2, -4, -8), Vec3(2, 4, 8));  // 4 x 8 x 16 mm

std::unique_ptr<HapticDevice> deviceWith(const Vec3& workspace, const std::optional<Vec3>& centre = std::nullopt) {
    return std::make_unique<StillDevice>(workspace, centre, Vec3::Zero());
}

TEST(DeviceSlots, BeginWithTheMouseAndAnEmptySecondHand) {
    DeviceSlots slots(kStart);
    EXPECT_EQ(slots.first(), nullptr);
    EXPECT_EQ(slots.second(), nullptr);
    EXPECT_EQ(slots.active().read(0.001).hand.position, kStart.position);
}

TEST(DeviceSlots, TheFirstDeviceMovesTheToolInsteadOfTheMouse) {
    DeviceSlots slots(kStart);
    auto device = test::unboundedDevice();
    const HapticDevice* const wanted = device.get();
    slots.set(DeviceSlot::First, std::move(device));
    EXPECT_EQ(&slots.active(), wanted);
    slots.set(DeviceSlot::First, nullptr);
    EXPECT_NE(&slots.active(), wanted);
    EXPECT_EQ(slots.first(), nullptr);
}

TEST(DeviceSlots, TheSecondDeviceLeavesTheToolToTheMouse) {
    DeviceSlots slots(kStart);
    slots.set(DeviceSlot::Second, test::unboundedDevice());
    EXPECT_NE(slots.second(), nullptr);
    EXPECT_NE(&slots.active(), slots.second());
    EXPECT_EQ(slots.first(), nullptr);
}

TEST(DeviceSlots, OnlyTheFirstDeviceIsSuspended) {
    DeviceSlots slots(kStart);
    slots.suspendInput(true);  // no device: nothing happens
    auto first = test::unboundedDevice(), second = test::unboundedDevice();
    const StillDevice &one = *first, &other = *second;
    slots.set(DeviceSlot::First, std::move(first));
    slots.set(DeviceSlot::Second, std::move(second));
    slots.suspendInput(true);
    EXPECT_TRUE(one.isSuspended());
    EXPECT_FALSE(other.isSuspended());
    slots.suspendInput(false);
    EXPECT_FALSE(one.isSuspended());
}

const Message kFirstFault = Message::verbatim("the cable is loose.");
const Message kSecondFault = Message::verbatim("the motor is warm.");

TEST(DeviceSlots, AFaultIsReportedOnceAndSoIsItsEnd) {
    DeviceSlots slots(kStart);
    auto device = test::unboundedDevice();
    StillDevice& hand = *device;
    slots.set(DeviceSlot::First, std::move(device));
    EXPECT_FALSE(slots.changedFault());
    hand.setFault(&kFirstFault);
    const auto fault = slots.changedFault();
    ASSERT_TRUE(fault);
    EXPECT_EQ(*fault, &kFirstFault);
    EXPECT_FALSE(slots.changedFault());
    hand.setFault(nullptr);
    const auto end = slots.changedFault();
    ASSERT_TRUE(end);
    EXPECT_EQ(*end, nullptr);
}

TEST(DeviceSlots, TheFaultOfTheFirstDeviceComesBeforeThatOfTheSecond) {
    DeviceSlots slots(kStart);
    auto first = test::unboundedDevice(), second = test::unboundedDevice();
    StillDevice& one = *first;
    second->setFault(&kSecondFault);
    slots.set(DeviceSlot::Second, std::move(second));
    EXPECT_EQ(slots.changedFault().value(), &kSecondFault);
    one.setFault(&kFirstFault);
    slots.set(DeviceSlot::First, std::move(first));
    EXPECT_EQ(slots.changedFault().value(), &kFirstFault);
    one.setFault(nullptr);
    EXPECT_EQ(slots.changedFault().value(), &kSecondFault);
}

TEST(DeviceSlots, WithoutAFirstDeviceOrABoundedWorkspaceNothingFits) {
    DeviceSlots slots(kStart);
    EXPECT_FALSE(slots.fit(kWorkspace, Quat::Identity()));
    slots.set(DeviceSlot::Second, deviceWith(Vec3(100, 100, 100)));
    EXPECT_FALSE(slots.fit(kWorkspace, Quat::Identity()));
    slots.set(DeviceSlot::Second, nullptr);
    slots.set(DeviceSlot::First, test::unboundedDevice());
    EXPECT_FALSE(slots.fit(kWorkspace, Quat::Identity()));
}

TEST(DeviceSlots, TheTightestAxisDecidesTheMotionScaling) {
    DeviceSlots slots(kStart);
    slots.set(DeviceSlot::First, deviceWith(Vec3(100, 100, 24)));
    EXPECT_DOUBLE_EQ(slots.fit(kWorkspace, Quat::Identity())->motionScaling, 1.5);
    slots.set(DeviceSlot::First, deviceWith(Vec3(8, 100, 100)));
    EXPECT_DOUBLE_EQ(slots.fit(kWorkspace, Quat::Identity())->motionScaling, 2);
}

TEST(DeviceSlots, TheWorkspaceIsTurnedIntoTheDevicesFrame) {
    DeviceSlots slots(kStart);
    slots.set(DeviceSlot::First, deviceWith(Vec3(16, 100, 100)));
    const Quat quarter(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
    EXPECT_DOUBLE_EQ(slots.fit(kWorkspace, quarter)->motionScaling, 2) << "the device's x is the tooth's y, 8 mm";
}

TEST(DeviceSlots, TheTighterOfTwoDevicesDecides) {
    DeviceSlots slots(kStart);
    slots.set(DeviceSlot::First, deviceWith(Vec3(100, 100, 40)));
    slots.set(DeviceSlot::Second, deviceWith(Vec3(100, 100, 12)));
    const auto fit = slots.fit(kWorkspace, Quat::Identity());
    ASSERT_TRUE(fit);
    EXPECT_DOUBLE_EQ(fit->motionScaling, 1);
    EXPECT_FALSE(fit->coversBox);
}

TEST(DeviceSlots, TheMouseAndADeviceInTheToothsFrameAreNotRegistered) {
    DeviceSlots slots(kStart);
    EXPECT_FALSE(slots.registration(kStart, kWorkspace, Quat::Identity(), false));
    slots.set(DeviceSlot::First,
              std::make_unique<ScriptedDevice>(std::vector<DeviceKeyframe>{{0, {}}}, "script", true));
    EXPECT_FALSE(slots.registration(kStart, kWorkspace, Quat::Identity(), true));
}

TEST(DeviceSlots, ADeviceTakesTheToolWhereItIs) {
    DeviceSlots slots(kStart);
    slots.set(DeviceSlot::First, deviceWith(Vec3(100, 100, 100), Vec3(5, 6, 7)));
    const Quat turn(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
    const auto registration = slots.registration(kStart, kWorkspace, turn, false);
    ASSERT_TRUE(registration);
    EXPECT_EQ(registration->tool.position, kStart.position);
    EXPECT_EQ(registration->turn.coeffs(), turn.coeffs());
    EXPECT_FALSE(registration->hand);
}

TEST(DeviceSlots, AFittedDeviceHasTheWorkspaceInItsMiddle) {
    DeviceSlots slots(kStart);
    slots.set(DeviceSlot::First, deviceWith(Vec3(100, 100, 100), Vec3(5, 6, 7)));
    const auto registration = slots.registration(kStart, kWorkspace, Quat::Identity(), true);
    ASSERT_TRUE(registration);
    EXPECT_EQ(registration->tool.position, Vec3(kWorkspace.center()));
    EXPECT_EQ(registration->hand.value(), Vec3(5, 6, 7));
    slots.set(DeviceSlot::First, deviceWith(Vec3(100, 100, 100)));
    EXPECT_FALSE(slots.registration(kStart, kWorkspace, Quat::Identity(), true)->hand) << "its centre is not known";
}

TEST(DeviceRotation, AwayIsTheDirectionInWhichTheDentistLooks) {
    for (const double mesialX : {1.0, -1.0}) {
        const Vec3 away = deviceRotation(mesialX) * Vec3::UnitY();
        const Vec3 toEye = directionToEye(dentistView(mesialX));
        const Vec3 level = Vec3(-toEye.x(), -toEye.y(), 0).normalized();
        EXPECT_LT((away - level).norm(), 1e-12) << mesialX;
        EXPECT_LT((deviceRotation(mesialX) * Vec3::UnitZ() - Vec3::UnitZ()).norm(), 1e-15);
    }
}

TEST(HandWorkspace, IsTheToothWithTheMarginOfTheMouse) {
    const Box3 workspace = handWorkspace(Box3(Vec3(-1, -2, -3), Vec3(1, 2, 3)));
    EXPECT_EQ(workspace.min(), Vec3(-7, -8, -9));
    EXPECT_EQ(workspace.max(), Vec3(7, 8, 9));
}

}  // namespace
}  // namespace tactooth
