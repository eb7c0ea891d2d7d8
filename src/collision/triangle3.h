// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "geometry/triangle_mesh.h"

namespace tactooth {

/// The corners of one triangle, mm.
using Triangle3 = std::array<Vec3, 3>;

[[nodiscard]] inline Triangle3 cornersOf(const TriangleMesh& mesh, std::size_t triangle) {
    return {mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
}

[[nodiscard]] inline double lowestAlong(const Triangle3& triangle, const Vec3& direction) {
    return std::min({direction.dot(triangle[0]), direction.dot(triangle[1]), direction.dot(triangle[2])});
}

[[nodiscard]] inline double highestAlong(const Triangle3& triangle, const Vec3& direction) {
    return std::max({direction.dot(triangle[0]), direction.dot(triangle[1]), direction.dot(triangle[2])});
}

}  // namespace tactooth
