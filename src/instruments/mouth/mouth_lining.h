// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/pose.h"
#include "instruments/mouth/neck_curve.h"
#include "instruments/mouth/zoned_mesh.h"

namespace tactooth {

/// The inner side of cheeks and lips, held open by a ring, and what ends the mouth behind. Mouth frame.
class MouthLining {
public:
    /// `lower` is in the frame of the closed mouth; `lowerJaw` opens it.
    MouthLining(const NeckCurve& upper, const NeckCurve& lower, const Pose& lowerJaw);

    /// One side, from the vestibules over the cheek to the edge of the lips. Open; its front faces point into the
    /// mouth.
    [[nodiscard]] ZonedMesh cheek(bool isLeft) const;
    /// The edge of the lips and the skin around them. Open; its front faces point out of the mouth.
    [[nodiscard]] ZonedMesh lips() const;
    /// The soft palate, the folds beside it and the back of the throat. Open; its front faces point forward.
    [[nodiscard]] ZonedMesh throat() const;
    /// The ring that holds the lips, closed.
    [[nodiscard]] ZonedMesh retractor() const;

private:
    /// Where the lining begins at a jaw.
    struct Root {
        Vec3 point;    ///< within the gingiva
        Vec3 outward;  ///< unit, to the cheek
        Vec3 away;     ///< unit, to the bottom of the vestibule
    };
    /// A place of the edge of the lips.
    struct Rim {
        Vec3 middle;  ///< of the round edge
        Vec3 aside;   ///< unit, from the middle of the opening
        double radius;
    };
    // `turn` goes once around the mouth, 0..1: from the upper midline over the patient's right to the lower midline.
    [[nodiscard]] Root rootAt(double turn) const;
    [[nodiscard]] Rim rimAt(double turn) const;
    [[nodiscard]] Vec3 onLip(const Rim& rim, double angle) const;
    [[nodiscard]] Vec3 isthmusAt(double turn) const;

    const NeckCurve &upper_, &lower_;
    Pose lowerJaw_;
    Vec3 centre_;   // of the opening between the lips
    Vec3 forward_;  // unit, out of the mouth
};

}  // namespace tactooth
