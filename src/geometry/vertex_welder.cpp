// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/vertex_welder.h"

#include <algorithm>

namespace tactooth {

VertexWelder::VertexWelder(std::size_t expectedVertices)
    : table_(std::bit_ceil(std::max<std::size_t>(2 * expectedVertices, 16)), kFree), mask_(table_.size() - 1) {
    vertices_.reserve(expectedVertices);
}

std::uint32_t VertexWelder::insert(const Vec3f& position, std::size_t slot) {
    const auto vertex = static_cast<std::uint32_t>(vertices_.size());
    assert(vertex != kFree);
    vertices_.push_back(position);
    table_[slot] = vertex;
    if (2 * vertices_.size() > table_.size()) grow();
    return vertex;
}

void VertexWelder::grow() {
    table_.assign(2 * table_.size(), kFree);
    mask_ = table_.size() - 1;
    for (std::uint32_t vertex = 0; vertex < vertices_.size(); ++vertex) {
        std::size_t slot = hash(vertices_[vertex]) & mask_;
        while (table_[slot] != kFree) slot = (slot + 1) & mask_;
        table_[slot] = vertex;
    }
}

TriangleMesh weld(std::span<const Vec3f> corners) {
    assert(corners.size() % 3 == 0);
    VertexWelder welder(corners.size() / 6 + 2);  // a closed surface has half as many vertices as triangles
    TriangleMesh mesh;
    mesh.triangles.reserve(corners.size() / 3);
    for (std::size_t corner = 0; corner < corners.size(); corner += 3) {
        const std::uint32_t a = welder.add(corners[corner]);
        const std::uint32_t b = welder.add(corners[corner + 1]);
        const std::uint32_t c = welder.add(corners[corner + 2]);
        mesh.triangles.push_back({a, b, c});
    }
    mesh.vertices = welder.takeVertices();
    return mesh;
}

}  // namespace tactooth
