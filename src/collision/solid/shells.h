// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "collision/bvh/surface.h"

namespace tactooth {

/// What orienting the shells of a closed surface has done.
struct ShellOrientation {
    bool isNonOrientable = false;      ///< a shell has only one side; no triangle was flipped
    std::size_t flippedTriangles = 0;  ///< that faced the wrong side
    std::size_t shells = 0;
    std::size_t voids = 0;  ///< shells that are the wall of a void
    double volume = 0;      ///< of the inside, in the cube of the mesh's unit
};

/// Flips triangles of `mesh` so that each faces the outside: the side from which a ray crosses the surface an even
/// number of times. A shell, a set of triangles connected over edges of two triangles, is flipped as a whole. `part`
/// has the same triangles. Shells with a triangle of `crossing` (triangles that cross others) are not nested: they keep
/// the side that most of their triangles face, and are flipped all together if they face inward.
ShellOrientation orientShells(const SurfacePart& part, std::span<const std::uint32_t> crossing, TriangleMesh& mesh);

}  // namespace tactooth
