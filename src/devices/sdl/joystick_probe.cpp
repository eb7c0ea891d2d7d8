// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/sdl/joystick_probe.h"

#include "devices/sdl/joysticks.h"

namespace tactooth {
namespace {

std::string describe(const JoystickState& joystick) {
    return joystick.name + " (" + std::to_string(joystick.axes.size()) + " axes, " +
           std::to_string(joystick.buttons.size()) + " buttons" + (joystick.rumbles ? ", rumbles" : "") + ")";
}

ProbeResult lookForJoysticks(bool padsOnly, DeviceCapabilities can, const std::string& none) {
    const auto joysticks = SdlJoysticks::shared();
    if (!joysticks) return {DeviceState::Unusable, joysticks.error().message()};
    std::string found;
    for (const JoystickState& joystick : (*joysticks)->states()) {
        if (padsOnly && !joystick.isPad) continue;
        if (found.empty()) can.buttons = static_cast<int>(joystick.buttons.size());
        found += (found.empty() ? "" : "; ") + describe(joystick);
    }
    if (found.empty()) return {DeviceState::NotFound, none};
    return {DeviceState::Ready, found, can};
}

}  // namespace

DetectedDevice probeJoysticks(const std::string& name, const char* backend, bool padsOnly,
                              const DeviceCapabilities& can, const std::string& none) {
    return probeInChild(name, backend, "The library that reads joysticks (SDL 2)",
                        "install the package libsdl2-2.0-0 anew, and use neither gamepad nor joystick until then.",
                        [&] { return lookForJoysticks(padsOnly, can, none); });
}

DetectedDevice probePedals() {
    return probeJoysticks(
        "pedal", "foot pedal (any joystick, SDL)", false, {},
        "There is no joystick or pedal: plug one in; until then the space key and the slider are the pedal.");
}

}  // namespace tactooth
