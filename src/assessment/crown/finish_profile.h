// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// The section of a crown preparation from its finish line up the axial wall, as a bur with a round end makes it: a
/// floor, an arc, and a straight wall that leans inwards. In a plane square to the finish line: x inwards from it, y up
/// along the axis, mm. With an end rounder than the width there is no floor: a chamfer.
class FinishProfile {
public:
    /// `width`: from the finish line to where the wall would meet the floor, mm. `taper`: of the wall to the axis, rad,
    /// positive. `radius`: of the bur's end, mm; 0: a sharp angle.
    FinishProfile(double width, double taper, double radius);

    struct Height {
        double value;   ///< distance above the profile, mm; negative below it
        Vec2 gradient;  ///< unit
    };
    [[nodiscard]] Height above(const Vec2& place) const;

private:
    double taper_, radius_;
    Vec2 centre_;      // of the arc
    Vec2 foot_;        // of the straight wall
    double floorEnd_;  // x
};

}  // namespace tactooth
