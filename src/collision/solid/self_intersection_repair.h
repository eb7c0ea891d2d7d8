// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Moves the vertices of triangles that intersect others back to their rest positions, first a few vertices, then more
/// around them, until no triangles intersect. `restPositions` holds one position (mm) for each vertex. False if some
/// still intersect: then the surface of the rest positions intersects itself.
[[nodiscard]] bool repairSelfIntersections(TriangleMesh& mesh, const std::vector<Vec3f>& restPositions);

}  // namespace tactooth
