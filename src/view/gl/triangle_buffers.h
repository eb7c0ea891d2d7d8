// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "view/gl/gl_objects.h"
#include "view/mesh/cluster_culling.h"
#include "view/mesh/shading_mesh.h"

namespace tactooth {

/// Vertices and triangles on the graphics card, in two growing buffers, and the vertex array that reads them.
class TriangleBuffers {
public:
    TriangleBuffers(std::uint32_t vertexCapacity, std::uint32_t triangleCapacity);

    /// Keeps the existing contents.
    void growVertices(std::uint32_t capacity);
    void growTriangles(std::uint32_t capacity);
    void writeVertices(std::uint32_t first, std::span<const ShadingVertex> vertices) const;
    void writeTriangles(std::uint32_t first, std::span<const Triangle> triangles) const;
    void draw(std::span<const TriangleRange> ranges);

private:
    void describeVertices() const;

    gl::VertexArray array_;
    gl::Buffer vertices_;
    gl::Buffer triangles_;
    std::uint32_t vertexCapacity_;
    std::uint32_t triangleCapacity_;
    std::vector<GLsizei> counts_;
    std::vector<const void*> offsets_;
};

}  // namespace tactooth
