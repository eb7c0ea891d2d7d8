// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/neighbours/neighbour_list.h"
#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

namespace tactooth {

/// What bounds the length of a step.
struct StepLimits {
    double allowance = 0;      ///< how far the tool may be shifted, mm
    double rotationLeft = 0;   ///< how much rotation the neighbour list covers, as a chord
    double rotationBound = 0;  ///< no rotation is longer, rad; with 6 degrees of freedom
};

/// By what a step was shortened.
struct StepClipping {
    bool isClipped = false;         ///< by the allowance or by the neighbour list
    bool isRotationByList = false;  ///< the rotation, since the list ends there; with 3 degrees of freedom
    bool isByList = false;          ///< the rotation or the shift, since the list ends there
};

/// The step that one iteration tries, from the present pose.
struct CandidateStep {
    Pose goal;
    double rotationFraction = 1;  ///< share of the rotation to the goal; with 3 degrees of freedom
    bool rotatesFully = true;     ///< the step ends in the orientation of the goal
    Quat rotation;                ///< at the end of the step
    Mat3 matrix;                  ///< of `rotation`
    Mat3 startMatrix;             ///< of the present orientation
    Vec3 shift = Vec3::Zero();    ///< of the tool's origin, mm
    StepLimits limits;
    StepClipping clipping;

    /// Sets the orientation at the end: a share of the rotation from `from` to the goal.
    void rotateBy(const Quat& from, double fraction) {
        TACTOOTH_ASSERT(fraction >= 0);
        rotationFraction = fraction;
        rotation = fraction <= 0   ? from
                   : fraction >= 1 ? goal.rotation
                                   : from.slerp(fraction, goal.rotation).normalized();
        matrix = rotation.toRotationMatrix();
        startMatrix = from.toRotationMatrix();
    }
    /// The pose at the end of the step.
    [[nodiscard]] Pose end(const Pose& start) const { return {start.position + shift, rotation}; }
};

}  // namespace tactooth
