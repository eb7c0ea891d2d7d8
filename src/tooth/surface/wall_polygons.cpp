// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/wall_polygons.h"

#include <bit>

namespace tactooth {
namespace {

/// Voxels; a wall triangle lies within sqrt(3) * 1.5 of either node of its lattice edge ...
constexpr double kTriangleReach = 2.6;
/// ... and within sqrt(1.5^2 + 1.5^2 + 0.5^2) of the nearer one.
constexpr double kNearerReach = 2.2;
/// The nodes of a row that lie in the brick.
constexpr unsigned kInBrick = ((1U << kBrickSide) - 1) << 1;
constexpr std::uint16_t kNoCell = 0xFFFF;

}  // namespace

/// What the distances of a row's nodes to the tooth's surface tell of the edges that begin there or end there.
class WallPolygons::RowInTooth {
public:
    RowInTooth(const BrickNeighbourhood::ToothRow& row, double spacing)
        : isFar_(row.above(static_cast<float>(kNearerReach * spacing))),
          isBeyond_(row.above(static_cast<float>(kTriangleReach * spacing))),
          isDeep_(row.below(static_cast<float>(-kTriangleReach * spacing))),
          isInside_(row.below(0)) {}

    /// Of the next nodes along x.
    [[nodiscard]] RowInTooth next() const {
        RowInTooth moved = *this;
        for (unsigned* bits : {&moved.isFar_, &moved.isBeyond_, &moved.isDeep_, &moved.isInside_}) *bits >>= 1;
        return moved;
    }
    /// `crossed`: edges from this row to `ends`, at whose first nodes `removed` tells of the cavity.
    [[nodiscard]] Edges edges(unsigned crossed, unsigned removed, const RowInTooth& ends) const {
        const unsigned outside = (isFar_ & ends.isFar_) | isBeyond_ | ends.isBeyond_;
        // Behind the wall is the solid node, or the removed one if the solid one lies outside the tooth.
        const unsigned firstIsBehind = (~removed & isInside_) | (removed & ~ends.isInside_);
        return {crossed & ~outside, crossed & ~outside & ~(isDeep_ | ends.isDeep_), firstIsBehind};
    }

private:
    unsigned isFar_, isBeyond_, isDeep_, isInside_;
};

WallPolygons::WallPolygons(const BrickNeighbourhood& nodes, double spacing) {
    cellAt_.fill(kNoCell);
    if (nodes.isDeeperThan(static_cast<float>(kTriangleReach * spacing))) {
        addDeepInTooth(nodes);
    } else {
        addAroundSurface(nodes, spacing);
    }
}

void WallPolygons::addDeepInTooth(const BrickNeighbourhood& nodes) {
    for (int z = 0; z < kBrickSide; ++z) {
        for (int y = 0; y < kBrickSide; ++y) {
            const unsigned removed = nodes.removedRow(y, z);
            const int row = BrickNeighbourhood::index(-1, y, z);
            add<0>(nodes, row, {(removed ^ removed >> 1) & kInBrick, 0, ~removed});
            add<1>(nodes, row, {(removed ^ nodes.removedRow(y + 1, z)) & kInBrick, 0, ~removed});
            add<2>(nodes, row, {(removed ^ nodes.removedRow(y, z + 1)) & kInBrick, 0, ~removed});
        }
    }
}

void WallPolygons::addAroundSurface(const BrickNeighbourhood& nodes, double spacing) {
    const auto inTooth = [&](int y, int z) { return RowInTooth(nodes.toothRow(y, z), spacing); };
    for (int z = 0; z < kBrickSide; ++z) {
        for (int y = 0; y < kBrickSide; ++y) {
            const unsigned removed = nodes.removedRow(y, z);
            const unsigned onX = (removed ^ removed >> 1) & kInBrick;
            const unsigned onY = (removed ^ nodes.removedRow(y + 1, z)) & kInBrick;
            const unsigned onZ = (removed ^ nodes.removedRow(y, z + 1)) & kInBrick;
            if ((onX | onY | onZ) == 0) continue;
            const int row = BrickNeighbourhood::index(-1, y, z);
            const RowInTooth here = inTooth(y, z);
            if (onX != 0) add<0>(nodes, row, here.edges(onX, removed, here.next()));
            if (onY != 0) add<1>(nodes, row, here.edges(onY, removed, inTooth(y + 1, z)));
            if (onZ != 0) add<2>(nodes, row, here.edges(onZ, removed, inTooth(y, z + 1)));
        }
    }
}

template <int kAxis>
void WallPolygons::add(const BrickNeighbourhood& nodes, int row, const Edges& edges) {
    constexpr int kU = BrickNeighbourhood::kStep[(kAxis + 1) % 3];
    constexpr int kV = BrickNeighbourhood::kStep[(kAxis + 2) % 3];
    isAtSurface_ |= edges.atSurface != 0;
    for (unsigned left = edges.crossed; left != 0; left &= left - 1) {
        const int x = std::countr_zero(left);
        const int node = row + x;
        WallPolygon& polygon = polygons_[polygonCount_++];
        polygon.node = static_cast<std::uint16_t>(node);
        polygon.axis = kAxis;
        polygon.isReversed = nodes.isRemoved(node);
        polygon.isAtSurface = (edges.atSurface >> x & 1) != 0;
        const bool isFirstBehind = (edges.beforeBoundary >> x & 1) != 0;
        polygon.tag =
            static_cast<SurfaceTag>(nodes.material(isFirstBehind ? node : node + BrickNeighbourhood::kStep[kAxis]));
        const std::array<int, 4> cells = {node - kU - kV, node - kV, node, node - kU};
        for (int i = 0; i < 4; ++i) polygon.corners[polygon.isReversed ? 3 - i : i] = numberOfCell(cells[i]);
    }
}

std::uint16_t WallPolygons::numberOfCell(int cell) {
    std::uint16_t& number = cellAt_[cell];
    if (number == kNoCell) {
        number = static_cast<std::uint16_t>(cellCount_);
        cells_[cellCount_++] = static_cast<std::uint16_t>(cell);
    }
    return number;
}

}  // namespace tactooth
