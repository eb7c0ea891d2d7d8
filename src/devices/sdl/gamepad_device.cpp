// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/sdl/gamepad_device.h"

#include <algorithm>

#include "devices/base/messages.h"

namespace tactooth {
namespace {

constexpr double kFullForce = 3;     // N at which the heavy motor runs at full strength: the largest pressing force
constexpr double kFullShake = 0.08;  // N at which the light motor does: a bur that cuts under 2 N
constexpr double kStiffness = 2;  // N/mm: the rate controller yields 8 mm/s for each N; a stiffer wall is no stronger
const Message kLost(msg::kGamepadUnplugged);

}  // namespace

GamepadDevice::GamepadDevice(std::string name, bool leftHanded) : name_(std::move(name)), leftHanded_(leftHanded) {
    info_.name = "gamepad";
    info_.poseLimits = PoseLimits::unlimited();
    info_.sensesRotation = info_.hasPedal = true;
    info_.buttonCount = 5;
    info_.stiffness = kStiffness;
    info_.workspace = Vec3::Constant(2 * RateController::kReach);
}

GamepadDevice::~GamepadDevice() { close(); }

Expected<void> GamepadDevice::open() {
    close();
    auto joysticks = SdlJoysticks::shared();
    if (!joysticks) return Unexpected{joysticks.error()};
    const std::vector<JoystickState> states = (*joysticks)->states();
    const auto pad = std::ranges::find_if(states, [this](const JoystickState& state) {
        return state.isPad && state.name.find(name_) != std::string::npos;
    });
    if (pad == states.end()) {
        return name_.empty() ? unexpected(msg::kNoGamepad) : unexpected(msg::kNoGamepadNamed, name_);
    }
    PadState atRest;
    atRest.connected = true;
    port_.state.write(atRest);  // the pad is present: it does not count as lost before its first reading
    if (auto fed = (*joysticks)->feed(&port_, name_); !fed) return fed;
    joysticks_ = std::move(*joysticks);
    info_.name = pad->name;
    hand_ = RateController();
    rumbleFilter_ = RumbleFilter();
    return {};
}

void GamepadDevice::close() {
    if (joysticks_ == nullptr) return;
    (void)joysticks_->feed(nullptr, {});
    joysticks_.reset();
}

DeviceSample GamepadDevice::read(double elapsed) {
    elapsed_ = elapsed;
    port_.state.refresh();
    const PadState& pad = port_.state.value();
    lost_.store(!pad.connected, std::memory_order_relaxed);
    const bool atRest = inputSuspended_.load(std::memory_order_relaxed);
    const PadCommand wish = atRest ? PadCommand() : padCommand(pad, leftHanded_);
    DeviceSample sample;
    sample.connected = pad.connected;
    sample.hand = hand_.advance(wish.rate, elapsed);
    sample.pedal = wish.pedal;
    sample.buttons = atRest ? 0 : pad.buttons;
    return sample;
}

void GamepadDevice::write(const SafeWrench& wrench) {
    hand_.setForce(wrench.force());
    rumbleFilter_.add(wrench.force(), elapsed_);
    port_.rumble.write({rumbleFilter_.steady() / kFullForce, rumbleFilter_.vibration() / kFullShake});
}

const Message* GamepadDevice::faultMessage() const {
    return lost_.load(std::memory_order_relaxed) ? &kLost : HapticDevice::faultMessage();
}

}  // namespace tactooth
