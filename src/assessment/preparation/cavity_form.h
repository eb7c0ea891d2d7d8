// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "assessment/preparation/convergence.h"
#include "assessment/preparation/cut_patch.h"
#include "assessment/preparation/measured.h"

namespace tactooth {

/// The sides of a preparation, in the order of CavityForm::wallAngle.
enum class WallSide { Buccal, Lingual, Mesial, Distal };

/// Floor and walls of a preparation, each without the strip of 0.3 mm along its border, where the angles are round.
struct CavityForm {
    Measured floorDepth;  ///< median along the axis from the uncut surface, mm
    Measured floorDepthMin, floorDepthP5, floorDepthP95, floorDepthMax;  ///< the same: least, percentiles by area, most
    Measured floorFlatness;  ///< RMS distance from the plane of the floor, mm
    Measured floorTilt;      ///< of the normal of that plane from the axis, degrees
    /// Mean angle of each wall to the axis, degrees; positive: the cavity or the stump is narrower at its outer end.
    std::array<Measured, 4> wallAngle;
    Measured tocMesiodistal, tocBuccolingual;  ///< total occlusal convergence of a crown preparation, degrees
    Convergence toc;                           ///< the same round the whole stump
};

[[nodiscard]] CavityForm cavityForm(const Preparation& preparation, const CutSurfaces& surfaces);

}  // namespace tactooth
