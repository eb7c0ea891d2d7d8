// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A closed chain of vertices that visits no vertex twice.
using BoundaryLoop = std::vector<std::uint32_t>;

/// The boundary loops of a surface, each in the direction opposite to the triangles beside it. Holes that share corners
/// have separate loops. `open` grows by the number of loops that cannot be filled: they do not close, or they are those
/// of a single isolated triangle.
[[nodiscard]] std::vector<BoundaryLoop> boundaryLoops(const TriangleMesh& mesh, std::size_t& open);

}  // namespace tactooth
