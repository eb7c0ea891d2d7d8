// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/sdl/gamepad_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include "haptics/force_pipeline.h"
#include "support/servo_tick.h"
#include "virtual_pad.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using test::VirtualPad;
using ::testing::HasSubstr;

using test::kTick;

/// Runs the device at a thousand ticks a second until `done`; false after a minute.
template <class Done>
bool playUntil(HapticDevice& device, const Done& done, const std::function<void(const DeviceSample&)>& tick = {}) {
    for (int i = 0; i < 60'000; ++i) {
        const DeviceSample sample = device.read(kTick);
        if (tick) tick(sample);
        if (done(sample)) return true;
        std::this_thread::sleep_for(1ms);
    }
    return false;
}

/// A limiter that passes the full force from the first tick on.
SafetyLimiter limiterWithoutRamp() {
    ForceLimits limits;
    limits.rampTime = 0;
    return SafetyLimiter(limits);
}

TEST(GamepadDevice, WithoutOneItSaysWhatToDo) {
    GamepadDevice device("no such pad");
    const auto opened = device.open();
    ASSERT_FALSE(opened);
    EXPECT_THAT(opened.error().message(), HasSubstr("There is no gamepad named 'no such pad': plug one in"));
}

TEST(GamepadDevice, SticksMoveAndLeanTheTool) {
    VirtualPad pad("Test Pad");
    GamepadDevice device("");
    ASSERT_TRUE(device.open());
    EXPECT_EQ(device.info().name, "Test Pad");
    pad.axis(SDL_CONTROLLER_AXIS_LEFTX, 1);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.hand.position.x() > 3; }));
    pad.axis(SDL_CONTROLLER_AXIS_LEFTX, 0);
    pad.axis(SDL_CONTROLLER_AXIS_LEFTY, -1);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.hand.position.y() > 3; }));
    pad.axis(SDL_CONTROLLER_AXIS_LEFTY, 0);
    pad.axis(SDL_CONTROLLER_AXIS_RIGHTX, 1);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return (s.hand.rotation * Vec3::UnitZ()).x() > 0.3; }));
    EXPECT_EQ(device.faultMessage(), nullptr);
}

TEST(GamepadDevice, AShortPressOfAMenuButtonIsNotLost) {
    VirtualPad pad("Test Pad");
    const auto joysticks = SdlJoysticks::shared();
    ASSERT_TRUE(joysticks);
    const auto buttons = [&] {
        for (const JoystickState& each : (*joysticks)->states()) {
            if (each.name == "Test Pad") return each.padButtons;
        }
        return PadButtons();
    };
    const auto presses = [&] { return buttons().presses[static_cast<std::size_t>(PadButton::Start)]; };
    for (unsigned i = 1; i <= 3; ++i) {
        pad.button(SDL_CONTROLLER_BUTTON_START, true);
        for (int k = 0; k < 60'000 && presses() < i; ++k) std::this_thread::sleep_for(1ms);
        EXPECT_TRUE(buttons().isDown(PadButton::Start));
        pad.button(SDL_CONTROLLER_BUTTON_START, false);
        for (int k = 0; k < 60'000 && buttons().isDown(PadButton::Start); ++k) std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(presses(), 3U);
    EXPECT_FALSE(buttons().isDown(PadButton::Start));
}

TEST(GamepadDevice, TheTriggerIsThePedalAndButtonsComeThrough) {
    VirtualPad pad("Test Pad");
    GamepadDevice device("");
    ASSERT_TRUE(device.open());
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, -1);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 0);  // middle of the axis: half pressed
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.pedal > 0.3 && s.pedal < 0.7; }));
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 1);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.pedal == 1; }));
    pad.button(SDL_CONTROLLER_BUTTON_A, true);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.buttons == 2U; }));
    pad.button(SDL_CONTROLLER_BUTTON_A, false);
    pad.button(SDL_CONTROLLER_BUTTON_B, true);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.buttons == 1U; }));
    pad.button(SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, true);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.buttons == 5U; }));
}

TEST(GamepadDevice, PressingOnAToothRumblesAndLettingGoEndsIt) {
    VirtualPad pad("Test Pad");
    GamepadDevice device("");
    ASSERT_TRUE(device.open());
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1);
    ForcePipeline pipeline(device.info().limits);
    const auto onFloor = [&](const DeviceSample& sample) {  // of 1 N/mm, 1 mm below the start
        ForceCommand wanted;
        wanted.hand = sample.hand.position;
        wanted.deflection = std::max(0.0, -1 - sample.hand.position.z());
        wanted.touching = wanted.deflection > 0;
        wanted.stiffness = wanted.touching ? 1 : 0;
        wanted.wrench.force.z() = wanted.deflection;
        device.write(pipeline.pass(wanted, kTick));
    };
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 1);
    EXPECT_TRUE(playUntil(
        device, [&](const DeviceSample&) { return pad.slowMotor() > 0.7; }, onFloor));
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, -1);
    EXPECT_TRUE(playUntil(
        device, [&](const DeviceSample&) { return pad.slowMotor() < 0.02; }, onFloor));
    device.close();
    EXPECT_EQ(pad.slowMotor(), 0);
}

TEST(GamepadDevice, ACuttingBurRunsTheLightMotor) {
    VirtualPad pad("Test Pad");
    GamepadDevice device("");
    ASSERT_TRUE(device.open());
    SafetyLimiter limiter = limiterWithoutRamp();
    int tick = 0;
    const auto vibrate = [&](const DeviceSample&) {
        const Vec3 force(0.06 * std::sin(1.3 * ++tick), 0, 1.5);
        device.write(limiter.limit({force, Vec3::Zero()}, kTick, true, 0));
    };
    EXPECT_TRUE(playUntil(
        device, [&](const DeviceSample&) { return tick > 200 && pad.quickMotor() > 0.3 && pad.slowMotor() > 0.4; },
        vibrate));
}

TEST(GamepadDevice, ASilentServoMeansASilentPad) {
    VirtualPad pad("Test Pad");
    GamepadDevice device("");
    ASSERT_TRUE(device.open());
    SafetyLimiter limiter = limiterWithoutRamp();
    ASSERT_TRUE(playUntil(
        device, [&](const DeviceSample&) { return pad.slowMotor() > 0.5; },
        [&](const DeviceSample&) {
            device.write(limiter.limit({Vec3(0, 0, 2), Vec3::Zero()}, kTick, true, 0));
        }));
    for (int i = 0; i < 6000 && pad.slowMotor() > 0; ++i) std::this_thread::sleep_for(10ms);
    EXPECT_EQ(pad.slowMotor(), 0) << "an order to the motors lasts a tenth of a second";
}

TEST(GamepadDevice, APadThatIsUnpluggedIsLostAndComesBack) {
    auto pad = std::make_unique<VirtualPad>("Test Pad");
    GamepadDevice device("");
    ASSERT_TRUE(device.open());
    pad->axis(SDL_CONTROLLER_AXIS_LEFTX, 1);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.connected && s.hand.position.x() > 1; }));
    pad.reset();
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return !s.connected; }));
    ASSERT_NE(device.faultMessage(), nullptr);
    EXPECT_THAT(device.faultMessage()->in(Language::English), HasSubstr("plug it in again"));
    pad = std::make_unique<VirtualPad>("Test Pad");
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.connected; }));
    EXPECT_EQ(device.faultMessage(), nullptr);
}

TEST(GamepadDevice, ThatRestsTakesNothingForAWish) {
    test::VirtualPad pad("Test Pad");
    GamepadDevice device("");
    ASSERT_TRUE(device.open());
    pad.axis(SDL_CONTROLLER_AXIS_LEFTX, 1);
    pad.button(SDL_CONTROLLER_BUTTON_B, true);
    ASSERT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.buttons == 1 && s.hand.position.x() > 1; }));
    device.suspendInput(true);
    Vec3 place = device.read(kTick).hand.position;
    for (int i = 0; i < 1000; ++i) place = device.read(kTick).hand.position;  // the rate controller needs time to stop
    for (int i = 0; i < 100; ++i) {
        const DeviceSample sample = device.read(kTick);
        ASSERT_EQ(sample.buttons, 0U);
        ASSERT_LT((sample.hand.position - place).norm(), 1e-6);
    }
    device.suspendInput(false);
    EXPECT_TRUE(playUntil(
        device, [&](const DeviceSample& s) { return s.buttons == 1 && s.hand.position.x() > place.x() + 1; }));
}

TEST(GamepadDevice, OneIsChosenByItsNameAndOnlyOneSteers) {
    VirtualPad first("First Pad");
    VirtualPad second("Second Pad");
    GamepadDevice device("Second");
    ASSERT_TRUE(device.open());
    EXPECT_EQ(device.info().name, "Second Pad");
    second.axis(SDL_CONTROLLER_AXIS_LEFTX, 1);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.hand.position.x() > 1; }));
    GamepadDevice other("First");
    EXPECT_FALSE(other.open());
    device.close();
    EXPECT_TRUE(other.open());
}

TEST(GamepadDevice, LeftHandedTheOtherTriggerIsThePedal) {
    VirtualPad pad("Test Pad");
    GamepadDevice device("", true);
    ASSERT_TRUE(device.open());
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 1);
    EXPECT_TRUE(playUntil(device, [](const DeviceSample& s) { return s.pedal == 1; }));
}

}  // namespace
}  // namespace tactooth
