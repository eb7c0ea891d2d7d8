// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/vertex_welder.h"

#include <algorithm>
#include <array>

#include "geometry/util/assert.h"

namespace tactooth {

VertexWelder::VertexWelder(std::size_t expectedVertices)
    : table_(std::bit_ceil(std::max<std::size_t>(2 * expectedVertices, 16)), kFree), mask_(table_.size() - 1) {
    vertices_.reserve(expectedVertices);
}

void VertexWelder::addAll(std::span<const Vec3f> positions, std::uint32_t* numbers) {
    TACTOOTH_ASSERT(positions.empty() || numbers != nullptr);
    // Table and vertices of a scanned tooth do not fit into the second-level cache. While the memory fetches the data
    // for one position, the next positions are hashed.
    constexpr std::size_t kBlock = 48;
    std::array<std::size_t, kBlock> slots;
    while (!positions.empty()) {
        const std::span<const Vec3f> block = positions.first(std::min(kBlock, positions.size()));
        for (std::size_t i = 0; i < block.size(); ++i) {
            slots[i] = hash(block[i]);
            __builtin_prefetch(&table_[slots[i] & mask_]);
        }
        for (std::size_t i = 0; i < block.size(); ++i) {
            const std::uint32_t vertex = table_[slots[i] & mask_];
            if (vertex != kFree) __builtin_prefetch(&vertices_[vertex]);
        }
        for (std::size_t i = 0; i < block.size(); ++i) *numbers++ = add(block[i], slots[i]);
        positions = positions.subspan(block.size());
    }
}

std::uint32_t VertexWelder::insert(const Vec3f& position, std::size_t slot) {
    const auto vertex = static_cast<std::uint32_t>(vertices_.size());
    TACTOOTH_ASSERT(vertex != kFree);
    TACTOOTH_ASSERT(slot < table_.size() && table_[slot] == kFree);
    vertices_.push_back(position);
    table_[slot] = vertex;
    if (2 * vertices_.size() > table_.size()) grow();
    TACTOOTH_ASSERT(2 * vertices_.size() <= table_.size());
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
    TACTOOTH_ASSERT(corners.size() % 3 == 0);
    VertexWelder welder(corners.size() / 6 + 2);  // a closed surface has half as many vertices as triangles
    TriangleMesh mesh;
    mesh.triangles.resize(corners.size() / 3);
    if (!corners.empty()) welder.addAll(corners, mesh.triangles.front().data());
    mesh.vertices = welder.takeVertices();
    return mesh;
}

}  // namespace tactooth
