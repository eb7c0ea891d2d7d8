// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "devices/base/device_presets.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// The task of the hand.
enum class StabilityScenario { Tap, Press, PressToLimit, Cusp, Fissure, Slot, Release, Cut, Tremor };
inline constexpr int kScenarioCount = 9;
/// "tap", "press", "limit", "cusp", "fissure", "slot", "let-go", "cut", "tremor".
[[nodiscard]] std::string_view stabilityScenarioName(StabilityScenario situation);

/// One run of the closed loop: a device, a hand, a material and a task.
struct StabilityCase {
    const DevicePreset* device = nullptr;
    const HandImpedance* hand = nullptr;
    std::optional<MaterialId> material;  ///< none: a spring as stiff as the device's stable stiffness
    StabilityScenario situation = StabilityScenario::Press;
    double rateHz = 1000;
};
/// The materials of the runs: the tissues of a tooth, and nothing for a spring as stiff as the device bears.
[[nodiscard]] std::vector<std::optional<MaterialId>> stabilityMaterials();
/// The material's name, or "stiffest".
[[nodiscard]] std::string_view materialNameOf(const StabilityCase& one);

/// The results of a run. Forces are those sent to the motors.
struct StabilityResult {
    double stiffness = 0;     ///< N/mm, the largest rendered
    double restForce = 0;     ///< N, mean over the last half second, in which the hand tries to rest
    double ripple = 0;        ///< of that force, root mean square over mean; 0 if nothing is touched at rest
    double maxRipple = 0;     ///< limit of `ripple`; higher for a cut and a tremor
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
