// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/wall_vertices.h"

#include <algorithm>
#include <bit>

#include "collision/narrow/lane_flags.h"
#include "geometry/util/assert.h"
#include "tooth/surface/cell_qef.h"
#include "tooth/surface/cell_topology.h"

// Source: T. Ju, F. Losasso, S. Schaefer, J. Warren, "Dual Contouring of Hermite Data", SIGGRAPH 2002. Differences:
// crossings and normals come from the swept envelope of the bur, which gives exact planes. A vertex stays within its
// cell, so that the wall does not pass through itself (T. Ju, T. Udeshi, "Intersection-free Contouring on an Octree
// Grid", Pacific Graphics 2006), and on the planes as far as they pass through the cell. Eight cells are processed at a
// time, since single cells took most of the time of a wall.

namespace tactooth {
namespace {

/// Voxels. Vertices of sharp edges keep this distance from a face that the boundary crosses, so that vertices on both
/// sides of it do not meet. A larger value moves the vertex of an edge near a face too far off the edge.
constexpr double kFaceGap = 0.15;
/// Bits of the corners on the lower side of each axis.
constexpr std::array<unsigned, 3> kLowCorners = {0x55, 0x33, 0x0F};

/// Position of each edge from the middle of its cell. 0 on its own axis.
using EdgePlace = std::array<float, 4>;
constexpr std::array<EdgePlace, 12> kEdgePlaces = [] {
    std::array<EdgePlace, 12> places{};
    for (int edge = 0; edge < 12; ++edge) {
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == edge / 4) continue;
            places[edge][axis] = (cellEdgeCorners(edge)[0] >> axis & 1) != 0 ? 0.5F : -0.5F;
        }
    }
    return places;
}();
/// Step from the first node of a cell to the first node of each edge.
constexpr std::array<int, 12> kEdgeNodes = [] {
    std::array<int, 12> nodes{};
    for (int edge = 0; edge < 12; ++edge) {
        const int corner = cellEdgeCorners(edge)[0];
        for (int axis = 0; axis < 3; ++axis) nodes[edge] += (corner >> axis & 1) * BrickNeighbourhood::kStep[axis];
    }
    return nodes;
}();

/// The crossing of the boundary with one edge of each of eight cells.
struct Crossings8 {
    std::array<const float*, 8> edges;  // their positions
    std::array<float, 8> along;
    std::array<OctahedralNormal, 8> normals;

    /// Crossing points from the middles of the cells.
    [[nodiscard]] Vec3x8 points() const {
        const Float8 onAxis = Float8::load(along.data()) - Float8::all(0.5F);
        const auto placeOn = [&](Float8 place) { return whereLess(place * place, Float8::all(0.1F), onAxis, place); };
        const auto [x, y, z, none] = Float8::loadFours(edges);
        return {placeOn(x), placeOn(y), placeOn(z)};
    }
};

/// The bounds of the vertex of a cell with these inside corners, from the middle of the cell, in cells.
Box3 boundsOf(unsigned inside) {
    const auto gap = [&](unsigned corners) {
        const unsigned insideFace = inside & corners;
        const bool isCrossed = insideFace != 0 && insideFace != corners;
        return isCrossed ? kFaceGap : 0;
    };
    Box3 bounds;
    for (int axis = 0; axis < 3; ++axis) {
        const unsigned low = kLowCorners[axis];
        bounds.min()[axis] = gap(low) - 0.5;
        bounds.max()[axis] = 0.5 - gap(~low & 0xFFU);
    }
    return bounds;
}

}  // namespace

WallVertices::WallVertices(const BrickNeighbourhood& nodes, std::span<const std::uint16_t> cells) : cells_(cells) {
    TACTOOTH_ASSERT(cells.size() <= kCapacity);
    for (std::size_t first = 0; first < cells.size(); first += 8) placeEight(nodes, first);
}

void WallVertices::placeEight(const BrickNeighbourhood& nodes, std::size_t first) {
    const std::size_t lanes = std::min<std::size_t>(8, cells_.size() - first);
    std::array<int, 8> cells;
    std::array<const CellCrossings*, 8> crossed;
    std::array<float, 8> counts;
    int most = 0;
    for (std::size_t lane = 0; lane < 8; ++lane) {
        cells[lane] = cells_[first + std::min(lane, lanes - 1)];
        crossed[lane] = &kCellCrossings[nodes.removedCorners(cells[lane])];
        TACTOOTH_ASSERT(crossed[lane]->count >= 3);  // the boundary passes through the cell
        counts[lane] = crossed[lane]->count;
        most = std::max<int>(most, crossed[lane]->count);
        areSimple_ &= crossed[lane]->isSimple;
    }
    // Reads the memory first, all at once, so that the arithmetic does not wait for it.
    std::array<Crossings8, 12> crossings;
    for (int i = 0; i < most; ++i) {
        for (int lane = 0; lane < 8; ++lane) {
            const int edge = crossed[lane]->edges[i];
            const HermiteSample boundary = nodes.boundary(cells[lane] + kEdgeNodes[edge], edge / 4);
            crossings[i].edges[lane] = kEdgePlaces[edge].data();
            crossings[i].along[lane] = boundary.place;
            crossings[i].normals[lane] = boundary.normal;
        }
    }
    CellQef8 planes;
    const Float8 count = Float8::load(counts.data());
    for (int i = 0; i < most; ++i) {
        const Float8 isThere = isLess(Float8::all(static_cast<float>(i)), count);
        planes.add(OctahedralNormal::unpack(crossings[i].normals), crossings[i].points(), isThere);
    }

    // A flat boundary moves its vertices along its normal only, so that they stay evenly spaced.
    const auto [isFlat, points] = planes.flat();
    const Vec3x8 placed = max(Vec3x8::all(-0.5F, -0.5F, -0.5F), min(Vec3x8::all(0.5F, 0.5F, 0.5F), points));
    placed.x.store(&places_[0][first]);
    placed.y.store(&places_[1][first]);
    placed.z.store(&places_[2][first]);
    for (unsigned sharp = ~lessEqual(one8(), isFlat) & ((1U << lanes) - 1); sharp != 0; sharp &= sharp - 1) {
        const int lane = std::countr_zero(sharp);
        const Vec3f place = planes.nearestPoint(lane, boundsOf(nodes.removedCorners(cells[lane])));
        for (int axis = 0; axis < 3; ++axis) places_[axis][first + lane] = place[axis];
    }
}

}  // namespace tactooth
