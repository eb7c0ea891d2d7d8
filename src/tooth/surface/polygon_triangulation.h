// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A closed line through numbered points; the last joins the first.
using PolygonLoop = std::vector<std::uint32_t>;

/// Twice the signed area of a loop, positive if counter-clockwise.
[[nodiscard]] double doubledArea(const std::vector<Eigen::Vector2d>& points, const PolygonLoop& loop);

/// Whether `point` lies within the loop (parity of crossings).
[[nodiscard]] bool isWithin(const std::vector<Eigen::Vector2d>& points, const PolygonLoop& loop,
                            const Eigen::Vector2d& point);

/// Cuts a counter-clockwise outline with clockwise holes into triangles that use the given points only. Always gives
/// (corners + 2 * holes - 2) triangles that close up, however thin the polygon is; only for a simple polygon
/// do none of them overlap.
[[nodiscard]] std::vector<Triangle> triangulate(const std::vector<Eigen::Vector2d>& points, PolygonLoop outline,
                                                std::vector<PolygonLoop> holes);

}  // namespace tactooth
