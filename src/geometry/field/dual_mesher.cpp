// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// G. M. Nielson, "Dual marching cubes", IEEE Visualization 2004. Ours differs in one point. Where both cells at an
// ambiguous face join its two segments, the two segments would become one edge with four polygons. There each segment
// gets its own vertex, so that the result is a manifold for every field.
#include "geometry/field/dual_mesher.h"

#include <algorithm>
#include <cassert>

#include "geometry/field/cell_patches.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

Index3 cornerOffset(int corner) { return {corner & 1, (corner >> 1) & 1, corner >> 2}; }

}  // namespace

DualMesher::DualMesher(const SampledGrid& grid) : grid_(grid), cells_(grid.cells()) {
    firstVertex_.assign(static_cast<std::size_t>(cells_.x()) * cells_.y() * cells_.z(), 0);
    inside_.assign(firstVertex_.size(), 0);
    forEachActiveCell([&](const Index3& cell) { addVertices(cell); });
    forEachActiveCell([&](const Index3& cell) { addPolygons(cell); });
}

template <class Function>
void DualMesher::forEachActiveCell(const Function& function) const {
    constexpr int kBlock = SampledGrid::kBlock;
    const Index3& blocks = grid_.blocks();
    for (int block = 0; block < blocks.prod(); ++block) {
        const Index3 at(block % blocks.x(), block / blocks.x() % blocks.y(), block / (blocks.x() * blocks.y()));
        if (!grid_.isActive(at)) continue;
        for (int i = 0; i < kBlock * kBlock * kBlock; ++i) {
            function(Index3(at * kBlock + Index3(i % kBlock, i / kBlock % kBlock, i / (kBlock * kBlock))));
        }
    }
}

Vec3 DualMesher::crossing(const Index3& cell, int edge) const {
    const Index3 low = cell + cornerOffset(edgeCorner(edge, 0)), high = cell + cornerOffset(edgeCorner(edge, 1));
    const double a = grid_.value(low), b = grid_.value(high);
    TACTOOTH_ASSERT((a < 0) != (b < 0));
    return grid_.position(low) + a / (a - b) * (grid_.position(high) - grid_.position(low));
}

int DualMesher::patchAt(const Index3& cell, int edge) const {
    return cellPatches(inside_[cellNumber(cell)]).patchOfEdge[edge];
}

void DualMesher::addVertices(const Index3& cell) {
    unsigned inside = 0;
    for (int corner = 0; corner < 8; ++corner) {
        if (grid_.value(cell + cornerOffset(corner)) < 0) inside |= 1u << corner;
    }
    const std::size_t number = cellNumber(cell);
    inside_[number] = static_cast<std::uint8_t>(inside);
    firstVertex_[number] = static_cast<std::uint32_t>(mesh_.vertices.size());
    const CellPatches& patches = cellPatches(inside);
    for (int patch = 0; patch < patches.count; ++patch) {
        Vec3 sum = Vec3::Zero();
        int crossings = 0;
        for (int edge = 0; edge < kCellEdges; ++edge) {
            if (patches.patchOfEdge[edge] != patch) continue;
            sum += crossing(cell, edge);
            ++crossings;
        }
        TACTOOTH_ASSERT(crossings >= 3);
        mesh_.vertices.push_back(sum / crossings);
    }
}

/// The polygons of the three grid edges at the cell's lowest corner.
void DualMesher::addPolygons(const Index3& cell) {
    const unsigned inside = inside_[cellNumber(cell)];
    for (int axis = 0; axis < 3; ++axis) {
        const bool low = (inside & 1u) != 0, high = ((inside >> (1 << axis)) & 1u) != 0;
        const bool hasNeighbours = cell[(axis + 1) % 3] > 0 && cell[(axis + 2) % 3] > 0;
        if (low != high && hasNeighbours) addPolygon(cell, axis, low);
    }
}

void DualMesher::addPolygon(const Index3& cell, int axis, bool outwardAlongAxis) {
    // The four cells around the edge, counter-clockwise seen from the positive end of the axis: steps back along the
    // next axes.
    constexpr int kBack[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    const auto cellAround = [&](int i) {
        Index3 around = cell;
        around[(axis + 1) % 3] -= kBack[i][0];
        around[(axis + 2) % 3] -= kBack[i][1];
        return around;
    };
    std::vector<std::uint32_t> polygon;
    int pivot = -1;  // index of a face vertex: no other polygon can have the same diagonals
    for (int i = 0; i < 4; ++i) {
        const Index3 here = cellAround(i), next = cellAround((i + 1) % 4);
        const int edge = 4 * axis + kBack[i][0] + 2 * kBack[i][1];
        TACTOOTH_ASSERT(patchAt(here, edge) >= 0);
        polygon.push_back(firstVertex_[cellNumber(here)] + static_cast<std::uint32_t>(patchAt(here, edge)));
        if (const auto vertex = vertexOnFace(here, next, edge)) {
            pivot = static_cast<int>(polygon.size());
            polygon.push_back(*vertex);
        }
    }
    if (!outwardAlongAxis) {
        std::ranges::reverse(polygon);
        if (pivot >= 0) pivot = static_cast<int>(polygon.size()) - 1 - pivot;
    }
    store(polygon, pivot);
}

void DualMesher::store(const std::vector<std::uint32_t>& polygon, int pivot) {
    if (pivot < 0) {
        TACTOOTH_ASSERT(polygon.size() == 4);
        mesh_.quads.push_back({polygon[0], polygon[1], polygon[2], polygon[3]});
        return;
    }
    const std::size_t corners = polygon.size();
    TACTOOTH_ASSERT(corners > 4 && static_cast<std::size_t>(pivot) < corners);
    for (std::size_t i = 1; i + 1 < corners; ++i) {
        mesh_.triangles.push_back({polygon[pivot], polygon[(pivot + i) % corners], polygon[(pivot + i + 1) % corners]});
    }
}

/// The vertex of the surface's segment on the face between the neighbours `a` and `b` that ends at `edgeOfA`, if the
/// face needs one.
std::optional<std::uint32_t> DualMesher::vertexOnFace(const Index3& a, const Index3& b, int edgeOfA) {
    const int across = a.x() != b.x() ? 0 : a.y() != b.y() ? 1 : 2;
    const int side = b[across] > a[across] ? 1 : 0;
    const unsigned inside = inside_[cellNumber(a)];
    if (!isAmbiguousFace(inside, across, side)) return std::nullopt;

    const int along = edgeOfA / 4, other = 3 - along - across, flip = 1 << across;
    const int end = ((inside >> edgeCorner(edgeOfA, 0)) & 1u) != 0 ? 0 : 1;
    const int corner = edgeCorner(edgeOfA, end);                // the segment cuts off this inside corner
    const int opposite = corner ^ (1 << along) ^ (1 << other);  // the other segment cuts off this one
    const bool joinedInA = patchAt(a, edgeOfA) == patchAt(a, cornerEdge(opposite, along));
    const bool joinedInB =
        patchAt(b, cornerEdge(corner ^ flip, along)) == patchAt(b, cornerEdge(opposite ^ flip, along));
    if (!joinedInA || !joinedInB) return std::nullopt;

    const bool aIsLower = side == 1;
    const std::pair key(cellNumber(aIsLower ? a : b), 8 * across + (aIsLower ? corner : corner ^ flip));
    const auto [place, isNew] = faceVertices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (isNew) mesh_.vertices.push_back((crossing(a, edgeOfA) + crossing(a, cornerEdge(corner, other))) / 2);
    return place->second;
}

}  // namespace tactooth
