// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// The most triangles that a subdivided mesh may have.
inline constexpr std::size_t kMaxSubdivided = 10'000'000;

/// The same surface with more triangles: every edge is halved `times` times, so each triangle becomes 4^times
/// triangles. The old vertices come first. A closed surface stays closed, and an edge of three triangles stays one. New
/// vertices are on the old edges as far as single precision allows. The caller makes sure that the result has at most
/// kMaxSubdivided triangles.
[[nodiscard]] TriangleMesh subdivided(const TriangleMesh& mesh, int times);

/// The same with about `triangles` triangles (at most one more where an edge is shared by two; unchanged if there are
/// as many already). The longest edges are halved first, so that the triangles become similar in size.
[[nodiscard]] TriangleMesh subdividedTo(const TriangleMesh& mesh, std::size_t triangles);

}  // namespace tactooth
