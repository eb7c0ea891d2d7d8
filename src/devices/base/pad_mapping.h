// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "devices/base/rate_controller.h"

namespace tactooth {

/// A gamepad with the usual two sticks and triggers at one moment.
struct PadState {
    bool connected = false;
    std::array<double, 2> leftStick{};  ///< -1..1: right, and toward the user (sticks count so)
    std::array<double, 2> rightStick{};
    double leftTrigger = 0;  ///< 0 up .. 1 down
    double rightTrigger = 0;
    bool lift = false;          ///< the shoulder over the trigger that presses the tool down
    std::uint32_t buttons = 0;  ///< bits as in DeviceSample: 0 B (east), 1 A (south), 2 other shoulder, 3 X, 4 Y
};

/// What the hands on the pad want.
struct PadCommand {
    RateCommand rate;
    double pedal = 0;  ///< 0..1
};

/// A stick's value without the slack around its middle, finer near it. Both axes together, so that a stick that is
/// pushed aslant goes aslant.
[[nodiscard]] std::array<double, 2> applyStickDeadZone(const std::array<double, 2>& stick);
/// Likewise for a trigger, from its slack to its end.
[[nodiscard]] double applyTriggerDeadZone(double trigger);

/// Left stick: right, left, away, near. Left trigger presses the tool down, the shoulder over it lifts it. Right stick:
/// leans the tool. Right trigger: the pedal. Left-handed: the other way round.
[[nodiscard]] PadCommand padCommand(const PadState& pad, bool leftHanded);

}  // namespace tactooth
