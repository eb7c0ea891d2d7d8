// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "devices/sdl/joysticks.h"

namespace tactooth {

/// The axis or button of a joystick that serves as foot pedal, and the range of its values.
struct PedalBinding {
    enum class Kind { None, Axis, Button };

    Kind kind = Kind::None;
    int number = 0;        ///< index of the axis or button, from 0
    std::string joystick;  ///< a part of its name; empty: the first joystick that has such an axis or button
    double up = 0;         ///< axis value with the foot off, 0..1 of its full travel
    double down = 1;       ///< axis value with the pedal fully pressed

    bool operator==(const PedalBinding&) const = default;
};

/// "" (none), "axis:N", "button:N", or these followed by ":NAME" of the joystick. Fails with a sentence.
[[nodiscard]] Expected<PedalBinding> parsePedal(const std::string& text);
/// The text that parsePedal reads; without the calibration.
[[nodiscard]] std::string pedalText(const PedalBinding& choice);

/// Pedal position, 0 up .. 1 down; no value if the pedal is not plugged in.
[[nodiscard]] std::optional<double> pedalOf(const PedalBinding& choice, std::span<const JoystickState> joysticks);

/// Finds and calibrates a pedal: the user presses it fully once and releases it. Chooses the axis or button that has
/// moved by enough and come back, and records both ends of its travel.
class PedalCalibrator {
public:
    /// Takes the present state of all joysticks; at the first call the foot must be off the pedal. Returns the binding
    /// as soon as the pedal was down and is up again.
    [[nodiscard]] std::optional<PedalBinding> update(std::span<const JoystickState> joysticks);

private:
    std::vector<JoystickState> first_;
    std::vector<JoystickState> extremes_;
};

}  // namespace tactooth
