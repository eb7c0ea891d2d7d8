// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// Undercut of the cut surface for an insertion along the axis.
struct Undercut {
    Measured area;      ///< mm^2 that face away from the axis by more than a degree, or that something hangs over
    Measured bestArea;  ///< the least such area of all directions within 10 degrees of the axis, a degree apart, mm^2
    Measured scanArea;  ///< as `area`, with two degrees: the noise of a scanner makes false undercuts of one
    Measured depth;     ///< greatest level distance from a wall to the end of what hangs over it, mm
};

[[nodiscard]] Undercut undercut(const Preparation& preparation, const CutSurfaces& surfaces);

}  // namespace tactooth
