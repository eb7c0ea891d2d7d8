// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "instruments/anatomy/deviation.h"
#include "instruments/anatomy/posterior_tooth.h"

namespace tactooth {

/// Curves the roots below their trunk, more and more toward the apex, with their canals. `swing`: rootSwing of
/// the mouth.
void curveRoots(PosteriorToothPlan& plan, const RootSwing& swing, std::mt19937& random);

}  // namespace tactooth
