// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "support/export_checker.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <ostream>

namespace tactooth::test {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Corners = std::array<std::size_t, 3>;

/// The facets of a file as point numbers, without those with two equal corners.
struct Soup {
    std::vector<Point> points;
    std::vector<Corners> facets;
    std::vector<std::size_t> numbers;  // numbers of the facets in the file
};

bool isCollapsed(const Corners& facet) { return facet[0] == facet[1] || facet[1] == facet[2] || facet[2] == facet[0]; }

SurfaceMesh meshOf(const Soup& soup) {
    SurfaceMesh mesh;
    for (const Point& point : soup.points) mesh.add_vertex(point);
    const auto vertex = [](std::size_t i) { return SurfaceMesh::Vertex_index(static_cast<unsigned>(i)); };
    for (const Corners& facet : soup.facets) mesh.add_face(vertex(facet[0]), vertex(facet[1]), vertex(facet[2]));
    return mesh;
}

/// Reach of the points of one facet beyond another's plane, to the side of the smaller reach.
double piercesTriangle(const std::array<Point, 3>& facet, const std::array<Point, 3>& plane) {
    const Kernel::Vector_3 normal = CGAL::cross_product(plane[1] - plane[0], plane[2] - plane[0]);
    const double length = std::sqrt(normal.squared_length());
    if (length == 0) return 0;
    double above = 0;
    double below = 0;
    for (const Point& corner : facet) {
        const double height = (corner - plane[0]) * normal / length;
        above = std::max(above, height);
        below = std::max(below, -height);
    }
    return std::min(above, below);
}

std::vector<SelfIntersection> intersectionsOf(const SurfaceMesh& mesh, const Soup& soup) {
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
    pmp::self_intersections<CGAL::Sequential_tag>(mesh.faces(), mesh, std::back_inserter(pairs));
    const auto cornersOf = [&](std::size_t face) {
        const Corners& facet = soup.facets[face];
        return std::array{soup.points[facet[0]], soup.points[facet[1]], soup.points[facet[2]]};
    };
    std::vector<SelfIntersection> intersections;
    for (const auto& [a, b] : pairs) {
        const auto one = cornersOf(a);
        const auto two = cornersOf(b);
        intersections.push_back(
            {soup.numbers[a], soup.numbers[b], std::min(piercesTriangle(one, two), piercesTriangle(two, one))});
    }
    return intersections;
}

}  // namespace

std::size_t ExportCheck::intersectionsDeeperThan(double depth) const {
    return static_cast<std::size_t>(std::count_if(intersections.begin(), intersections.end(),
                                                  [&](const SelfIntersection& one) { return one.depth > depth; }));
}

double ExportCheck::deepestIntersection() const {
    double deepest = 0;
    for (const SelfIntersection& one : intersections) deepest = std::max(deepest, one.depth);
    return deepest;
}

std::ostream& operator<<(std::ostream& out, const ExportCheck& check) {
    return out << check.facets << " facets, " << check.collapsed << " collapsed"
               << (check.isManifold ? ", manifold" : ", not manifold") << (check.isClosed ? ", closed" : ", not closed")
               << (check.boundsVolume ? ", bounds a volume" : ", bounds no volume") << ", " << check.components
               << " components, " << check.volume << " mm^3, " << check.intersections.size() << " self-intersections, "
               << check.intersectionsDeeperThan(1e-5) << " of them deeper than 10 nm, deepest "
               << 1e3 * check.deepestIntersection() << " um";
}

ExportCheck checkExport(const std::filesystem::path& stlFile) {
    ExportCheck check;
    Soup soup;
    std::vector<Corners> read;
    std::ifstream file(stlFile, std::ios::binary);
    if (!CGAL::IO::read_STL(file, soup.points, read)) return check;
    check.facets = read.size();
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (isCollapsed(read[i])) {
            ++check.collapsed;
            continue;
        }
        soup.facets.push_back(read[i]);
        soup.numbers.push_back(i);
    }
    check.isManifold = !soup.facets.empty() && pmp::is_polygon_soup_a_polygon_mesh(soup.facets);
    if (!check.isManifold) return check;
    const SurfaceMesh mesh = meshOf(soup);
    check.isClosed = CGAL::is_closed(mesh);
    check.intersections = intersectionsOf(mesh, soup);
    if (!check.isClosed) return check;
    std::vector<std::size_t> component(mesh.number_of_faces());
    check.components = pmp::connected_components(mesh, CGAL::make_property_map(component));
    check.boundsVolume = pmp::does_bound_a_volume(mesh);
    check.volume = pmp::volume(mesh);
    return check;
}

}  // namespace tactooth::test
