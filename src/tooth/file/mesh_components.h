// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.h"
#include "geometry/util/assert.h"
#include "geometry/util/disjoint_sets.h"

namespace tactooth {

/// The connected components of a mesh. Triangles are connected if they share a point; equal points are one.
class MeshComponents {
public:
    explicit MeshComponents(const TriangleMesh& mesh);

    /// The distinct points of the mesh.
    [[nodiscard]] const std::vector<Vec3f>& points() const { return points_; }
    /// Number of the component of a point or vertex: the lowest number of its points.
    [[nodiscard]] std::uint32_t ofPoint(std::uint32_t point) {
        TACTOOTH_ASSERT(point < points_.size());
        return joined_.find(point);
    }
    [[nodiscard]] std::uint32_t ofVertex(std::uint32_t vertex) {
        TACTOOTH_ASSERT(vertex < pointOf_.size());
        return joined_.find(pointOf_[vertex]);
    }

private:
    std::vector<std::uint32_t> pointOf_;  // of each vertex of the mesh
    std::vector<Vec3f> points_;
    DisjointSets joined_;
};

}  // namespace tactooth
