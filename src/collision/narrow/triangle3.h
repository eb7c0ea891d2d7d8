// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// The corners of one triangle, mm.
using Triangle3 = std::array<Vec3, 3>;

[[nodiscard]] inline Triangle3 cornersOf(const TriangleMesh& mesh, std::size_t triangle) {
    return {mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
}

[[nodiscard]] inline double lowestAlong(std::span<const Vec3> points, const Vec3& direction) {
    double lowest = direction.dot(points[0]);
    for (const Vec3& point : points.subspan(1)) lowest = std::min(lowest, direction.dot(point));
    return lowest;
}

[[nodiscard]] inline double highestAlong(std::span<const Vec3> points, const Vec3& direction) {
    double highest = direction.dot(points[0]);
    for (const Vec3& point : points.subspan(1)) highest = std::max(highest, direction.dot(point));
    return highest;
}

}  // namespace tactooth
