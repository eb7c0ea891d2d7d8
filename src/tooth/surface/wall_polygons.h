// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "collision/bvh/surface.h"
#include "tooth/volume/brick_neighbourhood.h"

namespace tactooth {

/// The polygon around one lattice edge that the border of the removed region crosses.
struct WallPolygon {
    std::array<std::uint16_t, 4> corners;  ///< counter-clockwise, seen from the cavity
    std::uint16_t node;                    ///< in the neighbourhood: where the edge begins
    std::uint8_t axis;                     ///< of the edge
    SurfaceTag tag;                        ///< the material behind it
    bool isReversed;                       ///< the edge begins in the removed region
    bool isAtSurface;                      ///< it may cross the tooth's surface
};

/// The polygons of a brick's wall that may lie in the tooth or at its surface, in the order of the lattice, and the
/// cells that they have corners in.
class WallPolygons {
public:
    WallPolygons(const BrickNeighbourhood& nodes, double spacing);

    /// `corners` are numbers of `cells`.
    [[nodiscard]] std::span<WallPolygon> polygons() { return {polygons_.data(), polygonCount_}; }
    /// The nodes at which they begin, in the order in which the polygons come to them.
    [[nodiscard]] std::span<const std::uint16_t> cells() const { return {cells_.data(), cellCount_}; }
    /// Whether some polygon may cross the tooth's surface.
    [[nodiscard]] bool isAtSurface() const { return isAtSurface_; }

    static constexpr int kMaxPolygons = 3 * kBrickNodes;
    static constexpr int kMaxCellCount = (kBrickSide + 1) * (kBrickSide + 1) * (kBrickSide + 1);

private:
    class RowInTooth;
    void addDeepInTooth(const BrickNeighbourhood& nodes);
    void addAroundSurface(const BrickNeighbourhood& nodes, double spacing);

    /// One bit an edge, that of its first node as in `BrickNeighbourhood::removedRow`.
    struct Edges {
        unsigned crossed;
        unsigned atSurface;       ///< see WallPolygon
        unsigned beforeBoundary;  ///< the material of the polygon is that at the first node
    };
    template <int kAxis>
    void add(const BrickNeighbourhood& nodes, int row, const Edges& edges);
    [[nodiscard]] std::uint16_t numberOfCell(int cell);

    // Left as they are until they are filled.
    std::array<WallPolygon, kMaxPolygons> polygons_;
    std::array<std::uint16_t, kMaxCellCount> cells_;
    std::array<std::uint16_t, BrickNeighbourhood::kNodes> cellAt_;  // number of the cell that begins at a node
    std::size_t polygonCount_ = 0;
    std::size_t cellCount_ = 0;
    bool isAtSurface_ = false;
};

}  // namespace tactooth
