// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// The closed line along which a preparation meets the uncut surface: the cavosurface margin of a cavity, the finish
/// line of a crown preparation.
struct MarginLine {
    /// RMS distance of the line from itself when it is smoothed over 0.5 mm, mm. The place is where it is greatest.
    Measured roughness;
    /// From the finish line of a crown preparation to the axial wall, square to the axis, mm: median over the length.
    Measured width;
    Measured widthSpread;  ///< standard deviation of it, mm
    /// Of the finish line of a crown preparation above the margin of the gum beside it, along the axis, mm: median over
    /// the length.
    Measured heightAboveGum;
};

[[nodiscard]] MarginLine marginLine(const Preparation& preparation, const CutSurfaces& surfaces);

}  // namespace tactooth
