// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/crumbs.h"

#include <vector>

#include "geometry/disjoint_sets.h"
#include "geometry/vertex_welder.h"

namespace tactooth {
namespace {

/// The points of a surface, equal ones being one, and its triangles.
struct WeldedSurface {
    explicit WeldedSurface(const Surface& surface) : welder(surface.base->mesh().vertices.size()) {
        const TriangleMesh& base = surface.base->mesh();
        add(base, [&](std::size_t t) {
            return surface.hidden == nullptr || !isHidden(*surface.hidden, static_cast<std::uint32_t>(t));
        });
        for (const auto& patch : surface.patches) add(patch->mesh(), [](std::size_t) { return true; });
        points = welder.takeVertices();
    }

    template <class IsVisible>
    void add(const TriangleMesh& mesh, const IsVisible& isVisible) {
        std::vector<std::uint32_t> numbers(mesh.vertices.size());
        welder.addAll(mesh.vertices, numbers.data());
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (!isVisible(t)) continue;
            const Triangle& v = mesh.triangles[t];
            triangles.push_back({numbers[v[0]], numbers[v[1]], numbers[v[2]]});
        }
    }

    VertexWelder welder;
    std::vector<Triangle> triangles;
    std::vector<Vec3f> points;
};

/// What of the lattice is beside one point.
struct NodesAround {
    NodeSets air;         ///< neither tooth nor removed, of the eight around it
    bool isHeld = false;  ///< one of the eight is solid, or no bur has been there
};

NodesAround nodesAround(const BrickMap& bricks, const Lattice& lattice, const Vec3& point) {
    const Vec3 first = ((point - lattice.node(0, 0, 0)) / lattice.spacing()).array().floor();
    NodesAround around;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3i node = first.cast<int>() + Eigen::Vector3i(corner & 1, corner >> 1 & 1, corner >> 2);
        const BrickKey key{node.x() >> 3, node.y() >> 3, node.z() >> 3};  // eight nodes a side
        const Brick* brick = bricks.find(key);
        if (brick == nullptr) {
            around.isHeld = around.isHeld || !bricks.knows(key);
            continue;
        }
        const int place = nodeIndex(node.x() & 7, node.y() & 7, node.z() & 7);
        if (brick->cut[place] < 0) continue;
        around.isHeld = around.isHeld || brick->tooth[place] < 0;
        around.air[key].set(static_cast<std::size_t>(place));
    }
    return around;
}

}  // namespace

NodeSets nodesBesideCrumbs(const Surface& surface, const BrickMap& bricks, const Lattice& lattice) {
    const WeldedSurface welded(surface);
    DisjointSets bits(welded.points.size());
    std::vector<bool> isUsed(welded.points.size());
    for (const Triangle& triangle : welded.triangles) {
        bits.join(triangle[0], triangle[1]);
        bits.join(triangle[1], triangle[2]);
        for (const std::uint32_t point : triangle) isUsed[point] = true;
    }
    std::vector<bool> isHeld(welded.points.size());  // by the first point of each bit: the lowest number
    for (std::uint32_t i = 0; i < welded.points.size(); ++i) {
        const std::uint32_t bit = bits.find(i);
        if (!isUsed[i] || isHeld[bit]) continue;
        isHeld[bit] = nodesAround(bricks, lattice, welded.points[i].cast<double>()).isHeld;
    }
    NodeSets beside;
    for (std::uint32_t i = 0; i < welded.points.size(); ++i) {
        if (!isUsed[i] || isHeld[bits.find(i)]) continue;
        const NodesAround around = nodesAround(bricks, lattice, welded.points[i].cast<double>());
        for (const auto& [key, nodes] : around.air) beside[key] |= nodes;
    }
    return beside;
}

}  // namespace tactooth
