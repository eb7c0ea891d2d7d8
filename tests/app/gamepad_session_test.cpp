// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "devices/open_device.h"
#include "devices/virtual_pad.h"
#include "session/model/session_model.h"

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

bool stepUntil(SessionModel& model, const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < end) {
        (void)model.step(0.01);
        if (condition()) return true;
        std::this_thread::yield();
    }
    return false;
}

TEST(GamepadSession, AGamepadTouchesAndCutsTheToothAndRumbles) {
    auto tooth = makeSessionTooth(kBuiltinTeeth[1]);
    auto bur = makeSessionBur(*findBur("4"));
    ASSERT_TRUE(tooth && bur);
    NoSound sound;
    SessionModel model(sound);
    model.install(std::move(*tooth));
    model.install(std::move(*bur));
    const auto soon = [&](const std::function<bool()>& condition) { return stepUntil(model, condition); };
    test::VirtualPad pad("Test Pad");
    auto device = openDevice("gamepad");
    ASSERT_TRUE(device);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, 0.6);
    model.install(DeviceSlot::First, std::move(*device));
    const auto& newest = model.log().newest();
    EXPECT_TRUE(soon([&] { return newest.contacts > 0 && newest.wrench.force.norm() > 1; }));
    EXPECT_TRUE(soon([&] { return pad.slowMotor() > 0.3; })) << "contact is felt";
    EXPECT_EQ(total(model.simulator()->removed()), 0);
    pad.button(SDL_CONTROLLER_BUTTON_A, true);
    pad.axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 1);
    pad.forgetMotors();
    EXPECT_TRUE(soon([&] { return newest.cutting && total(model.simulator()->removed()) > 0.005; }));
    EXPECT_TRUE(soon([&] { return pad.strongestQuick() > 0.1; })) << "cutting is felt";
}

}  // namespace
}  // namespace tactooth
