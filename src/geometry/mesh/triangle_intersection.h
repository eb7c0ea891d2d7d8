// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Triangles that are this close count as intersecting: a nanometre is far above the rounding of double precision, and
/// far below the rounding of vertices to single precision.
inline constexpr double kIntersectionDistance = 1e-6;  // mm

/// Whether two different triangles of a mesh meet elsewhere than in their common corners or edge.
[[nodiscard]] bool trianglesIntersect(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b);

}  // namespace tactooth
