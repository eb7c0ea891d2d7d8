// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "collision/narrow/triangle3.h"

namespace tactooth {

/// Distance of two convex sets, and a plane that proves it.
struct GjkResult {
    bool separated = false;      ///< false: the sets touch or overlap
    double distance = 0;         ///< mm; 0 when not separated
    double gap = 0;              ///< mm, <= distance: the slab along `normal` between the sets is really so wide
    Vec3 normal = Vec3::Zero();  ///< unit, from `a` to `b`; zero when not separated
    Vec3 onA = Vec3::Zero();     ///< the nearest points
    Vec3 onB = Vec3::Zero();
    int iterations = 0;
};

/// Distance of the convex hulls of two small sets of points, at least three each: triangles, or a triangle at both ends
/// of a step (six points). `guess` is a direction from `a` to `b` to start from. The normal of the last tick saves most
/// iterations; any finite value is allowed.
[[nodiscard]] GjkResult distanceBetween(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& guess);

/// A proof that two sets are apart: the first slab found that is wider than `least` (mm) and nearly as wide as the
/// distance allows. If there is none, the result of distanceBetween. `distance` and the nearest points are not exact.
[[nodiscard]] GjkResult separateConvex(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& guess,
                                       double least);

}  // namespace tactooth
