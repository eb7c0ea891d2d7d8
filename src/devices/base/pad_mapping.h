// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "devices/base/rate_controller.h"

namespace tactooth {

/// State of a gamepad with two sticks and two triggers at one moment.
struct PadState {
    bool connected = false;
    std::array<double, 2> leftStick{};  ///< -1..1: right, and toward the user (sign convention of sticks)
    std::array<double, 2> rightStick{};
    double leftTrigger = 0;  ///< 0 up .. 1 down
    double rightTrigger = 0;
    bool lift = false;          ///< the shoulder button above the trigger that presses the tool down
    std::uint32_t buttons = 0;  ///< bits as in DeviceSample: 0 B (east), 1 A (south), 2 other shoulder, 3 X, 4 Y
};

/// The motion and the pedal value that the user commands with the pad.
struct PadCommand {
    RateCommand rate;
    double pedal = 0;  ///< 0..1
};

/// Stick value after the dead zone, with finer control near the middle. Scales both axes together, so that the
/// direction of a diagonal deflection is kept.
[[nodiscard]] std::array<double, 2> applyStickDeadZone(const std::array<double, 2>& stick);
/// Trigger value from the end of its dead zone to its full travel.
[[nodiscard]] double applyTriggerDeadZone(double trigger);

/// Left stick: moves the tool right, left, away and near. Left trigger: presses the tool down; the shoulder button
/// above it lifts it. Right stick: tilts the tool. Right trigger: the pedal. `leftHanded` mirrors the assignment.
[[nodiscard]] PadCommand padCommand(const PadState& pad, bool leftHanded);

}  // namespace tactooth
