// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/file/mesh_components.h"

#include "geometry/mesh/vertex_welder.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

std::vector<Vec3f> distinctPoints(const TriangleMesh& mesh, std::vector<std::uint32_t>& pointOf) {
    VertexWelder welder(mesh.vertices.size());
    pointOf.resize(mesh.vertices.size());
    welder.addAll(mesh.vertices, pointOf.data());
    return welder.takeVertices();
}

}  // namespace

MeshComponents::MeshComponents(const TriangleMesh& mesh)
    : points_(distinctPoints(mesh, pointOf_)), joined_(points_.size()) {
    TACTOOTH_ASSERT(pointOf_.size() == mesh.vertices.size());
    for (const Triangle& triangle : mesh.triangles) {
        joined_.join(pointOf_[triangle[0]], pointOf_[triangle[1]]);
        joined_.join(pointOf_[triangle[1]], pointOf_[triangle[2]]);
    }
}

}  // namespace tactooth
