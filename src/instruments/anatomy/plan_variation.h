// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// The form of another patient's tooth. Traits that come in grades: G. R. Scott, C. G. Turner, "The Anthropology of
// Modern Human Teeth", 1997. Ranges of heights, places and roots: about those of the measured teeth (docs/teeth.md).
// "Chosen" marks a number without a source.
#pragma once

#include <cstdint>

#include "instruments/anatomy/anterior_tooth.h"
#include "instruments/anatomy/posterior_tooth.h"

namespace tactooth {

/// The same tooth of another patient: cusps, ridges and fossae of other heights, grooves of another course, depth and
/// width, an extra or a missing cusp, and curved roots. The crown keeps its length. The seed and the place in the half
/// of the mouth decide, so that both sides are alike. Seed 0 is the average tooth, unchanged.
[[nodiscard]] PosteriorToothPlan variedPlan(const PosteriorToothPlan& average, std::uint32_t seed);

/// The same for an incisor or canine: ridges and fossae of the faces, course and arch of the edge, outline, and the
/// lean of the root.
[[nodiscard]] AnteriorToothPlan variedPlan(const AnteriorToothPlan& average, std::uint32_t seed);

}  // namespace tactooth
