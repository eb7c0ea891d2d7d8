// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"
#include "geometry/util/vec.h"

namespace tactooth {

/// Three vertex numbers, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// An indexed triangle mesh in mm. Coordinates are in single precision, as an STL file stores them, so that a
/// coordinate that was read is written back bit for bit. Computations convert to double.
struct TriangleMesh {
    std::vector<Vec3f> vertices;
    std::vector<Triangle> triangles;

    [[nodiscard]] bool empty() const { return triangles.empty(); }
    /// Corner `corner` (0..2) of triangle `triangle`.
    [[nodiscard]] Vec3 corner(std::size_t triangle, int corner) const {
        TACTOOTH_ASSERT(triangle < triangles.size());
        TACTOOTH_ASSERT(corner >= 0 && corner < 3);
        TACTOOTH_ASSERT(triangles[triangle][corner] < vertices.size());
        return vertices[triangles[triangle][corner]].cast<double>();
    }
    /// Twice the area times the outward normal, mm^2.
    [[nodiscard]] Vec3 areaVector(std::size_t triangle) const {
        return (corner(triangle, 1) - corner(triangle, 0)).cross(corner(triangle, 2) - corner(triangle, 0));
    }
};

/// The bounding box of all vertices that a triangle uses; empty for an empty mesh.
[[nodiscard]] Box3 boundingBox(const TriangleMesh& mesh);

/// `mesh` in another frame: every vertex transformed by `pose`, which must be a rigid transform.
[[nodiscard]] TriangleMesh transformed(const TriangleMesh& mesh, const Pose& pose);

/// Adds the vertices and triangles of `part` to `mesh`.
void append(TriangleMesh& mesh, const TriangleMesh& part);

}  // namespace tactooth
