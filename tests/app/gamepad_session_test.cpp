// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "devices/open_device.h"
#include "devices/virtual_pad.h"
#include "session/model/model_scene.h"

namespace tactooth {
namespace {

TEST(GamepadSession, AGamepadTouchesAndCutsTheToothAndRumbles) {
    auto tooth = makeSessionTooth(kBuiltinTeeth[1]);
    auto bur = makeSessionBur(*findBur("4"));
    ASSERT_TRUE(tooth && bur);
    test::SpySound sound;
    SessionModel model(sound);
    model.install(std::move(*tooth));
    model.install(std::move(*bur));
    const auto soon = [&](const std::function<bool()>& condition) { return test::stepUntil(model, condition); };
    test::VirtualPad pad("Test Pad");
    auto device = openDeviceInProcess("gamepad", false, 1000);  // where the virtual pad is
    ASSERT_TRUE(device);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 0.6);
    model.install(DeviceSlot::First, std::move(*device));
    const auto& newest = model.log().newest();
    EXPECT_TRUE(soon([&] { return newest.contact.triangles > 0 && newest.force.wrench.force.norm() > 1; }));
    EXPECT_TRUE(soon([&] { return pad.slowMotor() > 0.3; })) << "contact is felt";
    EXPECT_EQ(total(model.runner()->feed().removed()), 0);
    pad.button(SDL_CONTROLLER_BUTTON_A, true);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 1);
    pad.forgetMotors();
    EXPECT_TRUE(soon([&] { return newest.input.cutting && total(model.runner()->feed().removed()) > 0.005; }));
    EXPECT_TRUE(soon([&] { return pad.strongestQuick() > 0.1; })) << "cutting is felt";
}

}  // namespace
}  // namespace tactooth
