// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/cavity_wall.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "collision/narrow/lane_flags.h"
#include "geometry/util/assert.h"
#include "tooth/surface/wall_loops.h"
#include "tooth/surface/wall_polygons.h"

// Dual contouring; wall_vertices.cpp and wall_loops.cpp name the sources. Differences: each brick makes its wall by
// itself, and neighbouring walls meet in equal bits. A quad is split along the diagonal that bends the surface less.

namespace tactooth {
namespace {

/// A measure that grows with the angle between the two triangles on either side of the diagonal from `a` to `c`.
Float8 bendsAlong(const Vec3x8& a, const Vec3x8& b, const Vec3x8& c, const Vec3x8& d) {
    const Vec3x8 diagonal = c - a;
    const Vec3x8 one = cross(b - a, diagonal);
    const Vec3x8 two = cross(diagonal, d - a);
    const Float8 cosine = dotAsEigen(one, two);
    const Float8 minus = zero8() - cosine;
    const Float8 squares = dotAsEigen(one, one) * dotAsEigen(two, two);
    return whereLess(zero8(), squares, minus * max(cosine, minus) / squares, zero8());
}

/// Assembles the wall: its vertices, and the triangles of its polygons.
class WallBuilder {
public:
    WallBuilder(const BrickNeighbourhood& nodes, const NodePoints& points, const BrickKey& key)
        : nodes_(nodes), points_(points), key_(key) {}

    /// `vertexAt(i)` returns vertex i as a WallLoops::Vertex.
    template <class VertexAt>
    void addVertices(std::size_t count, const VertexAt& vertexAt) {
        wall_.mesh.vertices.resize(count + 1);  // one spare vertex: see foldsOf
        for (std::size_t i = 0; i < count; ++i) wall_.mesh.vertices[i] = vertexAt(i).point.template cast<float>();
    }

    void addTriangles(std::span<const WallPolygon> polygons, std::span<const WallLoops::Fan> fans) {
        std::size_t count = 2 * (polygons.size() - fans.size());
        for (const WallLoops::Fan& fan : fans) count += static_cast<std::size_t>(fan.size) - 2;
        wall_.mesh.triangles.resize(count);
        wall_.tags.resize(count);
        std::size_t next = 0;
        for (const WallLoops::Fan& fan : fans) {
            TACTOOTH_ASSERT(fan.polygon >= next && fan.polygon < polygons.size());
            addQuads(polygons.subspan(next, fan.polygon - next));
            addFan(fan, polygons[fan.polygon].tag);
            next = fan.polygon + 1;
        }
        addQuads(polygons.subspan(next));
        TACTOOTH_ASSERT(triangleCount_ == count);
    }

    /// Fills the lists that exist only if some polygon may cross the tooth's surface.
    template <class VertexAt>
    void addAtSurface(std::span<const WallPolygon> polygons, std::span<const WallLoops::Fan> fans,
                      const VertexAt& vertexAt) {
        const std::size_t count = wall_.mesh.triangles.size();
        wall_.places.reserve(count);
        wall_.faceIds.reserve(count);
        auto fan = fans.begin();
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            const WallPolygon& polygon = polygons[i];
            const bool isFan = fan != fans.end() && fan->polygon == i;
            const int triangles = isFan ? fan++->size - 2 : 2;
            const std::uint64_t id = 8 * numberOf(polygon.node, polygon.axis);  // room for at most six triangles
            const auto place = polygon.isAtSurface ? CavityWall::Place::AtSurface : CavityWall::Place::Inside;
            for (int t = 1; t <= triangles; ++t) {
                wall_.places.push_back(place);
                wall_.faceIds.push_back(id + static_cast<std::uint64_t>(t));
            }
        }
        TACTOOTH_ASSERT(fan == fans.end());
        TACTOOTH_ASSERT(wall_.places.size() == count && wall_.faceIds.size() == count);
        addSides(vertexAt);
    }

    CavityWall take() {
        TACTOOTH_ASSERT(!wall_.mesh.vertices.empty());
        wall_.mesh.vertices.pop_back();
        return std::move(wall_);
    }

private:
    /// A number that is unique in the lattice for a node and one of its 16 kinds of items.
    [[nodiscard]] std::uint64_t numberOf(int node, int kind) const {
        constexpr std::uint64_t kMask = (1U << 20) - 1;
        TACTOOTH_ASSERT(kind >= 0 && kind < 16);
        const auto coordinate = [](int brick, int local) {
            return static_cast<std::uint64_t>(kBrickSide * brick + local + (1 << 19)) & kMask;
        };
        const auto [x, y, z] = BrickNeighbourhood::placeOf(node);
        return (coordinate(key_.x, x) << 40 | coordinate(key_.y, y) << 20 | coordinate(key_.z, z)) << 4 |
               static_cast<std::uint64_t>(kind);
    }

    template <class VertexAt>
    void addSides(const VertexAt& vertexAt) {
        const std::size_t count = wall_.mesh.vertices.size() - 1;
        wall_.sides.assign(count, 0);
        wall_.vertexIds.resize(count);
        std::vector<bool> isSeen(count);
        for (std::size_t t = 0; t < wall_.places.size(); ++t) {
            if (wall_.places[t] != CavityWall::Place::AtSurface) continue;
            for (const std::uint32_t i : wall_.mesh.triangles[t]) {
                if (isSeen[i]) continue;
                isSeen[i] = true;
                const WallLoops::Vertex vertex = vertexAt(i);
                wall_.sides[i] = sideOf(vertex.point, vertex.cell);
                wall_.vertexIds[i] = numberOf(vertex.cell, vertex.kind);
            }
        }
    }

    /// A distance field changes by no more than the displacement. If a corner of the cell is farther from the tooth's
    /// surface than from the vertex, both are on the same side.
    [[nodiscard]] std::int8_t sideOf(const Vec3& point, int cell) const {
        for (int corner = 0; corner < 8; ++corner) {
            const int node = cell + BrickNeighbourhood::index(corner & 1, corner >> 1 & 1, corner >> 2) -
                             BrickNeighbourhood::index(0, 0, 0);
            const double distance = nodes_.tooth(node);
            if (std::abs(distance) > (points_.point(node) - point).norm() * (1 + 1e-6)) return distance < 0 ? -1 : 1;
        }
        return 0;
    }

    /// Splits quads along the diagonal that bends the surface less.
    void addQuads(std::span<const WallPolygon> polygons) {
        for (std::size_t first = 0; first < polygons.size(); first += 8) {
            const auto eight = polygons.subspan(first, std::min<std::size_t>(8, polygons.size() - first));
            unsigned folds = foldsOf(eight);
            for (const WallPolygon& polygon : eight) {
                const unsigned from = folds & 1;
                const auto corner = [&](unsigned i) { return std::uint32_t{polygon.corners[(from + i) % 4]}; };
                addTriangle({corner(0), corner(1), corner(2)}, polygon.tag);
                addTriangle({corner(0), corner(2), corner(3)}, polygon.tag);
                folds >>= 1;
            }
        }
    }
    /// Which of eight quads are to be split from their second to their fourth corner: one bit each.
    [[nodiscard]] unsigned foldsOf(std::span<const WallPolygon> eight) const {
        TACTOOTH_ASSERT(!eight.empty() && eight.size() <= 8);
        std::array<Vec3x8, 4> corners;
        for (int i = 0; i < 4; ++i) {
            std::array<const float*, 8> points;
            for (std::size_t lane = 0; lane < 8; ++lane) {
                const WallPolygon& polygon = eight[std::min(lane, eight.size() - 1)];
                points[lane] = wall_.mesh.vertices[polygon.corners[i]].data();
            }
            const auto [x, y, z, nextX] = Float8::loadFours(points);  // reads past the vertex
            corners[i] = {x, y, z};
        }
        const auto& [a, b, c, d] = corners;
        return lessEqual(one8(), isLess(bendsAlong(b, c, d, a), bendsAlong(a, b, c, d)));
    }
    void addFan(const WallLoops::Fan& fan, SurfaceTag tag) {
        TACTOOTH_ASSERT(fan.size > 4 && fan.size <= static_cast<int>(fan.corners.size()));
        for (int i = 1; i + 1 < fan.size; ++i) {
            addTriangle({fan.corners[0], fan.corners[i], fan.corners[i + 1]}, tag);
        }
    }
    void addTriangle(const Triangle& triangle, SurfaceTag tag) {
        TACTOOTH_ASSERT(triangleCount_ < wall_.mesh.triangles.size());
        TACTOOTH_ASSERT(std::max({triangle[0], triangle[1], triangle[2]}) + 1 < wall_.mesh.vertices.size());
        wall_.mesh.triangles[triangleCount_] = triangle;
        wall_.tags[triangleCount_++] = tag;
    }

    const BrickNeighbourhood& nodes_;
    const NodePoints& points_;
    const BrickKey key_;
    CavityWall wall_;
    std::size_t triangleCount_ = 0;
};

}  // namespace

CavityWall extractWall(const BrickNeighbourhood& nodes, const Lattice& lattice, const BrickKey& key) {
    if (!nodes.hasBoundary()) return {};
    WallPolygons found(nodes, lattice.spacing());
    const std::span<WallPolygon> polygons = found.polygons();
    const std::span<const std::uint16_t> cells = found.cells();
    if (polygons.empty()) return {};
    TACTOOTH_ASSERT(cells.size() >= 4);  // a polygon has four corners
    const NodePoints points(lattice, key);
    const WallVertices ofCells(nodes, cells);
    WallBuilder wall(nodes, points, key);
    const auto build = [&](std::size_t count, std::span<const WallLoops::Fan> fans, const auto& vertexAt) {
        wall.addVertices(count, vertexAt);
        wall.addTriangles(polygons, fans);
        if (found.isAtSurface()) wall.addAtSurface(polygons, fans, vertexAt);
    };
    if (ofCells.areSimple()) {
        build(cells.size(), {}, [&](std::size_t i) {
            return WallLoops::Vertex{ofCells.point(i, points), cells[i], 0};
        });
    } else {
        const WallLoops loops(nodes, points, cells, ofCells, polygons);
        build(loops.vertices().size(), loops.fans(), [&](std::size_t i) { return loops.vertices()[i]; });
    }
    return wall.take();
}

void CavityWall::validate() const {
    TACTOOTH_ASSERT(tags.size() == mesh.triangles.size());
    for (const Vec3f& vertex : mesh.vertices) TACTOOTH_ASSERT(vertex.allFinite());
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t corner : triangle) TACTOOTH_ASSERT(corner < mesh.vertices.size());
    }
    TACTOOTH_ASSERT(places.empty() || places.size() == mesh.triangles.size());
    TACTOOTH_ASSERT(faceIds.size() == places.size());
    TACTOOTH_ASSERT(sides.size() == vertexIds.size());
    TACTOOTH_ASSERT(places.empty() ? sides.empty() : sides.size() == mesh.vertices.size());
    TACTOOTH_ASSERT(std::set(faceIds.begin(), faceIds.end()).size() == faceIds.size());
    std::set<std::uint32_t> atSurface;
    for (std::size_t t = 0; t < places.size(); ++t) {
        if (places[t] == Place::AtSurface) atSurface.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
    }
    std::set<std::uint64_t> ids;
    for (const std::uint32_t vertex : atSurface) {
        TACTOOTH_ASSERT(ids.insert(vertexIds[vertex]).second);
        TACTOOTH_ASSERT(sides[vertex] >= -1 && sides[vertex] <= 1);
    }
}

}  // namespace tactooth
