// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "assessment/preparation/measured.h"
#include "assessment/preparation/preparation.h"

namespace tactooth {

/// How much room a crown preparation leaves over its occlusal or incisal end: from there to the uncut surface along the
/// axis, mm. The end is what faces up within 40 degrees and lies above the middle of the axial wall, without a strip of
/// 0.1 mm along its border.
struct OcclusalReduction {
    Measured least, median;  ///< by area: 5th percentile, and median
};

[[nodiscard]] OcclusalReduction occlusalReduction(const Preparation& preparation, const CutSurfaces& surfaces);

}  // namespace tactooth
