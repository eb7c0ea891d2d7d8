// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/tool_shape.h"

namespace tactooth {

ToolShape::ToolShape(TriangleMesh mesh) : part_(std::move(mesh)) {
    const TriangleMesh& own = part_.mesh();
    corners_.reserve(own.triangles.size());
    normals_.reserve(own.triangles.size());
    for (std::size_t i = 0; i < own.triangles.size(); ++i) {
        const Triangle& t = own.triangles[i];
        corners_.push_back({own.vertices[t[0]], own.vertices[t[1]], own.vertices[t[2]]});
        const Vec3 area = own.areaVector(i);
        const double length = area.norm();
        normals_.push_back(length > 0 ? Vec3f((area / length).cast<float>()) : Vec3f(Vec3f::Zero()));
    }
    if (own.empty()) return;
    centre_ = part_.tree().box().center();
    for (const Vec3f& vertex : own.vertices) radius_ = std::max(radius_, (vertex.cast<double>() - centre_).norm());
}

}  // namespace tactooth
