// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/io/read_mesh.h"
#include "geometry/mesh/polygon_triangulator.h"
#include "geometry/mesh/position_rounding.h"
#include "geometry/mesh/vertex_welder.h"
#include "geometry/util/assert.h"
#include "geometry/util/expected.h"
#include "geometry/util/message.h"

namespace tactooth {

/// Builds a mesh from the vertices and faces of a file that numbers its vertices. Vertices at equal positions become
/// one; faces of more than three corners are split within their outline.
class MeshBuilder {
public:
    MeshBuilder(std::size_t expectedVertices, const Vec3& offset) : rounding_(offset), welder_(expectedVertices) {}

    /// False if the position is not finite in single precision.
    bool addVertex(const Vec3& position) {
        const Vec3f rounded = rounding_.round(position);
        if (!rounded.allFinite()) return false;
        vertices_.push_back(welder_.add(rounded));
        return true;
    }

    /// Number of vertices that the file has given so far, equal ones counted separately.
    [[nodiscard]] std::size_t vertices() const { return vertices_.size(); }

    /// Begins a face or a strip: its corners follow.
    void beginFace() { corners_.clear(); }
    /// `vertex` is less than vertices().
    void addCorner(std::size_t vertex) {
        TACTOOTH_ASSERT(vertex < vertices_.size());
        corners_.push_back(vertices_[vertex]);
    }
    [[nodiscard]] std::size_t corners() const { return corners_.size(); }
    /// Adds the corners as a polygon (fewer than three corners give nothing). Returns null, or the problem.
    const MessageText* endFace() {
        if (corners_.size() == 3) {
            mesh_.triangles.push_back({corners_[0], corners_[1], corners_[2]});
            return nullptr;
        }
        return corners_.size() < 3 ? nullptr : triangulator_.split(welder_.vertices(), corners_, mesh_.triangles);
    }
    /// Adds the corners as a triangle strip: each corner from the third on makes a triangle with the two before it, and
    /// every other triangle is reversed. Triangles with two equal corners only connect parts of the strip and are
    /// skipped.
    void endStrip();

    [[nodiscard]] bool hasTriangles() const { return !mesh_.triangles.empty(); }
    [[nodiscard]] const PositionRounding& rounding() const { return rounding_; }
    /// The builder must not be used afterwards.
    [[nodiscard]] TriangleMesh take();

private:
    PositionRounding rounding_;
    VertexWelder welder_;
    PolygonTriangulator triangulator_;
    std::vector<std::uint32_t> vertices_;  ///< welded number of each vertex of the file
    std::vector<std::uint32_t> corners_;   ///< welded numbers of the present face
    TriangleMesh mesh_;
};

/// Result of one reading of a file.
struct ReadAttempt {
    Expected<ReadMesh> mesh;
    PositionRounding rounding;
};

/// Reads a file without an offset. If its coordinates are too large for single precision, reads it again with an
/// offset, and adds an import note that begins with `name`.
[[nodiscard]] Expected<ReadMesh> readWithOffset(const std::string& name,
                                                const std::function<ReadAttempt(const Vec3& offset)>& read);

}  // namespace tactooth
