// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/wall_loops.h"

#include <algorithm>
#include <bit>

#include "geometry/util/assert.h"

// Source: S. Schaefer, T. Ju, J. Warren, "Manifold Dual Contouring", IEEE TVCG 13, 2007 (see cell_topology.h).
// Differences: where two loops of one cell share a face, the face gets a vertex too, so that no edge has four
// triangles. Loops that share a face, be they two or one that comes back, are the two sides of a ridge or gap thinner
// than a voxel. Their planes meet beyond it, so that the QEF would put the vertex on the wrong side and fold the wall.
// There the vertex of a loop is the mean of its crossings, which the nodes in between keep apart.

namespace tactooth {

WallLoops::WallLoops(const BrickNeighbourhood& nodes, const NodePoints& points, std::span<const std::uint16_t> cells,
                     const WallVertices& ofCells, std::span<WallPolygon> polygons)
    : nodes_(nodes), points_(points), cells_(cells), ofCells_(ofCells), vertexOfCell_(cells.size(), kNone) {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        WallPolygon& polygon = polygons[i];
        Fan fan{i, {}, 0};
        addCorners(polygon, fan);
        TACTOOTH_ASSERT(fan.size >= 4 && fan.size <= static_cast<int>(fan.corners.size()));
        const auto begin = fan.corners.begin();
        const auto end = begin + fan.size;
        if (polygon.isReversed) std::reverse(begin, end);
        if (fan.size == 4) {
            std::copy(begin, end, polygon.corners.begin());
        } else {
            const auto isOnFace = [&](std::uint16_t vertex) { return vertices_[vertex].kind >= kMaxLoops; };
            const auto first = std::find_if(begin, end, isOnFace);
            TACTOOTH_ASSERT(first != end);
            std::rotate(begin, first, end);
            fans_.push_back(fan);
        }
    }
}

/// Adds the corners in the order of a polygon whose edge begins in the solid.
void WallLoops::addCorners(const WallPolygon& polygon, Fan& fan) {
    const int u = (polygon.axis + 1) % 3;
    const int v = (polygon.axis + 2) % 3;
    const int beforeU = polygon.node - BrickNeighbourhood::kStep[u];
    const int beforeV = polygon.node - BrickNeighbourhood::kStep[v];
    // For each of the four cells: the number of the edge in it. For each face between a cell and the next: the node at
    // which it begins, and its axis.
    const std::array<int, 4> edges = {cellEdge(polygon.axis, 1, 1), cellEdge(polygon.axis, 0, 1),
                                      cellEdge(polygon.axis, 0, 0), cellEdge(polygon.axis, 1, 0)};
    const std::array<std::pair<int, int>, 4> faces = {
        {{beforeV, u}, {polygon.node, v}, {polygon.node, u}, {beforeU, v}}};
    for (int i = 0; i < 4; ++i) {
        const std::size_t number = polygon.corners[polygon.isReversed ? 3 - i : i];
        TACTOOTH_ASSERT(number < cells_.size());
        TACTOOTH_ASSERT(fan.size < static_cast<int>(fan.corners.size()));
        const int cell = cells_[number];
        const unsigned removed = nodes_.removedCorners(cell);
        const CellLoops& loops = kCellLoops[removed];
        fan.corners[fan.size++] = kCellCrossings[removed].isSimple
                                      ? vertexOfCell(number)
                                      : vertexOfLoop(cell, loops, loops.loopOfEdge[edges[i]]);
        if (loops.hasAmbiguousFace) addVertexOnFace(faces[i].first, faces[i].second, polygon, fan);
    }
}

std::uint16_t WallLoops::vertexOfCell(std::size_t number) {
    TACTOOTH_ASSERT(number < vertexOfCell_.size());
    std::uint16_t& vertex = vertexOfCell_[number];
    if (vertex == kNone) vertex = add(ofCells_.point(number, points_), cells_[number], 0);
    return vertex;
}

/// For a cell that is not simple: the mean of the loop's crossings, see the top of the file.
std::uint16_t WallLoops::vertexOfLoop(int cell, const CellLoops& loops, int loop) {
    TACTOOTH_ASSERT(loop >= 0 && loop < loops.count);
    if (const std::uint16_t known = find(cell, loop); known != kNone) return known;
    int count = 0;
    Vec3 sum = Vec3::Zero();
    for (unsigned edges = loops.edgesOfLoop[loop]; edges != 0; edges &= edges - 1, ++count) {
        const int edge = std::countr_zero(edges);
        const int first = cellEdgeCorners(edge)[0];
        sum += crossing(cell + BrickNeighbourhood::index(first & 1, first >> 1 & 1, first >> 2) -
                            BrickNeighbourhood::index(0, 0, 0),
                        edge / 4);
    }
    TACTOOTH_ASSERT(count >= 3);  // a loop crosses at least three edges of its cell
    return add(sum / count, cell, loop);
}

/// If the boundary crosses the face twice: adds the vertex on the face, on the side of the polygon's edge.
void WallLoops::addVertexOnFace(int face, int faceAxis, const WallPolygon& polygon, Fan& fan) {
    const int u = (faceAxis + 1) % 3;
    const int v = (faceAxis + 2) % 3;
    const int stepU = BrickNeighbourhood::kStep[u];
    const int stepV = BrickNeighbourhood::kStep[v];
    const auto isRemoved = [&](int corner) {
        return nodes_.isRemoved(face + (corner & 1) * stepU + (corner >> 1) * stepV);
    };
    if (isRemoved(0) == isRemoved(1) || isRemoved(0) == isRemoved(2) || isRemoved(0) != isRemoved(3)) return;
    const int solid = polygon.node + (polygon.isReversed ? BrickNeighbourhood::kStep[polygon.axis] : 0);
    const bool isAfterU = BrickNeighbourhood::placeOf(solid)[u] != BrickNeighbourhood::placeOf(face)[u];
    const bool isAfterV = BrickNeighbourhood::placeOf(solid)[v] != BrickNeighbourhood::placeOf(face)[v];
    const int kind = kMaxLoops + 2 * faceAxis + (isAfterV ? 1 : 0);
    std::uint16_t vertex = find(face, kind);
    if (vertex == kNone) {
        const Vec3 onU = crossing(face + (isAfterV ? stepV : 0), u);
        const Vec3 onV = crossing(face + (isAfterU ? stepU : 0), v);
        vertex = add(0.5 * (onU + onV), face, kind);
    }
    TACTOOTH_ASSERT(fan.size < static_cast<int>(fan.corners.size()));
    fan.corners[fan.size++] = vertex;
}

std::uint16_t WallLoops::find(int cell, int kind) const {
    const auto isIt = [&](const Vertex& vertex) { return vertex.cell == cell && vertex.kind == kind; };
    const auto found = std::find_if(vertices_.begin(), vertices_.end(), isIt);
    return found != vertices_.end() ? static_cast<std::uint16_t>(found - vertices_.begin()) : kNone;
}

std::uint16_t WallLoops::add(const Vec3& point, int cell, int kind) {
    TACTOOTH_ASSERT(vertices_.size() < kNone);
    TACTOOTH_ASSERT(kind >= 0 && kind < 16);
    TACTOOTH_ASSERT(point.allFinite());
    vertices_.push_back({point, static_cast<std::uint16_t>(cell), kind});
    return static_cast<std::uint16_t>(vertices_.size() - 1);
}

Vec3 WallLoops::crossing(int node, int axis) const {
    return points_.point(node) + nodes_.boundary(node, axis).place * points_.spacing() * Vec3::Unit(axis);
}

}  // namespace tactooth
