// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "devices/simulated/scripted_device.h"
#include "hands/pinhole.h"
#include "live/udp_listener.h"
#include "model/session_model_fixture.h"
#include "model/slow_device.h"
#include "session/live/live_stream.h"
#include "support/materials.h"

namespace tactooth {
namespace {

using test::SessionModelTest;
using test::StillDevice;

TEST(SessionModel, HasNoRunnerUntilThereAreAToothAndABur) {
    test::SpySound sound;
    SessionModel model(sound, test::runInline);
    EXPECT_FALSE(model.step(0.01).newRunner);
    model.install(test::blockTooth());
    EXPECT_FALSE(model.step(0.01).newRunner);
    EXPECT_EQ(model.runner(), nullptr);
    model.install(test::flatSessionBur());
    EXPECT_EQ(model.runner(), nullptr) << "before the next step";
    const auto result = model.step(0.01);
    EXPECT_TRUE(result.newRunner && result.newTooth);
    EXPECT_NE(model.runner(), nullptr);
}

TEST(SessionModel, WithoutAToothNothingFitsAndMesialIsAtPlusX) {
    test::SpySound sound;
    SessionModel model(sound, test::runInline);
    EXPECT_FALSE(model.fit());
    EXPECT_EQ(model.mesialX(), 1);
    model.resetTooth();  // nothing happens
    EXPECT_TRUE(model.log().ticks().empty());
}

TEST(SessionModel, IsPreparingFromToothAndBurUntilTheRunnerBegins) {
    test::SpySound sound;
    SessionModel model(sound, test::runInline);
    model.install(test::blockTooth());
    EXPECT_FALSE(model.isPreparing()) << "there is no bur";
    model.install(test::flatSessionBur());
    EXPECT_TRUE(model.isPreparing());
    model.setPaused(true);
    EXPECT_FALSE(model.isPreparing());
    model.setPaused(false);
    EXPECT_TRUE(model.isPreparing());
    (void)model.step(0);
    EXPECT_FALSE(model.isPreparing());
}

TEST_F(SessionModelTest, SendsItsTicksToTheGivenStream) {
    const test::UdpListener listener;
    auto stream = LiveStream::open(listener.url());
    ASSERT_TRUE(stream) << stream.error().message();
    model_.streamTo(std::move(*stream));
    (void)model_.step(0);
    EXPECT_EQ(listener.next().size(), kStreamBytes);
    model_.streamTo(nullptr);
    ASSERT_TRUE(ticksCome());
    while (listener.hasDatagram()) (void)listener.next();
    model_.install(test::flatSessionBur());
    (void)model_.step(0);
    ASSERT_TRUE(ticksCome());
    EXPECT_FALSE(listener.hasDatagram());
}

TEST_F(SessionModelTest, AStepWithoutAChangeKeepsTheRunner) {
    const LiveRunner* const before = model_.runner();
    const auto result = model_.step(0.01);
    EXPECT_FALSE(result.newRunner || result.newTooth);
    EXPECT_EQ(model_.runner(), before);
}

TEST_F(SessionModelTest, AnotherBurStartsARunnerForTheSameTooth) {
    ASSERT_TRUE(ticksCome());
    model_.install(test::flatSessionBur());
    const auto result = model_.step(0.01);
    EXPECT_TRUE(result.newRunner);
    EXPECT_FALSE(result.newTooth);
}

TEST_F(SessionModelTest, AnotherSpindleStartsARunner) {
    const SpindlePreset& spindle = spindlePresets().back();
    model_.setSpindle(spindle);
    EXPECT_TRUE(model_.step(0.01).newRunner);
    EXPECT_EQ(model_.haptics().spindle.name, spindle.name);
}

TEST_F(SessionModelTest, OnlyAnotherRateStartsARunner) {
    model_.setHand({.rate = 1000});
    EXPECT_FALSE(model_.step(0.01).newRunner);
    model_.setHand({.rate = 500});
    EXPECT_TRUE(model_.step(0.01).newRunner);
    EXPECT_EQ(model_.hand().rate, 500);
}

TEST_F(SessionModelTest, StoppingKeepsToothAndBur) {
    model_.stop();
    EXPECT_FALSE(model_.step(0.01).newRunner);
    EXPECT_EQ(model_.runner(), nullptr);
    EXPECT_TRUE(model_.tooth() && model_.bur());
}

TEST_F(SessionModelTest, ACaseBringsItsMaterialsAndItsBur) {
    std::vector<MaterialDefinition> definitions = builtinMaterials().definitions();
    std::ranges::find(definitions, "dentin", &MaterialDefinition::name)->numbers.stiffness = 0.123;
    SessionTooth tooth = test::blockTooth();
    tooth.piece = test::blockOnTheBench(test::kDentin, MaterialRegistry::make(std::move(definitions)));
    tooth.bur = test::flatSessionBur();
    tooth.bur->name = "Bur of the case";
    model_.install(std::move(tooth));
    EXPECT_EQ(model_.haptics().materials[test::kDentin].stiffness, 0.123);
    EXPECT_EQ(model_.bur()->name, "Bur of the case");
    model_.install(test::blockTooth());
    EXPECT_EQ(model_.haptics().materials[test::kDentin].stiffness, MaterialTable()[test::kDentin].stiffness);
    EXPECT_EQ(model_.bur()->name, "Bur of the case") << "it stays in the handpiece";
}

TEST_F(SessionModelTest, ThePressDepthSurvivesAnotherTooth) {
    model_.manipulator().setPressDepth(2.5);
    model_.manipulator().rotateHandle(1);
    model_.install(test::blockTooth(-1));
    EXPECT_EQ(model_.manipulator().pressDepth(), 2.5);
    EXPECT_LT((model_.manipulator().pose().rotation * Vec3::UnitX()).x(), 0) << "a fresh hand, mesial at -x";
}

TEST_F(SessionModelTest, TheToolFollowsTheMouse) {
    ASSERT_TRUE(ticksCome());
    model_.manipulator().rotateHandle(0.7);
    EXPECT_TRUE(soon([&] {
        return model_.log().newest().input.device.rotation.angularDistance(model_.manipulator().pose().rotation) < 1e-3;
    }));
}

TEST_F(SessionModelTest, EmptyingAnEmptySlotChangesNothing) {
    const LiveRunner* const before = model_.runner();
    model_.install(DeviceSlot::First, nullptr);
    model_.install(DeviceSlot::Second, nullptr);
    EXPECT_EQ(model_.runner(), before);
    EXPECT_FALSE(model_.step(0.01).newRunner);
}

TEST_F(SessionModelTest, ADeviceStopsTheRunnerBeforeItReplacesTheOneInUse) {
    for (const DeviceSlot slot : {DeviceSlot::First, DeviceSlot::Second}) {
        installStill(slot);
        EXPECT_EQ(model_.runner(), nullptr);
        EXPECT_TRUE(model_.step(0.01).newRunner);
        model_.install(slot, nullptr);
        EXPECT_EQ(model_.runner(), nullptr);
        EXPECT_TRUE(model_.step(0.01).newRunner);
    }
}

TEST_F(SessionModelTest, AScriptedHandIsWhereItsScriptSaysInTheToothsFrame) {
    const Vec3 start(1, 2, 30), end(-1, 0.5, 25);
    std::vector<DeviceKeyframe> path = {{0, {{start, Quat::Identity()}, 0, 0, true}},
                                        {0.3, {{end, Quat::Identity()}, 0, 0, true}}};
    model_.controls.motionScaling = 2;  // a device in the tooth's frame is not scaled
    model_.install(DeviceSlot::First, std::make_unique<ScriptedDevice>(std::move(path), "path.csv", true));
    EXPECT_TRUE(soon([&] { return (handPlace() - end).norm() < 1e-9; }));
    EXPECT_EQ(model_.log().newest().input.device.rotation.coeffs(), Quat::Identity().coeffs());
    EXPECT_EQ(model_.motionScaling(), 1);
}

TEST_F(SessionModelTest, TheScreensChoiceCountsAfterTheButtons) {
    constexpr std::uint32_t kCutButton = 1U << 1;
    StillDevice& device = installStill(DeviceSlot::First);
    ASSERT_TRUE(ticksCome());
    device.setButtons(kCutButton);
    ASSERT_TRUE(soon([&] { return model_.log().newest().input.cutting; }));
    model_.setCutting(false);
    EXPECT_TRUE(soon([&] { return !model_.log().newest().input.cutting; }));
    model_.setCutting(true);
    EXPECT_TRUE(soon([&] { return model_.log().newest().input.cutting; }));
}

TEST_F(SessionModelTest, WithoutADeviceTheScreenAloneChooses) {
    model_.setCutting(true);
    EXPECT_TRUE(model_.controls.cutting);
    EXPECT_TRUE(soon([&] { return model_.log().newest().input.cutting; }));
    model_.setCutting(false);
    EXPECT_FALSE(model_.controls.cutting);
}

TEST_F(SessionModelTest, ARunnerBeginsWithTheChoiceOfTheScreen) {
    model_.setCutting(true);
    model_.install(test::flatSessionBur());
    double firstTime = -1;
    bool firstCuts = false;
    ASSERT_TRUE(soon([&] {
        if (firstTime < 0 && !model_.log().ticks().empty()) {
            firstTime = model_.log().ticks().front().time;
            firstCuts = model_.log().ticks().front().input.cutting;
        }
        return firstTime >= 0;
    }));
    EXPECT_TRUE(firstCuts);
}

TEST_F(SessionModelTest, AContactIsLoggedAndTheWorkTimed) {
    EXPECT_EQ(model_.log().workSeconds(), 0);
    installHandThatPresses();
    ASSERT_TRUE(soon([&] { return !model_.log().events().all().empty(); }));
    EXPECT_EQ(model_.log().events().all().front().kind, CutEventKind::FirstContact);
    EXPECT_TRUE(soon([&] { return model_.log().workSeconds() > 0.01; }));
}

TEST_F(SessionModelTest, ATurningBurCutsAndAResetPutsItBack) {
    model_.setCutting(true);
    installHandThatPresses();
    ASSERT_TRUE(soon([&] {  // contact, and dentin reached
        return model_.runner() != nullptr && total(model_.runner()->feed().removed()) > 0.01 &&
               model_.log().events().all().size() >= 2;
    }));
    const std::size_t events = model_.log().events().all().size();
    model_.install(DeviceSlot::First, nullptr);
    ASSERT_TRUE(ticksCome());
    EXPECT_EQ(model_.log().events().all().size(), events) << "another runner keeps them";
    model_.resetTooth();
    EXPECT_TRUE(soon([&] { return total(model_.runner()->feed().removed()) == 0; }));
    const auto counts = [&] {
        return std::ranges::count(std::as_const(model_).log().events().all(), false, &CutEvent::isTakenBack);
    };
    EXPECT_TRUE(soon([&] { return counts() == 0; })) << "they are listed, and count no more";
    EXPECT_EQ(model_.log().events().all().size(), events);
    EXPECT_EQ(model_.log().workSeconds(), 0);
    model_.undo();
    EXPECT_TRUE(soon([&] { return total(model_.runner()->feed().removed()) > 0.01; })) << "a reset can be undone";
    EXPECT_TRUE(soon([&] { return counts() == static_cast<std::ptrdiff_t>(events); }));
    model_.redo();
    EXPECT_TRUE(soon([&] { return total(model_.runner()->feed().removed()) == 0; }));
}

TEST_F(SessionModelTest, FromTheReleaseOfTheMouseTheBurTouchesNothingWhileItMayCut) {
    model_.setCutting(true);
    model_.controls.pedal = 1;
    ASSERT_TRUE(ticksCome());
    const test::Pinhole picture;
    const Vec2 pixel = picture.pixelOf(Vec3(0, 0, 0));
    model_.manipulator().aim(picture, pixel, *touchableSurface(model_));
    model_.manipulator().press(picture, pixel);
    ASSERT_TRUE(soon([&] { return total(model_.runner()->feed().removed()) > 0.01; }));
    model_.releaseHand();
    bool hasStopped = false, touches = true, cutsAgain = false;
    int cutting = 0;
    EXPECT_TRUE(soon([&] {
        for (const Tick& tick : model_.log().ticks()) {
            hasStopped |= !tick.input.cutting;
            touches = tick.contact.triangles > 0;
            cutting += hasStopped && touches && tick.input.cutting ? 1 : 0;
            cutsAgain = hasStopped && tick.input.cutting;
        }
        return cutsAgain && !touches;
    }));
    EXPECT_EQ(cutting, 0);
}

/// A hand presses far beyond a floor of 0.03 mm, with the stop, without it, and where it is not allowed.
TEST_F(SessionModelTest, ADeviceStopsAtTheDepthOfTheMouseIfItIsSaidSoAndAllowed) {
    constexpr double kDepth = 0.03;  // mm
    const auto cutDepth = [this](bool on, bool allowed) {
        model_.install(test::blockTooth());
        model_.manipulator().depthControl().setDepth(kDepth);
        model_.aids().setDepthStop(on);
        model_.setExamination(!allowed);
        test::cutBlock(model_);
        const double area = std::numbers::pi * test::kBurRadius * test::kBurRadius;
        return total(model_.runner()->feed().removed()) / area;
    };
    EXPECT_NEAR(cutDepth(true, true), kDepth, 0.01);
    EXPECT_GT(cutDepth(false, true), 2 * kDepth);
    EXPECT_GT(cutDepth(true, false), 2 * kDepth);
}

TEST_F(SessionModelTest, AnotherToothBeginsWithoutEvents) {
    installHandThatPresses();
    ASSERT_TRUE(soon([&] { return !model_.log().events().all().empty(); }));
    model_.install(DeviceSlot::First, nullptr);
    model_.install(test::blockTooth());
    EXPECT_TRUE(model_.step(0).newTooth);
    EXPECT_TRUE(model_.log().events().all().empty());
    EXPECT_EQ(model_.log().workSeconds(), 0);
}

TEST_F(SessionModelTest, TheServoPublishesItsSound) {
    EXPECT_TRUE(soon([&] { return sound_.published() > 3; }));
}

TEST_F(SessionModelTest, WaterIsHeardOnlyWhileItIsOn) {
    model_.setCutting(true);
    model_.controls.pedal = 1;
    EXPECT_TRUE(soon([&] { return sound_.water() > 0; }));
    model_.instruments().setWater(false);
    EXPECT_TRUE(soon([&] { return sound_.water() == 0; }));
}

TEST_F(SessionModelTest, TheBurTurnsInThePictureWhileThePedalIsDown) {
    model_.setCutting(true);
    model_.controls.pedal = 1;
    ASSERT_TRUE(soon([&] { return model_.log().newest().spindle.speedRpm > 1000; }));
    const double before = model_.animation().spin();
    EXPECT_TRUE(soon([&] { return model_.animation().spin() != before; }));
}

TEST_F(SessionModelTest, ASlowDeviceIsReportedOnceWithTheTimeOfItsTicks) {
    model_.install(DeviceSlot::First, std::make_unique<test::SlowDevice>());
    std::vector<double> reports;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (reports.empty() && std::chrono::steady_clock::now() < end) {
        if (const auto result = model_.step(0.01); result.heavyTick) reports.push_back(*result.heavyTick);
        std::this_thread::yield();
    }
    ASSERT_EQ(reports.size(), 1U);
    EXPECT_GE(reports.front(), 700);
    for (int i = 0; i < 20; ++i) EXPECT_FALSE(model_.step(0.01).heavyTick);
}

TEST_F(SessionModelTest, AFaultAndItsEndAreReportedOnce) {
    StillDevice& device = installStill(DeviceSlot::First);
    EXPECT_FALSE(model_.step(0.01).faultMessage);
    const Message loose = Message::verbatim("the cable is loose.");
    device.setFault(&loose);
    const auto fault = model_.step(0.01).faultMessage;
    ASSERT_TRUE(fault);
    EXPECT_EQ(*fault, &loose);
    EXPECT_FALSE(model_.step(0.01).faultMessage);
    device.setFault(nullptr);
    EXPECT_EQ(model_.step(0.01).faultMessage.value(), nullptr);
}

TEST_F(SessionModelTest, LeftHandedTheHandleLeavesToTheOtherSide) {
    ASSERT_TRUE(soon([&] { return handle().x() != 0 && !model_.log().ticks().empty(); }));
    const Vec3 right = handle();
    model_.setHand({.leftHanded = true});
    EXPECT_FALSE(model_.step(0).newRunner) << "the mouse turns the handle";
    EXPECT_TRUE(soon([&] { return handle().x() * right.x() < -0.5 && handle().y() * right.y() > 0; }));
    EXPECT_EQ(handleX(model_), -1);
}

TEST_F(SessionModelTest, ADeviceIsRegisteredAnewForTheOtherHand) {
    installStill(DeviceSlot::First);
    (void)model_.step(0);
    model_.setHand({.leftHanded = true});
    EXPECT_TRUE(model_.step(0).newRunner);
}

TEST_F(SessionModelTest, WhatHasNoBoundedWorkspaceDoesNotFit) {
    model_.setHand({.autoScaling = true});
    EXPECT_FALSE(model_.fit()) << "the mouse";
    EXPECT_EQ(model_.motionScaling(), 1);
    installStill(DeviceSlot::First);
    EXPECT_FALSE(model_.fit());
    EXPECT_EQ(model_.motionScaling(), 1);
}

/// The block is 3 mm in each direction, with 6 mm around it 15 mm.
TEST_F(SessionModelTest, TheFittingMotionScalingIsThatOfTheTightestAxisOfTheTightestDevice) {
    constexpr double kHeight = 15;  // mm
    model_.setHand({.autoScaling = true});
    model_.controls.motionScaling = 1.3;
    const auto scalingIn = [&](double height) {
        installStill(DeviceSlot::First, Vec3(1000, 1000, height));
        return model_.motionScaling();
    };
    EXPECT_DOUBLE_EQ(scalingIn(2 * kHeight), 2);
    EXPECT_DOUBLE_EQ(scalingIn(10 * kHeight), 3);
    installStill(DeviceSlot::Second, Vec3(1000, 1000, 1.5 * kHeight));
    EXPECT_DOUBLE_EQ(model_.motionScaling(), 1.5);
    EXPECT_DOUBLE_EQ(scalingIn(0.9 * kHeight), 1);
    EXPECT_FALSE(model_.fit()->coversBox);
    model_.setHand({});
    EXPECT_EQ(model_.motionScaling(), 1.3);
}

TEST_F(SessionModelTest, AFittedHandInTheMiddleOfItsWorkspaceIsInTheMiddleOfTheTooth) {
    const Box3 box = model_.tooth()->box();
    const Vec3 workspace = 2 * (box.sizes() + Vec3::Constant(12)).norm() * Vec3::Ones();
    const Vec3 centre(5, 20, 150);
    model_.setHand({.autoScaling = true});
    model_.install(DeviceSlot::First, std::make_unique<StillDevice>(workspace, centre, centre + Vec3(0, 0, 6)));
    ASSERT_TRUE(ticksCome());
    const double motionScaling = model_.motionScaling();
    EXPECT_GE(motionScaling, 2);
    const Vec3 expected = box.center() + Vec3(0, 0, 6 / motionScaling);
    EXPECT_LT((handPlace() - expected).norm(), TickInput::kPositionStep) << "the grid of the inputs";
    const Vec3 place = handPlace();
    model_.setHand({});
    model_.controls.motionScaling = 1;
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(ticksCome());
    EXPECT_EQ(handPlace(), place) << "another motion scaling moves nothing";
}

TEST_F(SessionModelTest, MotionScalingAndClutchAreNotForTheMouse) {
    model_.controls.motionScaling = 3;
    model_.controls.clutch = true;
    ASSERT_TRUE(ticksCome());
    EXPECT_TRUE(soon([&] { return (handPlace() - model_.manipulator().pose().position).norm() < 1e-3; }));
    model_.setHand({.leftHanded = true});  // moves the handle: a clutch would hold it
    EXPECT_TRUE(soon([&] { return handle().dot(model_.manipulator().pose().rotation * Vec3::UnitX()) > 0.999; }));
}

TEST_F(SessionModelTest, TheInstrumentsAreThereAfterTheFirstStep) {
    EXPECT_TRUE(model_.instruments().meshes().has_value());
}

TEST_F(SessionModelTest, TheTouchableSurfaceIsThatOfTheTooth) {
    EXPECT_EQ(touchableSurface(model_)->base, model_.runner()->feed().surface()->base);
}

}  // namespace
}  // namespace tactooth
