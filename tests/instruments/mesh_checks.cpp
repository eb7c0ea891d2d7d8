// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mesh_checks.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <utility>

namespace tactooth::test {

bool isClosedAndOriented(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Triangle& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) ++uses[{triangle[corner], triangle[(corner + 1) % 3]}];
    }
    for (const auto& [edge, count] : uses) {
        const auto opposite = uses.find({edge.second, edge.first});
        if (count != 1 || opposite == uses.end()) return false;
    }
    return !mesh.triangles.empty();
}

double volumeOf(const TriangleMesh& mesh) {
    double volume = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        volume += mesh.corner(i, 0).dot(mesh.corner(i, 1).cross(mesh.corner(i, 2))) / 6;
    }
    return volume;
}

bool intersectsItself(const TriangleMesh& mesh) {
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

bool areBitEqual(const TriangleMesh& a, const TriangleMesh& b) {
    return a.triangles == b.triangles && a.vertices.size() == b.vertices.size() &&
           std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(Vec3f)) == 0;
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
