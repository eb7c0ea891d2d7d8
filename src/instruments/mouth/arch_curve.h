// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/vec.h"

namespace tactooth {

/// The line of occlusion seen from above: it runs along the edges and buccal cusps of the lower teeth and in the upper
/// teeth's fossae. Mouth frame: +x to the patient's right, +y forward, +z up; the origin lies on the line between the
/// central incisors; mm.
class ArchCurve {
public:
    /// `width`: 1 for the average arch, more for a wider one.
    explicit ArchCurve(double width = 1) : width_(width) {}

    struct Place {
        Vec3 point;
        Vec3 along;    ///< unit, away from the midline on the right side
        Vec3 outward;  ///< unit, to the cheek
    };
    /// The place this far along the line from its middle; positive on the patient's right.
    [[nodiscard]] Place at(double s) const;

    struct Coordinates {
        double s = 0;        ///< along the line, positive on the patient's right
        double outward = 0;  ///< from it, positive to the cheek
    };
    /// The nearest place of the line.
    [[nodiscard]] Coordinates of(double x, double y) const;

    /// How far the line at `x` lies behind its front.
    [[nodiscard]] double depth(double x) const;
    /// Half the line's width this far behind its front; 0 in front of it.
    [[nodiscard]] double halfWidth(double depth) const;

private:
    [[nodiscard]] double slope(double x) const;
    [[nodiscard]] double length(double x) const;

    double width_;
};

/// Height of the occlusal surface this far behind the incisors' edges: lowest at the premolars (curve of Spee).
[[nodiscard]] double occlusalPlane(double depth);

}  // namespace tactooth
