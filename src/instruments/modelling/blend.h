// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Building blocks of implicit bodies (negative inside, about the distance in mm outside).
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/util/vec.h"

namespace tactooth {

/// Union with a fillet: where the two values differ by less than `blend` (positive) the seam is filled; elsewhere
/// nothing changes.
[[nodiscard]] inline double smoothUnion(double a, double b, double blend) {
    const double overlap = std::max(blend - std::abs(a - b), 0.0);
    return std::min(a, b) - overlap * overlap / (4 * blend);
}

/// Intersection with a rounded edge.
[[nodiscard]] inline double smoothIntersection(double a, double b, double blend) { return -smoothUnion(-a, -b, blend); }

/// 0 below `from`, 1 above `to`, smooth between.
[[nodiscard]] inline double smoothStep(double from, double to, double x) {
    const double part = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return part * part * (3 - 2 * part);
}

/// A bump of height 1 at 0 that has faded at about twice `width`.
[[nodiscard]] inline double bump(double x, double width) { return std::exp(-(x * x) / (width * width)); }

/// Distance to a ball-ended cone from `a` (radius `radiusA`) to `b` (radius `radiusB`).
[[nodiscard]] inline double taperedCapsule(const Vec3& p, const Vec3& a, double radiusA, const Vec3& b,
                                           double radiusB) {
    const Vec3 along = b - a;
    const double part = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - a - part * along).norm() - std::lerp(radiusA, radiusB, part);
}

/// About the distance to an ellipsoid with these half axes.
[[nodiscard]] inline double ellipsoid(const Vec3& p, const Vec3& halfAxes) {
    const double scaled = p.cwiseQuotient(halfAxes).norm();
    const double slope = p.cwiseQuotient(halfAxes.cwiseProduct(halfAxes)).norm();
    constexpr double kCentre = 1e-9;
    if (slope < kCentre) return -halfAxes.minCoeff();
    return scaled * (scaled - 1) / slope;
}

}  // namespace tactooth
