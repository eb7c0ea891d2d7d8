// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A closed chain of vertices that passes none twice.
using Loop = std::vector<std::uint32_t>;

/// The rims of the holes of a surface, each running against the triangles beside it. Holes that share corners have rims
/// of their own. `open` grows by the number of rims that cannot be filled: they do not close, or are those of a single
/// triangle, which hangs together with nothing.
[[nodiscard]] std::vector<Loop> boundaryLoops(const TriangleMesh& mesh, std::size_t& open);

}  // namespace tactooth
