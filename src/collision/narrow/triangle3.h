// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// The corners of one triangle, mm.
using Triangle3 = std::array<Vec3, 3>;

[[nodiscard]] inline Triangle3 cornersOf(const TriangleMesh& mesh, std::size_t triangle) {
    TACTOOTH_ASSERT(triangle < mesh.triangles.size());
    return {mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
}

/// The least dot product of a point with a direction. At least one point.
[[nodiscard]] inline double lowestAlong(std::span<const Vec3> points, const Vec3& direction) {
    TACTOOTH_ASSERT(!points.empty());
    double lowest = direction.dot(points[0]);
    for (const Vec3& point : points.subspan(1)) lowest = std::min(lowest, direction.dot(point));
    return lowest;
}

/// The greatest dot product of a point with a direction. At least one point.
[[nodiscard]] inline double highestAlong(std::span<const Vec3> points, const Vec3& direction) {
    TACTOOTH_ASSERT(!points.empty());
    double highest = direction.dot(points[0]);
    for (const Vec3& point : points.subspan(1)) highest = std::max(highest, direction.dot(point));
    return highest;
}

}  // namespace tactooth
