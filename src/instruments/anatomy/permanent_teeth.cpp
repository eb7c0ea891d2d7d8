// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string_view>

#include "geometry/util/assert.h"
#include "instruments/anatomy/plan_variation.h"
#include "instruments/anatomy/tooth_plans.h"
#include "instruments/anatomy/tooth_shape.h"
#include "instruments/anatomy/variation.h"

namespace tactooth {
namespace {

using AnteriorPlans = std::array<AnteriorToothPlan (*)(), 3>;
using PosteriorPlans = std::array<PosteriorToothPlan (*)(), 5>;

constexpr AnteriorPlans kUpperFront = {upperCentralIncisor, upperLateralIncisor, upperCanine};
constexpr AnteriorPlans kLowerFront = {lowerCentralIncisor, lowerLateralIncisor, lowerCanine};
constexpr PosteriorPlans kUpperBack = {upperFirstPremolar, upperSecondPremolar, upperFirstMolar, upperSecondMolar,
                                       upperThirdMolar};
constexpr PosteriorPlans kLowerBack = {lowerFirstPremolar, lowerSecondPremolar, lowerFirstMolar, lowerSecondMolar,
                                       lowerThirdMolar};

/// The tooth of the right side after the plan of this patient. `place`: 1 to 8 from the midline.
ToothShape plannedTooth(bool upper, std::size_t place, std::uint32_t seed) {
    const std::size_t front = kUpperFront.size();
    if (place <= front) return anteriorTooth(variedPlan((upper ? kUpperFront : kLowerFront)[place - 1](), seed));
    return posteriorTooth(variedPlan((upper ? kUpperBack : kLowerBack)[place - front - 1](), seed));
}

}  // namespace

ToothShape toothShape(int fdi, std::uint32_t seed) {
    const int quadrant = fdi / 10, place = fdi % 10;
    TACTOOTH_ASSERT(quadrant >= 1 && quadrant <= 4 && place >= 1 && place <= 8);
    ToothShape shape = plannedTooth(quadrant <= 2, static_cast<std::size_t>(place), seed);
    const bool leftSide = quadrant == 2 || quadrant == 3;
    constexpr std::string_view kRight = "right", kLeft = "left";
    if (leftSide) shape.name.replace(shape.name.find(kRight), kRight.size(), kLeft);
    shape.fdi = fdi;
    return varied(shape, seed);
}

}  // namespace tactooth
