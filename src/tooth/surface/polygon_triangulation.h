// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A closed polygon as point numbers; the last point is joined to the first.
using PolygonLoop = std::vector<std::uint32_t>;

/// Twice the signed area of a loop, positive if counter-clockwise.
[[nodiscard]] double doubledArea(const std::vector<Vec2>& points, const PolygonLoop& loop);

/// Whether `point` lies within the loop (parity of the crossings).
[[nodiscard]] bool isWithin(const std::vector<Vec2>& points, const PolygonLoop& loop, const Vec2& point);

/// Splits a counter-clockwise outline with clockwise holes into triangles between the given points. The outline and
/// each hole have at least three corners. Always returns (corners + 2 * holes - 2) triangles that form a closed sheet,
/// however thin the polygon is. They do not overlap if the polygon is simple.
[[nodiscard]] std::vector<Triangle> triangulate(const std::vector<Vec2>& points, PolygonLoop outline,
                                                std::vector<PolygonLoop> holes);

}  // namespace tactooth
