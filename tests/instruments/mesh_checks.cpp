// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mesh_checks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <numbers>

namespace tactooth::test {

bool selfIntersects(const TriangleMesh& mesh) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
    Surface surface;
    std::vector<Surface::Vertex_index> vertices;
    for (const Vec3f& v : mesh.vertices) vertices.push_back(surface.add_vertex({v.x(), v.y(), v.z()}));
    for (const auto& [a, b, c] : mesh.triangles) {
        if (surface.add_face(vertices[a], vertices[b], vertices[c]) == Surface::null_face()) return true;
    }
    return CGAL::Polygon_mesh_processing::does_self_intersect(surface);
}

double windingNumber(const TriangleMesh& mesh, const Vec3& point) {
    double angle = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 a = mesh.corner(i, 0) - point, b = mesh.corner(i, 1) - point, c = mesh.corner(i, 2) - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return angle / (4 * std::numbers::pi);
}

}  // namespace tactooth::test
