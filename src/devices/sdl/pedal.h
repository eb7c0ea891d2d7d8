// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "devices/sdl/joysticks.h"

namespace tactooth {

/// Which axis or button of which joystick is the foot pedal, and between which values it goes.
struct PedalBinding {
    enum class Kind { None, Axis, Button };

    Kind kind = Kind::None;
    int number = 0;        ///< of the axis or button, from 0
    std::string joystick;  ///< a part of its name; empty: the first that has such an axis or button
    double up = 0;         ///< the axis with the foot off, 0..1 of its whole way
    double down = 1;       ///< and with the pedal pressed fully

    bool operator==(const PedalBinding&) const = default;
};

/// "" (none), "axis:N", "button:N", or these with ":NAME" of the joystick. Fails with a sentence.
[[nodiscard]] Expected<PedalBinding> parsePedal(const std::string& text);
/// As parsePedal takes it; without the calibration.
[[nodiscard]] std::string pedalText(const PedalBinding& choice);

/// How far down the pedal is, 0..1; nothing if it is not plugged in.
[[nodiscard]] std::optional<double> pedalOf(const PedalBinding& choice, std::span<const JoystickState> joysticks);

/// Learns a pedal from what a person does: press it fully once and let it go. It takes what has moved most, and its two
/// ends.
class PedalCalibrator {
public:
    /// What all joysticks do at the moment; the first call is taken as the foot being off. Gives the pedal as soon as
    /// it was down and is up again.
    [[nodiscard]] std::optional<PedalBinding> update(std::span<const JoystickState> joysticks);

private:
    std::vector<JoystickState> first_;
    std::vector<JoystickState> extremes_;
};

}  // namespace tactooth
