// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/pad_mapping.h"

#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

constexpr double kStickDeadZone = 0.15;    // fraction of full deflection: worn sticks return to within this value
constexpr double kTriggerDeadZone = 0.04;  // fraction of full travel
constexpr double kStickExponent = 1.6;     // exponent: half the deflection gives a third of the speed, for fine work
constexpr double kFastest = 25;            // mm/s across: crosses a crown of 10 mm in half a second
constexpr double kFastestDown = 25;        // mm/s: a fully pulled trigger presses with 3 N
constexpr double kFastestLift = 30;        // mm/s
constexpr double kFastestLean = 1.2;       // rad/s

/// Fraction of the travel beyond the dead zone, 0..1.
double beyond(double deflection, double deadZone) {
    return std::clamp((deflection - deadZone) / (1 - deadZone), 0.0, 1.0);
}

}  // namespace

std::array<double, 2> applyStickDeadZone(const std::array<double, 2>& stick) {
    const double deflection = std::hypot(stick[0], stick[1]);
    if (!(deflection > kStickDeadZone)) return {};
    const double scale = std::pow(beyond(deflection, kStickDeadZone), kStickExponent) / deflection;
    return {scale * stick[0], scale * stick[1]};
}

double applyTriggerDeadZone(double trigger) { return trigger > 0 ? beyond(trigger, kTriggerDeadZone) : 0; }

PadCommand padCommand(const PadState& pad, bool leftHanded) {
    const auto across = applyStickDeadZone(leftHanded ? pad.rightStick : pad.leftStick);
    const auto lean = applyStickDeadZone(leftHanded ? pad.leftStick : pad.rightStick);
    const double press = applyTriggerDeadZone(leftHanded ? pad.rightTrigger : pad.leftTrigger);
    const double lift = pad.lift ? kFastestLift : 0;
    PadCommand wish;
    wish.rate.speed = Vec3(kFastest * across[0], -kFastest * across[1], lift - kFastestDown * press);
    // A stick pushed to the right tilts the upper end of the shaft to the right: a rotation about +y. Pushed away:
    // about -x.
    wish.rate.turn = kFastestLean * Vec3(lean[1], lean[0], 0);
    wish.pedal = applyTriggerDeadZone(leftHanded ? pad.leftTrigger : pad.rightTrigger);
    return wish;
}

}  // namespace tactooth
