// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/file/debris.h"

#include <vector>

#include "geometry/util/assert.h"
#include "tooth/file/mesh_components.h"

namespace tactooth {
namespace {

/// The lattice around one point.
struct NodesAround {
    NodeSets air;             ///< nodes of the eight around the point that are neither tooth nor removed
    bool isAttached = false;  ///< one of the eight nodes is solid, or its brick was never sampled
};

NodesAround nodesAround(const BrickMap& bricks, const Lattice& lattice, const Vec3& point) {
    TACTOOTH_ASSERT(point.allFinite());
    const Vec3 first = ((point - lattice.node(0, 0, 0)) / lattice.spacing()).array().floor();
    NodesAround around;
    for (int corner = 0; corner < 8; ++corner) {
        const auto [key, node] =
            LatticeNode(first.cast<int>() + Eigen::Vector3i(corner & 1, corner >> 1 & 1, corner >> 2));
        const Brick* brick = bricks.find(key);
        if (brick == nullptr) {
            around.isAttached = around.isAttached || !bricks.knows(key);
            continue;
        }
        if (brick->cut[node] < 0) continue;
        around.isAttached = around.isAttached || brick->tooth[node] < 0;
        around.air[key].set(static_cast<std::size_t>(node));
    }
    return around;
}

}  // namespace

NodeSets nodesBesideDebris(const Surface& surface, const BrickMap& bricks, const Lattice& lattice) {
    TACTOOTH_ASSERT(surface.base != nullptr);
    MeshComponents components(visibleMesh(surface).mesh);
    const std::vector<Vec3f>& points = components.points();
    std::vector<bool> isAttached(points.size());  // by the number of a component, which is that of its first point
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const std::uint32_t component = components.ofPoint(i);
        if (!isAttached[component])
            isAttached[component] = nodesAround(bricks, lattice, points[i].cast<double>()).isAttached;
    }
    NodeSets beside;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (isAttached[components.ofPoint(i)]) continue;
        const NodesAround around = nodesAround(bricks, lattice, points[i].cast<double>());
        for (const auto& [key, nodes] : around.air) beside[key] |= nodes;
    }
    return beside;
}

}  // namespace tactooth
