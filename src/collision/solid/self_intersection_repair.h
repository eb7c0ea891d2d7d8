// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Moves vertices of triangles that cross others back to their place in `restPositions`, at first few, then more around
/// them, until none cross. False if some still do: those at home cross themselves.
[[nodiscard]] bool repairSelfIntersections(TriangleMesh& mesh, const std::vector<Vec3f>& restPositions);

}  // namespace tactooth
