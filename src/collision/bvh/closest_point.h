// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "collision/bvh/surface.h"

namespace tactooth {

/// The point of a surface nearest to a query point.
struct ClosestPoint {
    Vec3 point;              ///< on the surface, mm
    double distance;         ///< from the query point, mm, >= 0
    std::uint32_t triangle;  ///< of the part's mesh
};

/// The point of `part` nearest to `query`, if it lies within `within` mm.
[[nodiscard]] std::optional<ClosestPoint> closestPoint(const SurfacePart& part, const Vec3& query,
                                                       double within = std::numeric_limits<double>::infinity());

/// Whether `query` lies inside the closed surface `part` (parity of ray crossings; has no meaning for an open surface).
[[nodiscard]] bool contains(const SurfacePart& part, const Vec3& query);

/// The same for a tooth that may have been cut: hidden triangles do not count, patches do.
[[nodiscard]] bool contains(const Surface& surface, const Vec3& query);

/// Distance to `part`, negative inside, mm. `part` is closed.
[[nodiscard]] double signedDistance(const SurfacePart& part, const Vec3& query);

}  // namespace tactooth
