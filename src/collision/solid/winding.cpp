// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/winding.h"

#include "collision/bvh/ray_crossing.h"

// Point in polyhedron by the crossings of a ray, with another ray where one is degenerate: J. O'Rourke, "Computational
// Geometry in C", 2nd edition, 1998, section 7.5. Differs from the book: the crossings are counted with their sign,
// which gives the winding number instead of the parity.

namespace tactooth {
namespace {

Vec3 pointAt(const TriangleMesh& mesh, std::uint32_t t, const Barycentric& place) {
    return place[0] * mesh.corner(t, 0) + place[1] * mesh.corner(t, 1) + place[2] * mesh.corner(t, 2);
}

}  // namespace

int windingInFront(const SurfacePart& part, std::uint32_t triangle, const Barycentric& place) {
    const TriangleMesh& mesh = part.mesh();
    TACTOOTH_ASSERT(triangle < mesh.triangles.size());
    TACTOOTH_ASSERT(std::abs(place.sum() - 1) < 1e-9 && place.minCoeff() >= 0);
    const Vec3 normal = mesh.areaVector(triangle);
    if (normal.squaredNorm() == 0) return 0;
    const Vec3 from = pointAt(mesh, triangle, place);
    for (int attempt = 0; attempt < kRayAttempts; ++attempt) {
        Vec3 direction = rayDirection(attempt);
        if (direction.dot(normal) < 0) direction = -direction;
        int winding = 0;
        const bool isClear =
            visitCrossings(part.tree(), nullptr, from, direction, [&](std::uint32_t other, RayHit hit) {
                if (other == triangle) return true;
                winding += hit == RayHit::Leaving ? 1 : -1;
                return hit != RayHit::Grazing;
            });
        if (isClear) return winding;
    }
    return 0;  // every ray grazes
}

double clearanceFrom(const SurfacePart& part, std::uint32_t triangle, bool inFront, const Barycentric& place) {
    const TriangleMesh& mesh = part.mesh();
    TACTOOTH_ASSERT(triangle < mesh.triangles.size());
    TACTOOTH_ASSERT(std::abs(place.sum() - 1) < 1e-9 && place.minCoeff() >= 0);
    const Vec3 normal = mesh.areaVector(triangle).normalized();
    const Vec3 direction = inFront ? normal : Vec3(-normal);
    const Vec3 from = pointAt(mesh, triangle, place);
    double nearest = std::numeric_limits<double>::infinity();
    visitCrossings(part.tree(), nullptr, from, direction, [&](std::uint32_t other, RayHit) {
        const Vec3 face = mesh.areaVector(other);
        const double along = face.dot(direction);
        if (other == triangle || along == 0) return true;
        nearest = std::min(nearest, std::max(0.0, face.dot(mesh.corner(other, 0) - from) / along));
        return true;
    });
    TACTOOTH_ASSERT(nearest >= 0);
    return nearest;
}

}  // namespace tactooth
