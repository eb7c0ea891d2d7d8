// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/util/assert.h"
#include "tooth/surface/wall_polygons.h"
#include "tooth/volume/brick_neighbourhood.h"

namespace tactooth {

/// How far the triangles of a brick's wall can reach beyond its first and last node, voxels: one cell, and rounding.
inline constexpr double kWallReach = 1.01;

/// The points of the nodes in and around a brick. Neighbouring bricks compute the same bits. Points counted from each
/// brick's own corner would differ in the last bits of a double, which a float keeps where a coordinate is almost 0.
class NodePoints {
public:
    NodePoints(const Lattice& lattice, const BrickKey& key) : spacing_(lattice.spacing()) {
        for (int i = 0; i < BrickNeighbourhood::kSide; ++i) onDiagonal_[i] = lattice.node(key, {i - 1, i - 1, i - 1});
    }
    /// The point of a node, by its number in the neighbourhood, mm.
    [[nodiscard]] Vec3 point(int node) const {
        const auto [x, y, z] = BrickNeighbourhood::placeOf(node);
        return {onDiagonal_[x + 1].x(), onDiagonal_[y + 1].y(), onDiagonal_[z + 1].z()};
    }
    [[nodiscard]] double spacing() const { return spacing_; }

private:
    std::array<Vec3, BrickNeighbourhood::kSide> onDiagonal_;
    double spacing_;
};

/// Places one vertex in each cell that the boundary passes through, by the planes in which the boundary crosses the
/// edges of the cell. The vertex lies within its cell.
class WallVertices {
public:
    WallVertices(const BrickNeighbourhood& nodes, std::span<const std::uint16_t> cells);

    /// The vertex of cell `number` of the list, mm.
    [[nodiscard]] Vec3 point(std::size_t number, const NodePoints& nodes) const {
        TACTOOTH_ASSERT(number < cells_.size());
        const Vec3 inCell(places_[0][number], places_[1][number], places_[2][number]);
        return nodes.point(cells_[number]) + nodes.spacing() * (inCell + Vec3::Constant(0.5));
    }
    /// Whether each cell has one loop, which crosses no face twice.
    [[nodiscard]] bool areSimple() const { return areSimple_; }

private:
    void placeEight(const BrickNeighbourhood& nodes, std::size_t first);

    static constexpr std::size_t kCapacity = (WallPolygons::kMaxCellCount + 7) / 8 * 8;

    std::span<const std::uint16_t> cells_;
    std::array<std::array<float, kCapacity>, 3> places_;  // voxels from the middle of the cell; padded to eights
    bool areSimple_ = true;
};

}  // namespace tactooth
