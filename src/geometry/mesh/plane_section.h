// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth {

/// A plane with two directions in it.
struct SectionPlane {
    Vec3 origin = Vec3::Zero();                      ///< mm
    Vec3 right = Vec3::UnitX(), up = Vec3::UnitY();  ///< unit, square to each other

    [[nodiscard]] Vec3 normal() const { return right.cross(up); }
    /// Coordinates along right and up of what lies in the plane, mm.
    [[nodiscard]] Vec2 coordinates(const Vec3& place) const {
        return {right.dot(place - origin), up.dot(place - origin)};
    }
};

/// A line in a plane, mm. Closed: the first point follows the last one.
struct SectionLine {
    std::vector<Vec2> points;
    bool closed = false;
};

/// The lines in which a plane cuts a mesh. A corner in the plane counts as above it, so that a closed mesh gives closed
/// lines; a face in the plane gives the lines along its border.
[[nodiscard]] std::vector<SectionLine> planeSection(const TriangleMesh& mesh, const SectionPlane& plane);

/// The part of a closed line within a rectangle, as a closed line; empty: nothing. Concave lines keep edges along the
/// rectangle. I. Sutherland, G. Hodgman, CACM 17, 1974.
[[nodiscard]] std::vector<Vec2> clipped(const std::vector<Vec2>& line, const Eigen::AlignedBox2d& box);

/// The pieces of a line within a rectangle, without edges along it.
[[nodiscard]] std::vector<SectionLine> piecesWithin(const SectionLine& line, const Eigen::AlignedBox2d& box);

}  // namespace tactooth
