// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace tactooth {

/// The triangles that meet another one elsewhere than in the corners or the edge that both have, in ascending order;
/// those that come within a nanometre of it, too. None: the surface does not intersect itself. For meshes whose
/// triangles are of about one size.
[[nodiscard]] std::vector<std::uint32_t> selfCrossings(const TriangleMesh& mesh);

/// Moves vertices of triangles that cross others back to their place in `home`, at first few, then more around them,
/// until none cross. False if some still do: those at home cross themselves.
[[nodiscard]] bool untangle(TriangleMesh& mesh, const std::vector<Vec3f>& home);

}  // namespace tactooth
