// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "collision/narrow/triangle3.h"

namespace tactooth {

/// Distance between two convex sets, and the plane that proves it.
struct GjkResult {
    bool separated = false;      ///< false: the sets touch or overlap
    double distance = 0;         ///< mm; 0 when not separated
    double gap = 0;              ///< certified: the width of an empty slab between the sets along `normal`, <= distance
    Vec3 normal = Vec3::Zero();  ///< unit, from `a` to `b`; zero when not separated
    Vec3 onA = Vec3::Zero();     ///< nearest points
    Vec3 onB = Vec3::Zero();
    int iterations = 0;
};

/// Distance between the convex hulls of two small sets of points: triangles, or a triangle swept along a step (six
/// points). `guess` is a direction from `a` to `b` to start from (the normal found at the last tick saves most
/// iterations); any value is allowed.
[[nodiscard]] GjkResult distanceBetween(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& guess);

/// Only what proves that they are apart: the first slab found that is wider than `least` (mm) and nearly as wide as the
/// distance lets it be. Where there is none, the result of distanceBetween. `distance` and the nearest points are not
/// exact.
[[nodiscard]] GjkResult separateConvex(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& guess,
                                       double least);

}  // namespace tactooth
