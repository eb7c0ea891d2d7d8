// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "instruments/anatomy/tooth_shape.h"

namespace tactooth {

/// The same tooth of another patient: a little larger or smaller, as all teeth of that mouth, with other proportions of
/// crown and roots, and bent, twisted and rounded differently. It is the second step: the tooth comes from the plan of
/// that patient (plan_variation.h), which has other cusps, grooves and roots. Seed 0 changes nothing. Mirror images (16
/// and 26) of one seed stay mirror images.
[[nodiscard]] ToothShape varied(const ToothShape& planned, std::uint32_t seed);

}  // namespace tactooth
