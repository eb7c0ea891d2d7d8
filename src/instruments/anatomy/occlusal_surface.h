// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/anatomy/posterior_tooth.h"

namespace tactooth {

/// Height of a back tooth's chewing surface over (x, y), without its grooves.
[[nodiscard]] double occlusalHeight(const PosteriorToothPlan& plan, double x, double y);

/// How deep grooves and pits are cut into it at (x, y).
[[nodiscard]] double grooveDepth(const PosteriorToothPlan& plan, double x, double y);

}  // namespace tactooth
