// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tactooth {

/// How the position of the foot pedal sets the target speed of the drive.
enum class PedalCurve {
    Air,      ///< the pedal throttles the air: speed grows as the root of the pressure above a dead band
    Electric  ///< speed grows linearly from a lowest speed
};

/// The drive that turns the bur: a torque that falls linearly with speed between limits. Torque in N*mm.
struct SpindlePreset {
    std::string name;          ///< name to show
    double freeSpeedRpm = 0;   ///< without load, pedal down
    double stallTorque = 0;    ///< largest driving torque
    double brakeTorque = 0;    ///< largest braking torque, when the bur turns faster than the pedal asks
    double droopRpm = 0;       ///< speed lost from no load to the largest torque; the free speed for a turbine
    double inertia = 0;        ///< rotor and bur, N*mm*s^2 (1 kg*m^2 = 1000 N*mm*s^2)
    double pedalDeadBand = 0;  ///< share of the pedal's travel that does nothing
    double minSpeedRpm = 0;    ///< electric: speed just above the dead band
    PedalCurve pedalCurve = PedalCurve::Air;
};

/// The state of the drive.
struct SpindleState {
    double speedRpm = 0;  ///< never negative
};

/// Air turbine, electric 1:5, low-speed contra-angle; the first is the default.
[[nodiscard]] const std::vector<SpindlePreset>& spindlePresets();

/// The target speed of the drive without load, rev/min. `pedal`: 0 up .. 1 down.
[[nodiscard]] double targetSpeedRpm(const SpindlePreset& preset, double pedal);

/// Torque of the drive at this speed and pedal, N*mm; negative where it brakes.
[[nodiscard]] double driveTorque(const SpindlePreset& preset, double speedRpm, double pedal);

/// The state `dt` seconds later, exact for pedal and load held constant meanwhile. `loadTorque` (N*mm, not negative)
/// resists the rotation and cannot turn the bur backwards. Pure; neither allocates nor fails.
[[nodiscard]] SpindleState stepSpindle(const SpindlePreset& preset, SpindleState state, double pedal, double loadTorque,
                                       double dt);

}  // namespace tactooth
