// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// Result of welding corners that differ by rounding only.
struct CrackWeld {
    std::size_t moved = 0;  ///< vertices that were moved onto another
    double tolerance = 0;   ///< largest distance that was welded, in the mesh's unit; 0: nothing was welded
};

/// Welds vertices on open edges that are within a tolerance of each other: some programs write a different rounding of
/// one point in each of its triangles. It tries a millionth of the size of the surface, then ten and a hundred
/// millionths (0.02 to 2 um for a tooth), but never more than a twentieth of the usual edge length. It takes the
/// smallest tolerance that leaves the fewest open edges, and none if none closes an edge. Triangles that lose their
/// area are dropped. A mesh without open edges stays as it is, bit for bit.
CrackWeld weldCracks(TriangleMesh& mesh);

/// Of triangles with the same three corners, those that lie back to back cancel each other, and one of the others
/// stays: neither changes what is inside. The remaining triangles keep their order. Returns how many were dropped.
std::size_t removeDuplicates(TriangleMesh& mesh);

}  // namespace tactooth
