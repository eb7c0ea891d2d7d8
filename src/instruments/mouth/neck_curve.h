// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/util/pose.h"
#include "instruments/modelling/smooth_curve.h"

namespace tactooth {

/// A smooth curve through the necks of all teeth of a jaw, from the third molar on the patient's left to that on the
/// right. Mouth frame, mouth closed, mm.
class NeckCurve {
public:
    /// `toothInMouth`: the poses of the teeth of one side, from the central incisor to the third molar; the other side
    /// is their mirror image.
    explicit NeckCurve(std::span<const Pose> toothInMouth);

    struct Place {
        Vec3 neck;
        Vec3 outward;  ///< unit, horizontal, to the cheek or the lip
    };
    /// `s`: length along the curve from the midline, positive on the patient's right; beyond the ends it goes straight
    /// on.
    [[nodiscard]] Place at(double s) const;

    /// The length from the midline to the third molar.
    [[nodiscard]] double half() const { return half_; }

    /// The length at which the curve has this x, 0 or more.
    [[nodiscard]] double lengthTo(double x) const;

    /// The horizontal distance from the curve to a point within the arch, negative outside; smooth in the middle, where
    /// it is up to 1.5 mm less.
    [[nodiscard]] double insideDistance(const Vec3& p) const;

private:
    /// The neck of a tooth of the right side, and its length along the curve.
    struct Knot {
        double s;
        Vec3 neck;
    };
    [[nodiscard]] static std::vector<Knot> rightSide(std::span<const Pose> toothInMouth);
    [[nodiscard]] static SmoothCurve coordinate(const std::vector<Knot>& right, int axis);
    explicit NeckCurve(const std::vector<Knot>& right);

    double half_;
    SmoothCurve x_, y_, z_;
    struct Sample {
        double s;
        Place place;
    };
    std::vector<Sample> samples_;
};

}  // namespace tactooth
