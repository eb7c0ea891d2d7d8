// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Plans of the average teeth of the right side; those of the left side are their mirror images.
#pragma once

#include "instruments/anatomy/anterior_tooth.h"
#include "instruments/anatomy/posterior_tooth.h"

namespace tactooth {

[[nodiscard]] AnteriorToothPlan upperCentralIncisor();
[[nodiscard]] AnteriorToothPlan upperLateralIncisor();
[[nodiscard]] AnteriorToothPlan upperCanine();
[[nodiscard]] PosteriorToothPlan upperFirstPremolar();
[[nodiscard]] PosteriorToothPlan upperSecondPremolar();
[[nodiscard]] PosteriorToothPlan upperFirstMolar();
[[nodiscard]] PosteriorToothPlan upperSecondMolar();
[[nodiscard]] PosteriorToothPlan upperThirdMolar();
[[nodiscard]] AnteriorToothPlan lowerCentralIncisor();
[[nodiscard]] AnteriorToothPlan lowerLateralIncisor();
[[nodiscard]] AnteriorToothPlan lowerCanine();
[[nodiscard]] PosteriorToothPlan lowerFirstPremolar();
[[nodiscard]] PosteriorToothPlan lowerSecondPremolar();
[[nodiscard]] PosteriorToothPlan lowerFirstMolar();
[[nodiscard]] PosteriorToothPlan lowerSecondMolar();
[[nodiscard]] PosteriorToothPlan lowerThirdMolar();

}  // namespace tactooth
