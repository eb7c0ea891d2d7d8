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
#include "geometry/util/expected.h"
#include "geometry/util/message.h"

namespace tactooth {

/// Puts a mesh together from the vertices and faces of a file that numbers its vertices. Vertices at equal positions
/// become one; faces of more than three corners are split within their outline.
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

    /// How many vertices the file has given so far, equal ones counted each.
    [[nodiscard]] std::size_t vertices() const { return vertices_.size(); }

    /// Begins a face, or a strip: its corners follow.
    void beginFace() { corners_.clear(); }
    /// `vertex` is less than vertices().
    void addCorner(std::size_t vertex) { corners_.push_back(vertices_[vertex]); }
    [[nodiscard]] std::size_t corners() const { return corners_.size(); }
    /// Takes the corners as a polygon (one of fewer than three gives nothing). Null, or what is wrong with it.
    const MessageText* endFace() {
        if (corners_.size() == 3) {
            mesh_.triangles.push_back({corners_[0], corners_[1], corners_[2]});
            return nullptr;
        }
        return corners_.size() < 3 ? nullptr : triangulator_.split(welder_.vertices(), corners_, mesh_.triangles);
    }
    /// Takes the corners as a strip: each corner from the third on makes a triangle with the two before it, and every
    /// other one is turned. Those of two equal corners only lead from one place to another.
    void endStrip();

    [[nodiscard]] bool hasTriangles() const { return !mesh_.triangles.empty(); }
    [[nodiscard]] const PositionRounding& rounding() const { return rounding_; }
    /// The builder is used up.
    [[nodiscard]] TriangleMesh take();

private:
    PositionRounding rounding_;
    VertexWelder welder_;
    PolygonTriangulator triangulator_;
    std::vector<std::uint32_t> vertices_;  ///< of the file, as welded
    std::vector<std::uint32_t> corners_;   ///< of the face at hand, as welded
    TriangleMesh mesh_;
};

/// What one reading of a file gave.
struct ReadAttempt {
    Expected<ReadMesh> mesh;
    PositionRounding rounding;
};

/// Reads a file with no offset, and again with one where its coordinates are too large for single precision; says so
/// in a remark that begins with `name`.
[[nodiscard]] Expected<ReadMesh> readWithOffset(const std::string& name,
                                                const std::function<ReadAttempt(const Vec3& offset)>& read);

}  // namespace tactooth
