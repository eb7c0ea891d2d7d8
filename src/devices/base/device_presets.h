// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "devices/base/haptic_device.h"

namespace tactooth {

/// A model of haptic device: its performance and its mechanics.
struct DevicePreset {
    std::string_view name;   ///< name on the command line
    std::string_view title;  ///< display name
    double peakForce;        ///< N
    double continuousForce;  ///< N that its motors bear without time limit
    double stiffness;        ///< N/mm: the stiffest wall that it renders stably at 1 kHz
    double inertia;          ///< N*s^2/mm (1e-3 of the mass in kg) at the tip
    double friction;         ///< N, dry friction
    double damping;          ///< N*s/mm
    double encoderStep;      ///< mm at the tip
    int delayTicks;          ///< ticks by which its link delays a force
    Vec3 workspace;          ///< mm
};

/// omni, touch, touch-x, omega, inverse3.
[[nodiscard]] std::span<const DevicePreset> devicePresets();
/// The preset of that name; nullptr if there is none.
[[nodiscard]] const DevicePreset* findDevicePreset(std::string_view name);

/// Limits of the safety limiter for such a device.
///
/// Power: twice the power of a wall of the device's own stiffness that is loaded to the peak force, springs back and
/// moves only the bare arm, F^2 / (2 sqrt(k m)). A hand on the arm slows it down, but may push too: none of the
/// simulated hands reaches more than 1.5 times this power of the bare arm. A reading or a calculation that asks for
/// more than twice is wrong.
[[nodiscard]] ForceLimits limitsOf(const DevicePreset& preset);

/// The same for a device whose driver reports its peak and continuous force, N; the smaller value of each applies. A
/// value that is NaN or not above zero is ignored.
[[nodiscard]] ForceLimits limitsOf(const DevicePreset& preset, double driverPeak, double driverContinuous);

/// Impedance of the hand that holds the pen: a mass on a spring and a damper, whose other end follows the intended
/// path.
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
