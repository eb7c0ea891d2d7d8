// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/assert.h"
#include "geometry/util/disjoint_sets.h"

namespace tactooth {

/// The bits of a mesh: what hangs together by triangles that share a point, equal points being one.
class MeshComponents {
public:
    explicit MeshComponents(const TriangleMesh& mesh);

    /// The distinct points of the mesh.
    [[nodiscard]] const std::vector<Vec3f>& points() const { return points_; }
    /// A bit is known by its lowest point.
    [[nodiscard]] std::uint32_t ofPoint(std::uint32_t point) {
        TACTOOTH_ASSERT(point < points_.size());
        return joined_.find(point);
    }
    [[nodiscard]] std::uint32_t ofVertex(std::uint32_t vertex) {
        TACTOOTH_ASSERT(vertex < pointOf_.size());
        return joined_.find(pointOf_[vertex]);
    }

private:
    std::vector<std::uint32_t> pointOf_;  // each vertex of the mesh
    std::vector<Vec3f> points_;
    DisjointSets joined_;
};

}  // namespace tactooth
