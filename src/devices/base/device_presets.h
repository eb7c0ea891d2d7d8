// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "devices/base/haptic_device.h"

namespace tactooth {

/// A kind of haptic device: what it can do and what its mechanics do to the hand.
struct DevicePreset {
    std::string_view name;   ///< on the command line
    std::string_view title;  ///< for people
    double peakForce;        ///< N
    double continuousForce;  ///< N that its motors bear for ever
    double stiffness;        ///< N/mm: the stiffest wall that it renders at 1 kHz without shaking
    double inertia;          ///< N*s^2/mm (1e-3 of its kilograms) at the tip
    double friction;         ///< N, dry
    double damping;          ///< N*s/mm
    double encoderStep;      ///< mm at the tip
    int delayTicks;          ///< that its link holds a force back
    Vec3 workspace;          ///< mm
};

/// Those that OpenHaptics drives or that are like them: omni, touch, touch-x, omega.
[[nodiscard]] std::span<const DevicePreset> penPresets();
/// inverse3.
[[nodiscard]] std::span<const DevicePreset> inverse3Presets();
/// All of them.
[[nodiscard]] std::span<const DevicePreset> devicePresets();
/// The preset of that name; nullptr if there is none.
[[nodiscard]] const DevicePreset* findDevicePreset(std::string_view name);

/// What the safety limiter keeps to for such a device.
///
/// Power: twice the most that a wall of the device's own stiffness, wound up to its peak force, gives when it springs
/// back and moves nothing but the bare arm, F^2 / (2 sqrt(k m)). A hand on the arm makes it slower, but may push on its
/// own account: of the simulated hands none comes to more than 1.5 times. A reading or a sum that asks for more than
/// twice is wrong.
[[nodiscard]] ForceLimits limitsOf(const DevicePreset& preset);

/// The same for one whose driver tells its own peak and continuous force, N: the smaller one of each counts. A number
/// that is none, or not above zero, is no answer.
[[nodiscard]] ForceLimits limitsOf(const DevicePreset& preset, double driverPeak, double driverContinuous);

/// How a hand holds the pen: a mass on a spring and a damper, whose other end goes where the person wants.
struct HandImpedance {
    std::string_view name;
    double mass;       ///< N*s^2/mm
    double damping;    ///< N*s/mm
    double stiffness;  ///< N/mm
};

/// loose, nominal, firm.
[[nodiscard]] std::span<const HandImpedance> handImpedances();
[[nodiscard]] const HandImpedance* findHandImpedance(std::string_view name);

}  // namespace tactooth
