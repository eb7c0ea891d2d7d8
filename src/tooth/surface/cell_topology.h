// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "geometry/util/assert.h"

namespace tactooth {

/// How the boundary of a region passes through a cell, for each set of inside corners. Corner number = x + 2 y + 4 z.
/// Edge number = 4 * axis + u + 2 v, where (u, v) is the position on the two axes that follow cyclically.
///
/// The boundary is one or more closed loops over the faces of the cell. Each loop gets a vertex of its own, which keeps
/// the surface manifold (S. Schaefer, T. Ju, J. Warren, "Manifold Dual Contouring", 2007; G. Nielson, "Dual Marching
/// Cubes", 2004). An ambiguous face has two inside corners at opposite ends. These are joined there: both cells at the
/// face decide alike, and a convex region passes through the face in this way.
struct CellLoops {
    std::array<std::int8_t, 12> loopOfEdge;    ///< -1: the boundary does not cross this edge
    std::array<std::uint16_t, 4> edgesOfLoop;  ///< one bit an edge
    std::int8_t count;
    bool hasAmbiguousFace;  ///< with two inside corners at opposite ends
};

[[nodiscard]] constexpr int cellEdge(int axis, int u, int v) {
    TACTOOTH_ASSERT(axis >= 0 && axis < 3);
    TACTOOTH_ASSERT((u == 0 || u == 1) && (v == 0 || v == 1));
    return 4 * axis + u + 2 * v;
}
/// First and second corner of an edge, in the direction of its axis.
[[nodiscard]] constexpr std::array<int, 2> cellEdgeCorners(int edge) {
    TACTOOTH_ASSERT(edge >= 0 && edge < 12);
    const int axis = edge / 4;
    const int first = (edge & 1) << ((axis + 1) % 3) | (edge >> 1 & 1) << ((axis + 2) % 3);
    return {first, first | 1 << axis};
}

namespace detail {

constexpr bool crossesBoundary(int inside, int edge) {
    const auto [a, b] = cellEdgeCorners(edge);
    return ((inside >> a) & 1) != ((inside >> b) & 1);
}

/// Gives all edges of two loops the same number.
constexpr void join(CellLoops& loops, int first, int second) {
    const std::int8_t from = loops.loopOfEdge[first];
    const std::int8_t to = loops.loopOfEdge[second];
    TACTOOTH_ASSERT(from >= 0 && to >= 0);
    for (std::int8_t& loop : loops.loopOfEdge) {
        if (loop == from) loop = to;
    }
}

constexpr void joinOnFace(CellLoops& loops, int inside, int axis, int side) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    // The four edges of the face. Two of them meet at each corner.
    const std::array<int, 2> edgesU = {cellEdge(u, 0, side), cellEdge(u, 1, side)};  // by the position on v
    const std::array<int, 2> edgesV = {cellEdge(v, side, 0), cellEdge(v, side, 1)};  // by the position on u
    std::array<int, 4> crossed{};
    int count = 0;
    for (const int edge : {edgesU[0], edgesU[1], edgesV[0], edgesV[1]}) {
        if (crossesBoundary(inside, edge)) crossed[count++] = edge;
    }
    if (count == 2) join(loops, crossed[0], crossed[1]);
    if (count != 4) return;
    loops.hasAmbiguousFace = true;
    for (int corner = 0; corner < 4; ++corner) {
        const int number = side << axis | (corner & 1) << u | (corner >> 1) << v;
        if (((inside >> number) & 1) == 0) join(loops, edgesU[corner >> 1], edgesV[corner & 1]);
    }
}

constexpr CellLoops loopsOf(int inside) {
    CellLoops loops{};
    for (int edge = 0; edge < 12; ++edge) {
        loops.loopOfEdge[edge] = static_cast<std::int8_t>(crossesBoundary(inside, edge) ? edge : -1);
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) joinOnFace(loops, inside, axis, side);
    }
    std::array<std::int8_t, 12> renumbered{};
    renumbered.fill(-1);
    for (std::int8_t& loop : loops.loopOfEdge) {
        if (loop < 0) continue;
        if (renumbered[loop] < 0) renumbered[loop] = loops.count++;
        TACTOOTH_ASSERT(loops.count <= 4);
        loop = renumbered[loop];
    }
    for (int edge = 0; edge < 12; ++edge) {
        const std::int8_t loop = loops.loopOfEdge[edge];
        if (loop >= 0) loops.edgesOfLoop[loop] = static_cast<std::uint16_t>(loops.edgesOfLoop[loop] | 1U << edge);
    }
    return loops;
}

constexpr std::array<CellLoops, 256> allLoops() {
    std::array<CellLoops, 256> table{};
    for (int inside = 0; inside < 256; ++inside) table[inside] = loopsOf(inside);
    return table;
}

}  // namespace detail

/// Indexed by the bits of the inside corners.
inline constexpr std::array<CellLoops, 256> kCellLoops = detail::allLoops();

/// The edges of a cell that the boundary crosses.
struct CellCrossings {
    /// Ordered by z, then y of their first corners, then axis and x. Unused entries repeat the first one.
    std::array<std::uint8_t, 12> edges;
    std::uint8_t count;
    bool isSimple;  ///< one loop, which crosses no face twice
};

namespace detail {

constexpr CellCrossings crossingsOf(int inside) {
    CellCrossings crossings{};
    for (int place = 0; place < 24; ++place) {  // x + 2 axis + 6 y + 12 z
        const int axis = place / 2 % 3;
        const std::array<int, 3> corner = {place % 2, place / 6 % 2, place / 12};
        if (corner[axis] != 0) continue;
        const int edge = cellEdge(axis, corner[(axis + 1) % 3], corner[(axis + 2) % 3]);
        if (crossesBoundary(inside, edge)) crossings.edges[crossings.count++] = static_cast<std::uint8_t>(edge);
    }
    for (int i = crossings.count; i < 12; ++i) crossings.edges[i] = crossings.edges[0];
    crossings.isSimple = kCellLoops[inside].count == 1 && !kCellLoops[inside].hasAmbiguousFace;
    return crossings;
}

constexpr std::array<CellCrossings, 256> allCrossings() {
    std::array<CellCrossings, 256> table{};
    for (int inside = 0; inside < 256; ++inside) table[inside] = crossingsOf(inside);
    return table;
}

}  // namespace detail

/// Indexed by the bits of the inside corners.
inline constexpr std::array<CellCrossings, 256> kCellCrossings = detail::allCrossings();

}  // namespace tactooth
