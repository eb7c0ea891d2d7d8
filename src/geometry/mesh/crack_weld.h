// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// What was done to corners that are one point but for rounding.
struct CrackWeld {
    std::size_t moved = 0;  ///< vertices that were put onto another
    double tolerance = 0;   ///< how far apart they may have been, in the mesh's unit; 0: nothing was welded
};

/// Welds the vertices on open edges that lie within a tolerance of each other: programs write one point with other last
/// digits in each of its triangles. A millionth of the size of the surface is tried, then ten and a hundred millionths
/// (0.02 to 2 um of a tooth), never more than a twentieth of its usual edge. The smallest tolerance that closes most is
/// taken, and none if none closes anything. Triangles that lose their area are dropped. A mesh without open edges stays
/// as it is, bit for bit.
CrackWeld weldCracks(TriangleMesh& mesh);

/// Of triangles with the same three corners those that lie back to back cancel each other, and of the others one stays:
/// neither changes what is inside. The first ones stay in their order. Returns how many were dropped.
std::size_t removeDuplicates(TriangleMesh& mesh);

}  // namespace tactooth
