// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include "peers/peer.h"

namespace tactooth::bench {

TriangleMesh convexHull(const TriangleMesh& mesh) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Hull = CGAL::Surface_mesh<Kernel::Point_3>;
    std::vector<Kernel::Point_3> points;
    for (const Vec3f& v : mesh.vertices) points.emplace_back(v.x(), v.y(), v.z());
    Hull hull;
    CGAL::convex_hull_3(points.begin(), points.end(), hull);
    TriangleMesh result;
    for (const auto vertex : hull.vertices()) {
        const Kernel::Point_3& p = hull.point(vertex);
        result.vertices.push_back(Vec3(p.x(), p.y(), p.z()).cast<float>());
    }
    for (const auto face : hull.faces()) {
        Triangle triangle{};
        int corner = 0;
        for (const auto vertex : CGAL::vertices_around_face(hull.halfedge(face), hull))
            triangle[corner++] = vertex.idx();
        result.triangles.push_back(triangle);
    }
    return result;
}

}  // namespace tactooth::bench
