// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/session_model.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "app/slow_device.h"
#include "devices/open_device.h"
#include "devices/scripted_device.h"
#include "devices/virtual_pad.h"

namespace tactooth {
namespace {

class NoSound final : public SoundOutput {
public:
    void publish(const DrillSoundState&) override {}
    void setMixer(const SoundMixer&) override {}
    void setPlacement(const SoundPlacement&) override {}
    void setHeadphones(bool) override {}
    void setKit(std::shared_ptr<const SoundKit>) override {}
    [[nodiscard]] SoundStatus status() const override { return SoundStatus::Silent; }
};

/// A device whose hand stands at one place of its room.
class StillDevice final : public HapticDevice {
public:
    StillDevice(const Vec3& room, const std::optional<Vec3>& workspaceCentre, const Vec3& hand) : hand_(hand) {
        info_.workspace = room;
        info_.workspaceCentre = workspaceCentre;
    }
    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] DeviceSample read(double) override { return {.hand = {hand_, Quat::Identity()}}; }
    void write(const SafeWrench&) override {}

private:
    DeviceInfo info_;
    Vec3 hand_;
};

/// A bench with the built-in incisor and a round bur.
class SessionModelTest : public ::testing::Test {
protected:
    void SetUp() override {
        auto tooth = makeSessionTooth(kBuiltinTeeth[1]);
        auto bur = makeSessionBur(*findBur("4"));
        ASSERT_TRUE(tooth && bur);
        model_.install(std::move(*tooth));
        model_.install(std::move(*bur));
        (void)model_.step(0);
    }
    bool soon(const std::function<bool()>& condition) {
        for (int i = 0; i < 2000; ++i) {
            (void)model_.step(0.01);
            if (condition()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }
    [[nodiscard]] Vec3 handle() const { return model_.newest().hand.rotation * Vec3::UnitX(); }

    NoSound sound_;
    SessionModel model_{sound_};
};

TEST_F(SessionModelTest, AGamepadTouchesAndCutsTheToothAndRumbles) {
    test::VirtualPad pad("Test Pad");
    auto device = openDevice("gamepad");
    ASSERT_TRUE(device);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 0.6);
    model_.install(std::move(*device));
    EXPECT_TRUE(soon([&] { return model_.newest().contacts > 0 && model_.newest().wrench.force.norm() > 1; }));
    EXPECT_TRUE(soon([&] { return pad.slowMotor() > 0.3; })) << "contact is felt";
    EXPECT_EQ(total(model_.simulator()->removed()), 0);
    pad.button(SDL_CONTROLLER_BUTTON_A, true);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 1);
    pad.forgetMotors();
    EXPECT_TRUE(soon([&] { return model_.newest().cutting && total(model_.simulator()->removed()) > 0.005; }));
    EXPECT_TRUE(soon([&] { return pad.strongestQuick() > 0.1; })) << "cutting is felt";
}

TEST_F(SessionModelTest, AReplayedHandIsWhereItsFileSaysInTheToothsFrame) {
    const Vec3 start(1, 2, 30), end(-1, 0.5, 25);
    std::vector<DeviceKeyframe> way = {{0, {{start, Quat::Identity()}, 0, 0, true}},
                                       {0.3, {{end, Quat::Identity()}, 0, 0, true}}};
    model_.controls.motionScaling = 2;  // of a hand that is replayed there is none
    model_.install(std::make_unique<ScriptedDevice>(std::move(way), "way.csv", true));
    EXPECT_TRUE(soon([&] { return (model_.newest().hand.position - end).norm() < 1e-9; }));
    EXPECT_EQ(model_.newest().hand.rotation.coeffs(), Quat::Identity().coeffs());
}

TEST_F(SessionModelTest, TheScreensChoiceCountsAfterTheButtons) {
    test::VirtualPad pad("Test Pad");
    auto device = openDevice("gamepad");
    ASSERT_TRUE(device);
    model_.install(std::move(*device));
    ASSERT_TRUE(soon([&] { return !model_.ticks().empty(); }));
    pad.button(SDL_CONTROLLER_BUTTON_A, true);
    ASSERT_TRUE(soon([&] { return model_.newest().cutting; }));
    model_.setCutting(false);
    EXPECT_TRUE(soon([&] { return !model_.newest().cutting; }));
    model_.setCutting(true);
    EXPECT_TRUE(soon([&] { return model_.newest().cutting; }));
}

TEST_F(SessionModelTest, ASlowDeviceIsSaidOnceWithHowLongItsTicksTake) {
    model_.install(std::make_unique<test::SlowDevice>());
    int told = 0;
    double slowest = 0;
    const auto step = [&] {
        const SessionModel::StepResult stepResult = model_.step(0.01);
        if (!stepResult.heavyTick) return;
        ++told;
        slowest = *stepResult.heavyTick;
    };
    for (int i = 0; i < 2000 && told == 0; ++i) {
        step();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_GE(slowest, 700);
    for (int i = 0; i < 20; ++i) step();
    EXPECT_EQ(told, 1);
}

TEST_F(SessionModelTest, LeftHandedTheHandleLeavesToTheOtherSide) {
    ASSERT_TRUE(soon([&] { return handle().x() != 0 && !model_.ticks().empty(); }));
    const Vec3 right = handle();
    model_.setLeftHanded(true);
    EXPECT_TRUE(soon([&] { return handle().x() * right.x() < -0.5 && handle().y() * right.y() > 0; }));
}

TEST_F(SessionModelTest, WhatHasNoRoomOfItsOwnDoesNotFit) {
    model_.setAutoScaling(true);
    EXPECT_FALSE(model_.fit()) << "the mouse";
    EXPECT_EQ(model_.motionScaling(), 1);
    model_.install(std::make_unique<StillDevice>(Vec3::Zero(), std::nullopt, Vec3::Zero()));
    EXPECT_FALSE(model_.fit());
    EXPECT_EQ(model_.motionScaling(), 1);
}

/// The incisor's crown and root with 6 mm around them are higher than wide.
TEST_F(SessionModelTest, TheMotionScalingThatFitsIsThatOfTheTightestAxisOfTheTightestDevice) {
    const double height = model_.tooth()->box().sizes().z() + 12;
    model_.setAutoScaling(true);
    model_.controls.motionScaling = 1.3;
    const auto fineIn = [&](double high) {
        model_.install(std::make_unique<StillDevice>(Vec3(1000, 1000, high), std::nullopt, Vec3::Zero()));
        return model_.motionScaling();
    };
    EXPECT_DOUBLE_EQ(fineIn(2 * height), 2);
    EXPECT_DOUBLE_EQ(fineIn(10 * height), 3);
    model_.installSecond(std::make_unique<StillDevice>(Vec3(1000, 1000, 1.5 * height), std::nullopt, Vec3::Zero()));
    EXPECT_DOUBLE_EQ(model_.motionScaling(), 1.5);
    EXPECT_DOUBLE_EQ(fineIn(0.9 * height), 1);
    EXPECT_FALSE(model_.fit()->coversBox);
    model_.setAutoScaling(false);
    EXPECT_EQ(model_.motionScaling(), 1.3);
}

TEST_F(SessionModelTest, AFittedHandInTheMiddleOfItsRoomIsInTheMiddleOfTheTooth) {
    const Box3 box = model_.tooth()->box();
    const Vec3 room = 2 * (box.sizes() + Vec3::Constant(12)).norm() * Vec3::Ones();
    const Vec3 workspaceCentre(5, 20, 150);
    model_.setAutoScaling(true);
    model_.install(std::make_unique<StillDevice>(room, workspaceCentre, workspaceCentre + Vec3(0, 0, 6)));
    ASSERT_TRUE(soon([&] { return !model_.ticks().empty(); }));
    const double motionScaling = model_.motionScaling();
    EXPECT_GE(motionScaling, 2);
    EXPECT_LT((model_.newest().hand.position - box.center() - Vec3(0, 0, 6 / motionScaling)).norm(), 1e-9);
    model_.setAutoScaling(false);
    model_.controls.motionScaling = 1;
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(soon([&] { return !model_.ticks().empty(); }));
    EXPECT_LT((model_.newest().hand.position - box.center() - Vec3(0, 0, 6 / motionScaling)).norm(), 1e-9)
        << "another fineness moves nothing";
}

TEST_F(SessionModelTest, MotionScalingAndClutchAreNotTheMouses) {
    model_.controls.motionScaling = 3;
    model_.controls.clutch = true;
    ASSERT_TRUE(soon([&] { return !model_.ticks().empty(); }));
    EXPECT_TRUE(
        soon([&] { return (model_.newest().hand.position - model_.manipulator().pose().position).norm() < 1e-3; }));
    model_.setLeftHanded(true);  // moves the handle: a clutch would hold it
    EXPECT_TRUE(soon([&] { return handle().dot(model_.manipulator().pose().rotation * Vec3::UnitX()) > 0.999; }));
}

}  // namespace
}  // namespace tactooth
