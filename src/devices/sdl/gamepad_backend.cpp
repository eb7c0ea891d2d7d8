// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/sdl/gamepad_backend.h"

#include "devices/base/messages.h"
#include "devices/sdl/gamepad_device.h"
#include "devices/sdl/joystick_probe.h"

namespace tactooth {
namespace {

constexpr const char* kName = "gamepad";

std::vector<DetectedDevice> probePads() {
    return {probeJoysticks(kName, "gamepad (SDL)", true, capabilitiesOf(GamepadDevice("").info()),
                           std::string(msg::kNoGamepad.english))};
}

std::unique_ptr<HapticDevice> createPad(const DeviceRequest& request) {
    return std::make_unique<GamepadDevice>(request.unit, request.leftHanded);
}

}  // namespace

DeviceBackend gamepadBackend() { return {kName, msg::kGamepad, "NAME", createPad, nullptr, probePads}; }

}  // namespace tactooth
