// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tooth/surface/cell_topology.h"
#include "tooth/surface/wall_polygons.h"
#include "tooth/surface/wall_vertices.h"

namespace tactooth {

/// The corners of a wall's polygons where cells have several loops or ambiguous faces. Each loop has a vertex of its
/// own, and so has each side of an ambiguous face. Few bricks have such cells.
class WallLoops {
public:
    /// Turns the `corners` of `polygons` from numbers of `cells` into numbers of `vertices()`.
    WallLoops(const BrickNeighbourhood& nodes, const NodePoints& points, std::span<const std::uint16_t> cells,
              const WallVertices& ofCells, std::span<WallPolygon> polygons);

    struct Vertex {
        Vec3 point;          ///< mm
        std::uint16_t cell;  ///< the node at which the cell begins, or the face
        int kind;            ///< distinguishes the vertices of one cell, below 16
    };
    [[nodiscard]] std::span<const Vertex> vertices() const { return vertices_; }

    /// A polygon with five to eight corners, to be split into triangles around the first one. The first corner is a
    /// vertex on a face: two polygons would share a diagonal between the cells at its sides.
    struct Fan {
        std::size_t polygon;
        std::array<std::uint16_t, 8> corners;
        int size;
    };
    /// In the order of the polygons.
    [[nodiscard]] std::span<const Fan> fans() const { return fans_; }

private:
    static constexpr std::uint16_t kNone = 0xFFFF;
    static constexpr int kMaxLoops = 4;  ///< in one cell; higher kinds belong to faces

    void addCorners(const WallPolygon& polygon, Fan& fan);
    std::uint16_t vertexOfCell(std::size_t number);
    std::uint16_t vertexOfLoop(int cell, const CellLoops& loops, int loop);
    void addVertexOnFace(int face, int faceAxis, const WallPolygon& polygon, Fan& fan);
    [[nodiscard]] std::uint16_t find(int cell, int kind) const;
    std::uint16_t add(const Vec3& point, int cell, int kind);
    [[nodiscard]] Vec3 crossing(int node, int axis) const;

    const BrickNeighbourhood& nodes_;
    const NodePoints& points_;
    const std::span<const std::uint16_t> cells_;
    const WallVertices& ofCells_;
    std::vector<std::uint16_t> vertexOfCell_;  // for simple cells
    std::vector<Vertex> vertices_;
    std::vector<Fan> fans_;
};

}  // namespace tactooth
