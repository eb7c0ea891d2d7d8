// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/gl/triangle_buffers.h"

#include <cstddef>

namespace tactooth {

namespace {

/// Binding indices to this target does not change the vertex array's element binding.
constexpr GLenum kAnyTarget = GL_COPY_WRITE_BUFFER;

void allocate(const gl::Buffer& buffer, std::size_t bytes) {
    glBindBuffer(kAnyTarget, buffer.name());
    glBufferData(kAnyTarget, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_DRAW);
}

void growBuffer(gl::Buffer& buffer, std::size_t oldBytes, std::size_t newBytes) {
    gl::Buffer grown = gl::Buffer::make();
    allocate(grown, newBytes);
    glBindBuffer(GL_COPY_READ_BUFFER, buffer.name());
    glCopyBufferSubData(GL_COPY_READ_BUFFER, kAnyTarget, 0, 0, static_cast<GLsizeiptr>(oldBytes));
    buffer = std::move(grown);
}

template <class T>
void write(const gl::Buffer& buffer, std::uint32_t first, std::span<const T> values) {
    glBindBuffer(kAnyTarget, buffer.name());
    glBufferSubData(kAnyTarget, static_cast<GLintptr>(first * sizeof(T)), static_cast<GLsizeiptr>(values.size_bytes()),
                    values.data());
}

}  // namespace

TriangleBuffers::TriangleBuffers(std::uint32_t vertexCapacity, std::uint32_t triangleCapacity)
    : array_(gl::VertexArray::make()),
      vertices_(gl::Buffer::make()),
      triangles_(gl::Buffer::make()),
      vertexCapacity_(vertexCapacity),
      triangleCapacity_(triangleCapacity) {
    allocate(vertices_, vertexCapacity * sizeof(ShadingVertex));
    allocate(triangles_, triangleCapacity * sizeof(Triangle));
    describeVertices();
}

void TriangleBuffers::describeVertices() const {
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.name());
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    constexpr GLsizei kStride = sizeof(ShadingVertex);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ShadingVertex, position)));
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_INT_2_10_10_10_REV, GL_TRUE, kStride, at(offsetof(ShadingVertex, normal)));
    glEnableVertexAttribArray(2);
    glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, kStride, at(offsetof(ShadingVertex, appearances)));
    glBindVertexArray(0);
}

void TriangleBuffers::growVertices(std::uint32_t capacity) {
    growBuffer(vertices_, vertexCapacity_ * sizeof(ShadingVertex), capacity * sizeof(ShadingVertex));
    vertexCapacity_ = capacity;
    describeVertices();
}

void TriangleBuffers::growTriangles(std::uint32_t capacity) {
    growBuffer(triangles_, triangleCapacity_ * sizeof(Triangle), capacity * sizeof(Triangle));
    triangleCapacity_ = capacity;
    describeVertices();
}

void TriangleBuffers::writeVertices(std::uint32_t first, std::span<const ShadingVertex> vertices) const {
    write(vertices_, first, vertices);
}

void TriangleBuffers::writeTriangles(std::uint32_t first, std::span<const Triangle> triangles) const {
    write(triangles_, first, triangles);
}

void TriangleBuffers::draw(std::span<const TriangleRange> ranges) {
    if (ranges.empty()) return;
    counts_.clear();
    offsets_.clear();
    for (const TriangleRange& run : ranges) {
        counts_.push_back(static_cast<GLsizei>(3 * run.count));
        offsets_.push_back(reinterpret_cast<const void*>(std::uintptr_t{run.first} * sizeof(Triangle)));
    }
    glBindVertexArray(array_.name());
    glMultiDrawElements(GL_TRIANGLES, counts_.data(), GL_UNSIGNED_INT, offsets_.data(),
                        static_cast<GLsizei>(ranges.size()));
    glBindVertexArray(0);
}

}  // namespace tactooth
