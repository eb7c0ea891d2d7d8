// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// J. E. Dyson, B. W. Darvell, "Torque, power and efficiency characterization of dental air turbine handpieces",
// J. Dent. 27 (1999) 573: torque falls almost linearly from stall to free speed; the slope does not depend on the
// supply pressure. An electric motor under speed control is the same line, much steeper, cut off at the motor's limit.
#include "instruments/spindle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"
#include "instruments/messages.h"

namespace tactooth {
namespace {

constexpr double kRadPerSecPerRpm = std::numbers::pi / 30;

/// Loss of torque over speed, N*mm*s.
double slopeOf(const SpindlePreset& preset) { return preset.stallTorque / (preset.droopRpm * kRadPerSecPerRpm); }

/// One interval in which the law of the drive does not change: at its driving limit, on the line, or at its braking
/// limit. Subtracts the time that it uses from `left` (s).
double advance(const SpindlePreset& preset, double speed, double target, double load, double& left) {
    const double slope = slopeOf(preset);
    const double fullDriveBelow = target - preset.stallTorque / slope;
    const double fullBrakeAbove = target + preset.brakeTorque / slope;
    const auto ramp = [&](double torque, double until) {
        const double acceleration = (torque - load) / preset.inertia;
        const double time = (until - speed) / acceleration;
        const bool arrives = time > 0 && time <= left;
        const double taken = arrives ? time : left;
        left -= taken;
        return arrives ? until : speed + acceleration * taken;
    };
    if (speed < fullDriveBelow || (speed == fullDriveBelow && load > preset.stallTorque)) {
        return ramp(preset.stallTorque, load < preset.stallTorque ? fullDriveBelow : 0);
    }
    if (speed > fullBrakeAbove) return ramp(-preset.brakeTorque, fullBrakeAbove);

    const double steady = target - load / slope;
    const double timeConstant = preset.inertia / slope;
    double taken = left;
    double result = steady + (speed - steady) * std::exp(-left / timeConstant);
    const double floor = std::max(fullDriveBelow, 0.0);
    if (result < floor && speed > floor) {
        result = floor;
        taken = std::min(left, timeConstant * std::log((speed - steady) / (floor - steady)));
    }
    left -= taken;
    return result;
}

}  // namespace

const std::vector<SpindlePreset>& spindlePresets() {
    // Turbine: 1.4 N*mm and 400,000 rev/min give the 15 W of a common turbine; 1.3e-8 kg*m^2 of rotor and bur give a
    // time constant of 0.39 s. Electric: 3 N*cm at a 40,000 rev/min motor, geared 1:5 up. Low speed: an air motor with
    // 2 N*cm. Inertias are estimates: no maker publishes them.
    static const std::vector<SpindlePreset> presets = {
        {std::string(msg::kAirTurbine.english), 400000, 1.4, 1.4, 400000, 1.3e-5, 0.10, 0, PedalCurve::Air},
        {std::string(msg::kElectricSpindle.english), 200000, 6.0, 6.0, 4000, 8.0e-5, 0.05, 20000, PedalCurve::Electric},
        {std::string(msg::kLowSpeedSpindle.english), 25000, 20.0, 20.0, 25000, 1.2e-3, 0.10, 0, PedalCurve::Air},
    };
    return presets;
}

double targetSpeedRpm(const SpindlePreset& preset, double pedal) {
    TACTOOTH_ASSERT(preset.pedalDeadBand >= 0 && preset.pedalDeadBand < 1);
    TACTOOTH_ASSERT(std::isfinite(pedal));
    const double travel = (std::clamp(pedal, 0.0, 1.0) - preset.pedalDeadBand) / (1 - preset.pedalDeadBand);
    if (travel <= 0) return 0;
    if (preset.pedalCurve == PedalCurve::Air) return preset.freeSpeedRpm * std::sqrt(travel);
    return std::lerp(preset.minSpeedRpm, preset.freeSpeedRpm, travel);
}

double driveTorque(const SpindlePreset& preset, double speedRpm, double pedal) {
    TACTOOTH_ASSERT(speedRpm >= 0);
    const double lag = (targetSpeedRpm(preset, pedal) - speedRpm) * kRadPerSecPerRpm;
    return std::clamp(slopeOf(preset) * lag, -preset.brakeTorque, preset.stallTorque);
}

SpindleState stepSpindle(const SpindlePreset& preset, SpindleState state, double pedal, double loadTorque, double dt) {
    TACTOOTH_ASSERT(loadTorque >= 0 && dt >= 0);
    TACTOOTH_ASSERT(preset.inertia > 0 && preset.droopRpm > 0 && preset.stallTorque > 0);
    TACTOOTH_ASSERT(std::isfinite(state.speedRpm) && state.speedRpm >= 0);
    const double target = targetSpeedRpm(preset, pedal) * kRadPerSecPerRpm;
    double speed = state.speedRpm * kRadPerSecPerRpm;
    double left = dt;
    constexpr int kStretches = 3;  // braking limit, line, driving limit: each is passed once at most
    for (int stretch = 0; stretch < kStretches && left > 0; ++stretch) {
        speed = std::max(0.0, advance(preset, speed, target, loadTorque, left));
    }
    TACTOOTH_ASSERT(std::isfinite(speed) && speed >= 0);
    return {speed / kRadPerSecPerRpm};
}

}  // namespace tactooth
