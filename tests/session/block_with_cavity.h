// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/mesh/triangle_mesh.h"

namespace tactooth::test {

/// The block from (-5, -5, -5) to (5, 5, 5) with a box from `low` to `high` taken out of its top: high.z() is 5.
inline TriangleMesh blockWithCavity(const Vec3& low, const Vec3& high) {
    TriangleMesh mesh;
    const auto square = [&](const Vec3& a, const Vec3& b, double z) {
        for (const Vec3& corner :
             {Vec3(a.x(), a.y(), z), Vec3(b.x(), a.y(), z), Vec3(b.x(), b.y(), z), Vec3(a.x(), b.y(), z)}) {
            mesh.vertices.push_back(corner.cast<float>());
        }
    };
    const Vec3 corner = Vec3::Constant(5);
    square(-corner, corner, -5);
    square(-corner, corner, 5);
    square(low, high, high.z());
    square(low, high, low.z());
    const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    };
    face(0, 3, 2, 1);
    face(12, 13, 14, 15);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t next = (i + 1) % 4;
        face(i, next, 4 + next, 4 + i);            // outside
        face(4 + i, 4 + next, 8 + next, 8 + i);    // around the opening
        face(8 + i, 8 + next, 12 + next, 12 + i);  // down into it
    }
    return mesh;
}

}  // namespace tactooth::test
