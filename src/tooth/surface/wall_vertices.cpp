// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/wall_vertices.h"

#include <algorithm>
#include <bit>

#include "collision/narrow/lane_flags.h"
#include "geometry/util/assert.h"
#include "tooth/surface/cell_qef.h"
#include "tooth/surface/cell_topology.h"

// T. Ju, F. Losasso, S. Schaefer, J. Warren, "Dual Contouring of Hermite Data", SIGGRAPH 2002. Differs from the paper:
// crossings and normals of the lattice edges come from the distance and the gradient that each node keeps from the bur
// that passed nearest, which are exact planes; a sharp edge's vertex stays in the room of its cell (roomOf), on the
// planes as far as they are in it; and eight cells are done at a time, since one by one they took most of what a wall
// costs.

namespace tactooth {
namespace {

/// Voxels; vertices of sharp edges stay so far on their own sides of the face between neighbouring cells, so that they
/// neither change places nor meet. More makes fewer walls that cross themselves, but puts the vertex of an edge that
/// runs close to a face too far off it (docs/cutting.md).
constexpr double kApart = 0.15;
/// Voxels; how far a vertex may leave its cell through a face that the border does not cross: a sharp edge can poke
/// through it between its corners, and there is no vertex behind it.
constexpr double kPokesOut = kWallReach - 1 - kApart;
/// Bits of a cell's corners on its lower side of each axis.
constexpr std::array<unsigned, 3> kLowCorners = {0x55, 0x33, 0x0F};

/// Where each edge of a cell lies from the middle of the cell; 0 on its own axis.
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
/// From the node where a cell begins to the one where each of its edges does.
constexpr std::array<int, 12> kEdgeNodes = [] {
    std::array<int, 12> nodes{};
    for (int edge = 0; edge < 12; ++edge) {
        const int corner = cellEdgeCorners(edge)[0];
        for (int axis = 0; axis < 3; ++axis) nodes[edge] += (corner >> axis & 1) * BrickNeighbourhood::kStep[axis];
    }
    return nodes;
}();

/// Where the border crosses one edge of each of eight cells.
struct Crossings8 {
    std::array<const float*, 8> edges;  // their places
    std::array<float, 8> along;
    std::array<OctahedralNormal, 8> normals;

    /// From the middles of the cells.
    [[nodiscard]] Vec3x8 points() const {
        const Float8 onAxis = Float8::load(along.data()) - Float8::all(0.5F);
        const auto placeOn = [&](Float8 place) { return whereLess(place * place, Float8::all(0.1F), onAxis, place); };
        const auto [x, y, z, none] = Float8::loadFours(edges);
        return {placeOn(x), placeOn(y), placeOn(z)};
    }
};

/// How far a vertex may be beyond a face of which these corners are inside.
double beyond(unsigned inside, unsigned corners) {
    const bool isCrossed = inside != 0 && inside != corners;
    return isCrossed ? -kApart : kPokesOut;
}

/// Where the vertex of a cell with these corners inside may be, from the middle of the cell: not beyond a face behind
/// which there is another.
Box3 roomOf(unsigned inside) {
    Box3 room;
    for (int axis = 0; axis < 3; ++axis) {
        const unsigned low = kLowCorners[axis];
        room.min()[axis] = -0.5 - beyond(inside & low, low);
        room.max()[axis] = 0.5 + beyond(inside & ~low, ~low & 0xFFU);
    }
    return room;
}

}  // namespace

WallVertices::WallVertices(const BrickNeighbourhood& nodes, std::span<const std::uint16_t> cells) : cells_(cells) {
    TACTOOTH_ASSERT(cells.size() <= kRoom);
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
    // First the memory, all at once: what is computed from it would let it wait.
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

    // A flat border moves its vertices along its normal alone, so that they keep their places.
    const auto [isFlat, points] = planes.flat();
    const Vec3x8 sizes = max(points, Vec3x8::all(0, 0, 0) - points);
    const Float8 farthest = Float8::all(static_cast<float>(0.5 + kPokesOut));
    const Float8 isFar = isLess(farthest, max(sizes.x, max(sizes.y, sizes.z)));
    const Vec3x8 placed = choose(isFar, planes.means(), points);
    placed.x.store(&places_[0][first]);
    placed.y.store(&places_[1][first]);
    placed.z.store(&places_[2][first]);
    for (unsigned sharp = ~lessEqual(one8(), isFlat) & ((1U << lanes) - 1); sharp != 0; sharp &= sharp - 1) {
        const int lane = std::countr_zero(sharp);
        const Vec3f place = planes.nearestPoint(lane, roomOf(nodes.removedCorners(cells[lane])));
        for (int axis = 0; axis < 3; ++axis) places_[axis][first + lane] = place[axis];
    }
}

}  // namespace tactooth
