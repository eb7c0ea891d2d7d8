// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "instruments/anatomy/deviation.h"
#include "instruments/anatomy/posterior_tooth.h"

namespace tactooth {

/// mm that the apices of all teeth of a mouth move to mesial and to buccal.
struct RootSwing {
    double mesial, buccal;
};

/// Neighbouring roots bend alike, or they would meet. Most bend to distal.
[[nodiscard]] inline RootSwing rootSwing(std::uint32_t seed) {
    constexpr std::uint32_t kMouth = 99;                              // beyond the generators of all teeth
    constexpr double kToMesial = 0.2, kToDistal = 0.7, kAside = 0.3;  // mm, chosen
    std::mt19937 random(seed * 100 + kMouth);
    const double mesial = numberBetween(random, -kToDistal, kToMesial);
    return {mesial, deviation(random, kAside)};
}

/// Curves the roots below their trunk, more and more toward the apex, with their canals. `swing`: rootSwing of
/// the mouth.
void curveRoots(PosteriorToothPlan& plan, const RootSwing& swing, std::mt19937& random);

}  // namespace tactooth
