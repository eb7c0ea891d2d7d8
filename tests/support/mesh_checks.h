// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth::test {

/// The first triangle with a corner that is no vertex of the mesh or is not finite.
[[nodiscard]] std::optional<std::size_t> firstInvalidTriangle(const TriangleMesh& mesh);

/// Number of directed edges, by the numbers of their ends, without exactly one partner in the other direction: 0 for a
/// closed, consistently oriented surface.
[[nodiscard]] int unpairedEdges(const TriangleMesh& mesh);
/// The same with equal points united.
[[nodiscard]] int openEdges(const TriangleMesh& mesh);

/// Enclosed volume by the divergence theorem, mm^3; positive if the triangles face outward.
[[nodiscard]] double volumeOf(const TriangleMesh& mesh);

/// The same for each connected component, with equal points united.
[[nodiscard]] std::vector<double> pieceVolumes(const TriangleMesh& mesh);

[[nodiscard]] bool areBitEqual(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace tactooth::test
