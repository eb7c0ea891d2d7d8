// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth::test {

/// A closed box from `low` to `high`, 12 triangles, mm.
[[nodiscard]] TriangleMesh box(const Vec3& low, const Vec3& high);

/// A closed latitude-longitude sphere with its vertices on the sphere: `rings` bands from pole to pole, each of
/// `sectors` quads, 2 * sectors * (rings - 1) triangles.
[[nodiscard]] TriangleMesh sphere(const Vec3& centre, double radius, int sectors, int rings);

/// A closed cylinder along +z with its base at `base`: `sectors` sides, vertices on the cylinder.
[[nodiscard]] TriangleMesh cylinder(const Vec3& base, double radius, double height, int sectors);

/// The triangles of a square grid of `side` x `side` vertices that are numbered row by row: two for each square,
/// counter-clockwise when columns run to the right and rows upward.
[[nodiscard]] std::vector<Triangle> gridTriangles(std::uint32_t side);

}  // namespace tactooth::test
