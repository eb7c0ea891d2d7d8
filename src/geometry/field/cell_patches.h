// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace tactooth {

inline constexpr int kCellEdges = 12;

/// How a surface passes through a grid cell, from the signs at its eight corners. Corner number: x + 2 y + 4 z. Edge
/// number: 4 axis + u + 2 v, with u and v the position of the edge along the next two axes (cyclic).
struct CellPatches {
    std::array<std::int8_t, kCellEdges> patchOfEdge{};  ///< the patch that crosses an edge, -1 if none does
    int count = 0;  ///< number of patches: closed chains of crossings around the cell, at most four
};

/// `inside` (0..255): bit c is set if corner c is inside. On a face with two diagonally opposite inside corners, these
/// are separate; both cells at a face decide alike.
[[nodiscard]] const CellPatches& cellPatches(unsigned inside);

/// Corner of edge `edge` with the lower (`end` 0) or higher (1) coordinate along the edge's axis.
[[nodiscard]] constexpr int edgeCorner(int edge, int end) {
    const int axis = edge / 4, u = (axis + 1) % 3, v = (axis + 2) % 3;
    return (end << axis) | ((edge & 1) << u) | (((edge >> 1) & 1) << v);
}

/// The edge along `axis` that has `corner` as one of its ends.
[[nodiscard]] constexpr int cornerEdge(int corner, int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return 4 * axis + ((corner >> u) & 1) + 2 * ((corner >> v) & 1);
}

/// True if the four corners of the face `side` (0 low, 1 high) of `axis` alternate.
[[nodiscard]] constexpr bool isAmbiguousFace(unsigned inside, int axis, int side) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3, base = side << axis;
    const auto at = [&](int i, int j) { return (inside >> (base | (i << u) | (j << v))) & 1u; };
    return at(0, 0) == at(1, 1) && at(1, 0) == at(0, 1) && at(0, 0) != at(1, 0);
}

}  // namespace tactooth
