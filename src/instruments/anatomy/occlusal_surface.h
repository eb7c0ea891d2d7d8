// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "instruments/anatomy/posterior_tooth.h"

namespace tactooth {

/// Height of a posterior tooth's occlusal surface over (x, y), without its grooves.
[[nodiscard]] double occlusalHeight(const PosteriorToothPlan& plan, double x, double y);

/// Depth of the grooves and pits in it at (x, y).
[[nodiscard]] double grooveDepth(const PosteriorToothPlan& plan, double x, double y);

}  // namespace tactooth
