// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/mesh_deviation.h"

#include <algorithm>

#include "collision/bvh/closest_point.h"

namespace tactooth {
namespace {

/// Greatest distance of a set of points from a surface.
class FarthestFrom {
public:
    explicit FarthestFrom(const TriangleMesh& mesh) : surface_(mesh) {}

    void see(const Vec3& point) {
        if (const auto nearest = closestPoint(surface_, point)) greatest_ = std::max(greatest_, nearest->distance);
    }
    void seeVertices(const TriangleMesh& mesh) {
        for (const Vec3f& vertex : mesh.vertices) see(vertex.cast<double>());
    }
    void seeMiddles(const TriangleMesh& mesh) {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Vec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
            see((a + b + c) / 3);
            see(0.5 * (a + b));
            see(0.5 * (b + c));
            see(0.5 * (c + a));
        }
    }
    [[nodiscard]] double distance() const { return greatest_; }

private:
    SurfacePart surface_;
    double greatest_ = 0;
};

double greatestDistance(const TriangleMesh& of, const TriangleMesh& to) {
    FarthestFrom farthest(to);
    farthest.seeVertices(of);
    farthest.seeMiddles(of);
    return farthest.distance();
}

}  // namespace

double hausdorffDistance(const TriangleMesh& one, const TriangleMesh& other) {
    return std::max(greatestDistance(one, other), greatestDistance(other, one));
}

double maxVertexDistance(const TriangleMesh& of, const TriangleMesh& to) {
    FarthestFrom farthest(to);
    farthest.seeVertices(of);
    return farthest.distance();
}

}  // namespace tactooth
