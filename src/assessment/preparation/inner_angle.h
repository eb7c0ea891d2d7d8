// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// Radius of the ball that rolls in the angles between floor and walls, mm: a larger radius is not distinguished from
/// it.
inline constexpr double kRollingBall = 0.3;

/// Radius of the angles between the floor and the walls of the cut surface, mm: the 5th percentile, of the sharpest
/// ones. At most kRollingBall.
[[nodiscard]] Measured innerAngleRadius(const Preparation& preparation, const CutSurfaces& surfaces);

}  // namespace tactooth
