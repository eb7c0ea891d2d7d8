// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "devices/base/device_presets.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// What the hand does with the tooth.
enum class StabilityScenario { Tap, Press, PressToLimit, Cusp, Fissure, Slot, Release, Cut, Tremor };
inline constexpr int kScenarioCount = 9;
/// "tap", "press", "limit", "cusp", "fissure", "slot", "let-go", "cut", "tremor".
[[nodiscard]] std::string_view stabilityScenarioName(StabilityScenario situation);

/// A device, a hand, a material and what is done: one run of the closed loop.
struct StabilityCase {
    const DevicePreset* device = nullptr;
    const HandImpedance* hand = nullptr;
    std::optional<MaterialId> material;  ///< none: a spring as stiff as the device's stable stiffness
    StabilityScenario situation = StabilityScenario::Press;
    double rateHz = 1000;
};
/// What the runs touch: the tissues of a tooth, and a spring as stiff as the device bears.
[[nodiscard]] std::vector<std::optional<MaterialId>> stabilityMaterials();
/// The material's name, or "stiffest".
[[nodiscard]] std::string_view materialNameOf(const StabilityCase& one);

/// What the hand has felt. Forces are those that went to the motors.
struct StabilityResult {
    double stiffness = 0;     ///< N/mm, the largest rendered
    double restForce = 0;     ///< N, mean over the last half second, in which the hand wants to rest
    double ripple = 0;        ///< of that force, root mean square over mean; 0 if nothing is touched at rest
    double maxRipple = 0;     ///< that a steady run may have: what a cut and a tremor shake on purpose comes on top
    double minEnergy = 0;     ///< N*mm, of the passivity controller's observer; below zero it is not stable
    double maxForce = 0;      ///< N
    double maxForceRate = 0;  ///< N/ms between two ticks
    bool stable = false;      ///< within all bounds
};

/// Bounds that a stable run keeps.
inline constexpr double kMaxRipple = 0.03;  // of the mean, of a hand and a bur that are still
inline constexpr double kTremor = 0.05;     // mm, root mean square: the top of what is measured on a surgeon's hand
[[nodiscard]] StabilityResult runStability(const StabilityCase& one);

}  // namespace tactooth
