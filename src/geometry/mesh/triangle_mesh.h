// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/util/pose.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// Three vertex numbers, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// An indexed triangle surface in mm. Coordinates are kept in single precision, as an STL file stores them, so that
/// what was read is what is written back, bit for bit; computations convert to double.
struct TriangleMesh {
    std::vector<Vec3f> vertices;
    std::vector<Triangle> triangles;

    [[nodiscard]] bool empty() const { return triangles.empty(); }
    /// Corner `corner` (0..2) of triangle `triangle`.
    [[nodiscard]] Vec3 corner(std::size_t triangle, int corner) const {
        return vertices[triangles[triangle][corner]].cast<double>();
    }
    /// Twice the area times the outward normal, mm^2.
    [[nodiscard]] Vec3 areaVector(std::size_t triangle) const {
        return (corner(triangle, 1) - corner(triangle, 0)).cross(corner(triangle, 2) - corner(triangle, 0));
    }
};

/// The smallest box that holds every vertex that a triangle uses; empty for an empty mesh.
[[nodiscard]] Box3 boundingBox(const TriangleMesh& mesh);

/// `mesh` with every vertex moved by `pose`.
[[nodiscard]] TriangleMesh transformed(const TriangleMesh& mesh, const Pose& pose);

/// Adds the vertices and triangles of `part` to `mesh`.
void append(TriangleMesh& mesh, const TriangleMesh& part);

}  // namespace tactooth
