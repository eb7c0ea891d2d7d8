// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "collision/bvh/surface.h"

namespace tactooth {

/// What turning the shells of a closed surface has done.
struct ShellOrientation {
    bool isNonOrientable = false;      ///< a shell has but one side; nothing was turned
    std::size_t flippedTriangles = 0;  ///< those that looked the wrong way
    std::size_t shells = 0;
    std::size_t hollows = 0;  ///< shells that are now the wall of a hollow
    double volume = 0;        ///< of what is inside
};

/// Turns the triangles of `mesh` so that each looks at the side from which the surface is crossed an even number of
/// times. A shell, what hangs together over edges of two triangles, is turned as a whole. `part` has the same
/// triangles. Shells with one of the triangles `crossing`, which cross others, are not nested: they keep the way in
/// which most of their triangles look, and are turned all together if they look inward.
ShellOrientation orientShells(const SurfacePart& part, std::span<const std::uint32_t> crossing, TriangleMesh& mesh);

}  // namespace tactooth
