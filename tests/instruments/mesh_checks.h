// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangle_mesh.h"

namespace tactooth::test {

/// Every edge has exactly two triangles, which run along it in opposite directions.
[[nodiscard]] bool isClosedAndOriented(const TriangleMesh& mesh);

/// Enclosed volume by the divergence theorem, mm^3; positive if the triangles face outward.
[[nodiscard]] double volumeOf(const TriangleMesh& mesh);

/// Independent judge: CGAL.
[[nodiscard]] bool intersectsItself(const TriangleMesh& mesh);

[[nodiscard]] bool areBitEqual(const TriangleMesh& a, const TriangleMesh& b);

/// Solid angle of the mesh seen from `point`, as a part of the full sphere: 1 inside, 0 outside (A. van Oosterom,
/// J. Strackee 1983). Slow and exact.
[[nodiscard]] double windingNumber(const TriangleMesh& mesh, const Vec3& point);

}  // namespace tactooth::test
