// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/device_presets.h"

#include <algorithm>
#include <array>
#include <cmath>

// Peak and continuous force, inertia, friction, encoder step and workspace are from the makers' data sheets. Stiffness
// is half to four fifths of the nominal value, as virtual couplings are set in practice (0.35-0.5 on a Touch, 0.8-1 on
// a Touch X, 2-3 on an omega; the link of an Inverse3 costs a tick, so it gets less than a Touch X). Damping is 0.5
// N*s/m, the lowest value measured on such arms. Where a maker states no value (inertia and friction of omega and
// Inverse3, encoder step of the Inverse3), the value that oscillates sooner is chosen. Hands: pen grips of 1 to 3 N;
// the stiffness and damping of a hand rise with its grip force (C. Hasser, M. Cutkosky, "System Identification of the
// Human Hand Grasping a Haptic Knob", Haptics Symposium 2002).

namespace tactooth {
namespace {

constexpr double kKilogram = 1e-3;  // N*s^2/mm
constexpr double kPerMetre = 1e-3;  // N*s/m in N*s/mm, N/m in N/mm

const std::array<DevicePreset, 5> kDevices = {{
    {"omni", "PHANToM Omni", 3.3, 0.88, 0.5, 0.045 * kKilogram, 0.26, 0.5 * kPerMetre, 0.055, 0, Vec3(160, 70, 120)},
    {"touch", "Touch", 3.3, 0.88, 0.5, 0.045 * kKilogram, 0.26, 0.5 * kPerMetre, 0.055, 0, Vec3(160, 70, 120)},
    {"touch-x", "Touch X", 7.9, 1.75, 1.0, 0.045 * kKilogram, 0.06, 0.5 * kPerMetre, 0.023, 0, Vec3(160, 120, 120)},
    {"omega", "omega", 12.0, 12.0, 2.5, 0.2 * kKilogram, 0.1, 0.5 * kPerMetre, 0.01, 0, Vec3(160, 160, 110)},
    {"inverse3", "Haply Inverse3", 10.0, 2.5, 0.8, 0.1 * kKilogram, 0.05, 0.5 * kPerMetre, 0.05, 1,
     Vec3(300, 200, 300)},
}};

constexpr std::array<HandImpedance, 3> kHands = {{
    {"loose", 0.05 * kKilogram, 2 * kPerMetre, 175 * kPerMetre},
    {"nominal", 0.15 * kKilogram, 5.5 * kPerMetre, 550 * kPerMetre},
    {"firm", 0.3 * kKilogram, 15 * kPerMetre, 1500 * kPerMetre},
}};

template <class Presets>
auto findNamed(const Presets& presets, std::string_view name) {
    const auto found = std::ranges::find_if(presets, [&](const auto& preset) { return preset.name == name; });
    return found == presets.end() ? nullptr : &*found;
}

}  // namespace

std::span<const DevicePreset> devicePresets() { return kDevices; }
const DevicePreset* findDevicePreset(std::string_view name) { return findNamed(kDevices, name); }

ForceLimits limitsOf(const DevicePreset& preset) {
    ForceLimits limits;
    limits.force = preset.peakForce;
    limits.continuousForce = preset.continuousForce;
    limits.friction = preset.friction;
    const double bareArm = limits.force * limits.force / (2 * std::sqrt(preset.stiffness * preset.inertia));
    limits.power = 2 * bareArm;
    return limits;
}

ForceLimits limitsOf(const DevicePreset& preset, double driverPeak, double driverContinuous) {
    const auto smaller = [](double model, double driver) {
        return driver > 0 && std::isfinite(driver) ? std::min(model, driver) : model;
    };
    DevicePreset bounded = preset;
    bounded.peakForce = smaller(preset.peakForce, driverPeak);
    bounded.continuousForce = std::min(smaller(preset.continuousForce, driverContinuous), bounded.peakForce);
    return limitsOf(bounded);
}

std::span<const HandImpedance> handImpedances() { return kHands; }
const HandImpedance* findHandImpedance(std::string_view name) { return findNamed(kHands, name); }

}  // namespace tactooth
