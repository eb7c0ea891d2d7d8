// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// The line of occlusion seen from above: it runs along the edges and buccal cusps of the lower teeth, and in the
/// fossae of the upper teeth. Mouth frame: +x to the patient's right, +y forward, +z up; the origin is on the line
/// between the central incisors; mm.
class ArchCurve {
public:
    /// `width` is 1 for the average arch, larger for a wider one; positive.
    explicit ArchCurve(double width = 1) : width_(width) {}

    struct Place {
        Vec3 point;
        Vec3 along;    ///< unit, away from the midline on the right side
        Vec3 outward;  ///< unit, to the cheek
    };
    /// The point at this arc length from the middle of the line; positive on the patient's right.
    [[nodiscard]] Place at(double s) const;

    struct Coordinates {
        double s = 0;        ///< along the line, positive on the patient's right
        double outward = 0;  ///< distance from it, positive to the cheek
    };
    /// The nearest point of the line.
    [[nodiscard]] Coordinates of(double x, double y) const;

    /// Distance of the line at `x` behind its front, mm.
    [[nodiscard]] double depth(double x) const;
    /// Half the width of the line at this distance behind its front; 0 in front of it.
    [[nodiscard]] double halfWidth(double depth) const;

private:
    [[nodiscard]] double slope(double x) const;
    [[nodiscard]] double length(double x) const;

    double width_;
};

/// Height of the occlusal surface at this distance behind the edges of the incisors: lowest at the premolars (curve of
/// Spee).
[[nodiscard]] double occlusalPlane(double depth);

}  // namespace tactooth
