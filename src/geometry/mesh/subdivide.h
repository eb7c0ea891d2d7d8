// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// The most triangles that a subdivided mesh may have.
inline constexpr std::size_t kMaxSubdivided = 10'000'000;

/// The same surface from more triangles: every edge is halved `times` times, so each triangle becomes 4^times. Its old
/// vertices are its first ones. A closed surface stays closed, an edge of three triangles stays one. New vertices lie
/// on the old edges as far as single precision goes. The result has at most kMaxSubdivided triangles (the caller has
/// seen to that).
[[nodiscard]] TriangleMesh subdivided(const TriangleMesh& mesh, int times);

/// The same with about `triangles` triangles (one more, at most, where an edge is shared by two; unchanged if there are
/// as many already): the longest edges are halved first, so that the triangles become alike in size.
[[nodiscard]] TriangleMesh subdividedTo(const TriangleMesh& mesh, std::size_t triangles);

}  // namespace tactooth
