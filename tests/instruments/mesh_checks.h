// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth::test {

/// Self-intersections according to CGAL, independent of our code.
[[nodiscard]] bool selfIntersects(const TriangleMesh& mesh);

/// Solid angle of the mesh seen from `point`, as a share of the full sphere: 1 inside, 0 outside (A. van Oosterom, J.
/// Strackee 1983). Slow and exact.
[[nodiscard]] double windingNumber(const TriangleMesh& mesh, const Vec3& point);

}  // namespace tactooth::test
