// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/triangle_mesh.h"

#include <limits>

#include "geometry/util/assert.h"

namespace tactooth {

Box3 boundingBox(const TriangleMesh& mesh) {
    Box3 box;
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            TACTOOTH_ASSERT(vertex < mesh.vertices.size());
            box.extend(mesh.vertices[vertex].cast<double>());
        }
    }
    return box;
}

TriangleMesh transformed(const TriangleMesh& mesh, const Pose& pose) {
    TACTOOTH_ASSERT(isRigid(pose));
    TriangleMesh result = mesh;
    const Mat3 rotation = pose.rotation.toRotationMatrix();
    for (Vec3f& vertex : result.vertices) {
        vertex = (rotation * vertex.cast<double>() + pose.position).cast<float>();
    }
    return result;
}

void append(TriangleMesh& mesh, const TriangleMesh& part) {
    TACTOOTH_ASSERT(mesh.vertices.size() + part.vertices.size() <= std::numeric_limits<std::uint32_t>::max());
    const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    mesh.triangles.reserve(mesh.triangles.size() + part.triangles.size());
    for (const auto& [a, b, c] : part.triangles) mesh.triangles.push_back({a + offset, b + offset, c + offset});
}

}  // namespace tactooth
