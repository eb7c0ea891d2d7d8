// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/cavity_wall.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "tooth/cell_planes.h"
#include "tooth/cell_topology.h"

// T. Ju, F. Losasso, S. Schaefer, J. Warren, "Dual Contouring of Hermite Data", SIGGRAPH 2002, with a vertex for each
// round of a cell (see cell_topology.h). Differs from the paper: crossings and normals of the lattice edges come from
// the distance and the gradient that each node keeps from the bur that passed nearest, which are exact planes; and
// where two rounds of one cell share a face, the border gets a vertex on that face, so that no edge has four triangles.
// A sharp edge's vertex stays in the room of its cell (roomOf), on the planes as far as they are in it.
// Two rounds of one cell are the two sides of a ridge or a gap thinner than a voxel, whose planes meet beyond it:
// vertices placed by them would change sides and fold the wall over, so there each round has the mean of its own
// crossings, which the nodes between keep apart.

namespace tactooth {
namespace {

/// Voxels; vertices of sharp edges stay so far on their own sides of the face between neighbouring cells, so that they
/// neither change places nor meet. More makes fewer walls that cross themselves, but puts the vertex of an edge that
/// runs close to a face too far off it (docs/cutting.md).
constexpr double kApart = 0.15;
/// Voxels; how far a vertex may leave its cell through a face that the border does not cross: a sharp edge can poke
/// through it between its corners, and there is no vertex behind it.
constexpr double kPokesOut = kWallReach - 1 - kApart;
/// Voxels; a wall triangle lies within sqrt(3) * 1.5 of either node of its lattice edge ...
constexpr double kTriangleReach = 2.6;
/// ... and within sqrt(1.5^2 + 1.5^2 + 0.5^2) of the nearer one.
constexpr double kNearerReach = 2.2;
/// Bits of a cell's corners on its lower side of each axis.
constexpr std::array<unsigned, 3> kLowCorners = {0x55, 0x33, 0x0F};

using Place = BrickNeighbourhood::Place;

/// An axis that is known when the program is compiled: places in a row then need no memory.
template <int axis>
constexpr std::integral_constant<int, axis> kAxis;

Place moved(Place place, int axis, int step) {
    place[axis] += step;
    return place;
}

/// A lattice edge on one axis as the four cells around it see it: the last of them, which begins where the edge does,
/// and those before it on the two next axes, by how much their middles and their numbers are lower. Places have 1 as
/// their fourth number.
struct EdgeInCells {
    float along[4];
    float step[4][4];
    int before[4];
};
constexpr int kCellSide = kBrickSide + 1;  ///< cells that begin in a brick or before it
constexpr int kCellRow = kCellSide;
constexpr int kCellLayer = kCellSide * kCellSide;
constexpr float kFirstCorner[4] = {-0.5F, -0.5F, -0.5F, 1};  ///< of a cell, from its middle
constexpr std::array<EdgeInCells, 3> kEdgeInCells = {{
    {{1, 0, 0, 0},
     {{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 1, 1, 0}},
     {0, kCellRow, kCellLayer, kCellRow + kCellLayer}},
    {{0, 1, 0, 0}, {{0, 0, 0, 0}, {0, 0, 1, 0}, {1, 0, 0, 0}, {1, 0, 1, 0}}, {0, kCellLayer, 1, 1 + kCellLayer}},
    {{0, 0, 1, 0}, {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}}, {0, 1, kCellRow, 1 + kCellRow}},
}};
Eigen::Map<const Eigen::Array4f> four(const float (&numbers)[4]) { return Eigen::Map<const Eigen::Array4f>(numbers); }

class WallExtractor {
public:
    WallExtractor(const BrickNeighbourhood& nodes, const Lattice& lattice, const BrickKey& key)
        : nodes_(nodes), key_(key), lattice_(lattice), spacing_(lattice.spacing()) {}

    CavityWall run() {
        reserve();
        sumPlanes();
        forCrossedEdges(0, [this](const Place& a, auto axis) { addPolygon<axis>(a); });
        return std::move(wall_);
    }

private:
    static constexpr std::uint32_t kNoVertex = ~0U;
    static constexpr std::uint16_t kNoCell = 0xFFFF;
    static constexpr int kRounds = 4;  ///< at most, in one cell

    /// Room for a flat wall through the brick: more is rare.
    void reserve() {
        constexpr std::size_t kVertices = 2 * kCellSide * kCellSide;
        constexpr std::size_t kTriangles = 4 * kBrickSide * kBrickSide;
        wall_.mesh.vertices.reserve(kVertices);
        wall_.vertexIds.reserve(kVertices);
        wall_.sides.reserve(kVertices);
        wall_.mesh.triangles.reserve(kTriangles);
        wall_.tags.reserve(kTriangles);
        wall_.places.reserve(kTriangles);
        wall_.faceIds.reserve(kTriangles);
        cells_.reserve(kVertices);
        edges_.reserve(kVertices);
    }

    /// Calls `visit(place, axis)` for each lattice edge that the border crosses, from node `first` (0, or -1: the nodes
    /// around the brick, too) on each axis to the last one that begins in the brick. In the order of the lattice, so
    /// that neighbours come to the edges of a cell that they share in the same order.
    template <class Visit>
    void forCrossedEdges(int first, const Visit& visit) const {
        const unsigned inBrick = (1U << (kBrickSide + 1)) - (first == 0 ? 2U : 1U);
        const unsigned around = first == 0 ? inBrick : (1U << BrickNeighbourhood::kSide) - 1;
        const int last = first == 0 ? kBrickSide - 1 : kBrickSide;
        const auto visitRow = [&](unsigned crossed, int y, int z, auto axis) {
            for (; crossed != 0; crossed &= crossed - 1) visit({std::countr_zero(crossed) - 1, y, z}, axis);
        };
        for (int z = first; z <= last; ++z) {
            for (int y = first; y <= last; ++y) {
                const unsigned row = nodes_.removedRow(y, z);
                visitRow((row ^ row >> 1) & inBrick, y, z, kAxis<0>);
                if (y < kBrickSide) visitRow((row ^ nodes_.removedRow(y + 1, z)) & around, y, z, kAxis<1>);
                if (z < kBrickSide) visitRow((row ^ nodes_.removedRow(y, z + 1)) & around, y, z, kAxis<2>);
            }
        }
    }

    /// A cell that the border passes through.
    struct Cell {
        CellPlanes planes;
        std::uint32_t vertex = kNoVertex;  ///< of the only round through it
    };

    /// A lattice edge that the border crosses.
    struct CrossedEdge {
        Place from;
        int axis;
        unsigned cells;  ///< around it that count
        BorderCrossing border;
    };

    /// Hands the plane in which the border crosses an edge to all cells around it.
    void sumPlanes() {
        cellAt_.fill(kNoCell);
        // First the memory, all at once: what is computed from it would let it wait.
        forCrossedEdges(-1, [this](const Place& a, auto axis) {
            edges_.push_back({a, axis, cellsAround(a, (axis + 1) % 3, (axis + 2) % 3), nodes_.border(a, axis)});
        });
        for (const CrossedEdge& edge : edges_) {
            const CellPlanes::Plane plane(edge.border.normal.unpackSingle());
            const EdgeInCells& seen = kEdgeInCells[edge.axis];
            const Eigen::Array4f point = four(kFirstCorner) + edge.border.place * four(seen.along);
            const int last = cellNumber(edge.from);
            for (unsigned left = edge.cells; left != 0; left &= left - 1) {
                const int i = std::countr_zero(left);
                cellNumbered(last - seen.before[i]).planes.add(plane, point + four(seen.step[i]));
            }
        }
    }
    /// Which of the four cells around an edge lie in the brick or before it, as EdgeInCells counts them.
    static unsigned cellsAround(const Place& a, int u, int v) {
        unsigned cells = 0xF;
        if (a[u] == kBrickSide) cells &= 0xA;
        if (a[v] == kBrickSide) cells &= 0xC;
        if (a[u] < 0) cells &= 0x5;
        if (a[v] < 0) cells &= 0x3;
        return cells;
    }
    static int cellNumber(const Place& p) { return p[0] + 1 + kCellSide * (p[1] + 1 + kCellSide * (p[2] + 1)); }
    Cell& cellNumbered(int place) {
        std::uint16_t& number = cellAt_[place];
        if (number == kNoCell) {
            number = static_cast<std::uint16_t>(cells_.size());
            cells_.emplace_back();
        }
        return cells_[number];
    }

    [[nodiscard]] bool isRemoved(const Place& p) const {
        return (nodes_.removedRow(p[1], p[2]) >> (p[0] + 1) & 1) != 0;
    }
    /// Neighbours compute the vertices on their border each for itself. Counted from a brick's own corner these would
    /// differ in the last bits of a double, which a float keeps where a coordinate is all but 0.
    [[nodiscard]] Vec3 position(const Place& p) const { return lattice_.node(key_, p); }

    /// A number that this node of the lattice alone has, with room for 16 kinds of things that belong to it.
    [[nodiscard]] std::uint64_t numberOf(const Place& p, int kind) const {
        constexpr std::uint64_t kMask = (1U << 20) - 1;
        const auto coordinate = [](int brick, int local) {
            return static_cast<std::uint64_t>(kBrickSide * brick + local + (1 << 19)) & kMask;
        };
        return (coordinate(key_.x, p[0]) << 40 | coordinate(key_.y, p[1]) << 20 | coordinate(key_.z, p[2])) << 4 |
               static_cast<std::uint64_t>(kind);
    }

    [[nodiscard]] Vec3 crossingAt(const Place& a, int axis) const {
        return position(a) + nodes_.border(a, axis).place * spacing_ * Vec3::Unit(axis);
    }

    [[nodiscard]] unsigned insideBits(const Place& cell) const {
        const auto pair = [&](int dy, int dz) {
            return nodes_.removedRow(cell[1] + dy, cell[2] + dz) >> (cell[0] + 1) & 3U;
        };
        return pair(0, 0) | pair(1, 0) << 2 | pair(0, 1) << 4 | pair(1, 1) << 6;
    }

    /// The vertex of the round of `cell` that crosses lattice edge (`a`, `axis`).
    std::uint32_t vertexOf(const Place& cell, const CellRounds& rounds, const Place& a, int axis) {
        if (rounds.count > 1) {
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            return vertexOfRound(cell, rounds, rounds.roundOfEdge[cellEdge(axis, a[u] - cell[u], a[v] - cell[v])]);
        }
        Cell& known = cellNumbered(cellNumber(cell));
        if (known.vertex == kNoVertex) known.vertex = addVertex(placeVertex(cell, known), numberOf(cell, 0), cell);
        return known.vertex;
    }
    /// One of several: see the top, each keeps to its own side.
    std::uint32_t vertexOfRound(const Place& cell, const CellRounds& rounds, int round) {
        const std::uint64_t id = numberOf(cell, round);
        if (const auto known = vertexById(id)) return *known;
        int count = 0;
        Vec3 sum = Vec3::Zero();
        for (unsigned edges = rounds.edgesOfRound[round]; edges != 0; edges &= edges - 1, ++count) {
            const int edge = std::countr_zero(edges);
            const int first = cellEdgeCorners(edge)[0];
            sum += crossingAt({cell[0] + (first & 1), cell[1] + (first >> 1 & 1), cell[2] + (first >> 2)}, edge / 4);
        }
        return addVertex(sum / count, id, cell);
    }
    /// Of the few that are not kept with their cells.
    [[nodiscard]] std::optional<std::uint32_t> vertexById(std::uint64_t id) const {
        const auto known = std::find(wall_.vertexIds.begin(), wall_.vertexIds.end(), id);
        if (known == wall_.vertexIds.end()) return std::nullopt;
        return static_cast<std::uint32_t>(known - wall_.vertexIds.begin());
    }

    [[nodiscard]] Vec3 placeVertex(const Place& cell, const Cell& known) const {
        Vec3f place;
        if (const auto flat = known.planes.pointOfFlat()) {
            // A flat border moves its vertices along its normal alone, so that they keep their places.
            const bool isNear = flat->cwiseAbs().maxCoeff() <= static_cast<float>(0.5 + kPokesOut);
            place = isNear ? *flat : known.planes.mean();
        } else {
            place = known.planes.nearestPoint(roomOf(cell));
        }
        return position(cell) + spacing_ * (place.cast<double>() + Vec3::Constant(0.5));
    }

    /// Where the vertex of a cell may be, from the middle of the cell: not beyond a face behind which there is another.
    [[nodiscard]] Box3 roomOf(const Place& cell) const {
        const unsigned inside = insideBits(cell);
        Box3 room;
        for (int axis = 0; axis < 3; ++axis) {
            room.min()[axis] = -0.5 - beyond(inside & kLowCorners[axis], kLowCorners[axis]);
            room.max()[axis] = 0.5 + beyond(inside & ~kLowCorners[axis], ~kLowCorners[axis] & 0xFFU);
        }
        return room;
    }
    /// How far a vertex may be beyond a face of which these corners are inside.
    static double beyond(unsigned inside, unsigned corners) {
        const bool isCrossed = inside != 0 && inside != corners;
        return isCrossed ? -kApart : kPokesOut;
    }

    std::uint32_t addVertex(const Vec3& point, std::uint64_t id, const Place& cell) {
        wall_.mesh.vertices.push_back(point.cast<float>());
        wall_.vertexIds.push_back(id);
        wall_.sides.push_back(sideOf(point, cell));
        return static_cast<std::uint32_t>(wall_.mesh.vertices.size() - 1);
    }

    /// A distance changes by no more than the way: a corner of the cell that is farther from the tooth's surface than
    /// from the vertex has the vertex on its side.
    [[nodiscard]] std::int8_t sideOf(const Vec3& point, const Place& cell) const {
        for (int corner = 0; corner < 8; ++corner) {
            const Place p = {cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2)};
            const double distance = nodes_.tooth(p);
            if (std::abs(distance) > (position(p) - point).norm() * (1 + 1e-6)) return distance < 0 ? -1 : 1;
        }
        return 0;
    }

    /// The face between two cells at lattice edge (`a`, `axis`), and the vertex on it if the border crosses it twice.
    void addFaceVertex(const Place& faceCorner, int faceAxis, const Place& a, int axis) {
        const int u = (faceAxis + 1) % 3;
        const int v = (faceAxis + 2) % 3;
        std::array<bool, 4> removed{};
        for (int i = 0; i < 4; ++i) removed[i] = isRemoved(moved(moved(faceCorner, u, i & 1), v, i >> 1));
        if (removed[0] == removed[1] || removed[0] == removed[2] || removed[0] != removed[3]) return;
        const Place corner = isRemoved(a) ? moved(a, axis, 1) : a;
        const int end = (corner[u] - faceCorner[u]) | (corner[v] - faceCorner[v]) << 1;
        const Place onU = moved(moved(faceCorner, v, end >> 1), u, 0);
        const Place onV = moved(faceCorner, u, end & 1);
        const std::uint64_t id = numberOf(faceCorner, kRounds + 2 * faceAxis + (end >= 2 ? 1 : 0));
        const auto known = vertexById(id);
        polygon_[polygonSize_++] =
            known ? *known : addVertex(0.5 * (crossingAt(onU, u) + crossingAt(onV, v)), id, faceCorner);
    }

    /// The polygon around one lattice edge that the border crosses.
    template <int axis>
    void addPolygon(const Place& a) {
        const Place b = moved(a, axis, 1);
        const double toothA = nodes_.tooth(a) / spacing_;
        const double toothB = nodes_.tooth(b) / spacing_;
        if (std::min(toothA, toothB) > kNearerReach || std::max(toothA, toothB) > kTriangleReach) return;

        constexpr int u = (axis + 1) % 3;
        constexpr int v = (axis + 2) % 3;
        const Place beforeU = moved(a, u, -1);
        const Place beforeV = moved(a, v, -1);
        const std::array<Place, 4> cells = {moved(beforeU, v, -1), beforeV, a, beforeU};
        // The face between each cell and the next: where it begins, and its axis.
        const std::array<std::pair<const Place&, int>, 4> faces = {{{beforeV, u}, {a, v}, {a, u}, {beforeU, v}}};
        polygonSize_ = 0;
        for (int i = 0; i < 4; ++i) {
            const CellRounds& rounds = kCellRounds[insideBits(cells[i])];
            polygon_[polygonSize_++] = vertexOf(cells[i], rounds, a, axis);
            if (rounds.hasTwiceCrossedFace) addFaceVertex(faces[i].first, faces[i].second, a, axis);
        }
        if (isRemoved(a)) std::reverse(polygon_.begin(), polygon_.begin() + polygonSize_);

        const bool isClear = toothA < -kTriangleReach || toothB < -kTriangleReach;
        const Place& solid = isRemoved(a) ? b : a;
        const Place& removed = isRemoved(a) ? a : b;
        const Place& behind = nodes_.tooth(solid) < 0 ? solid : removed;
        addTriangles(isClear ? CavityWall::Place::Inside : CavityWall::Place::AtSurface,
                     static_cast<SurfaceTag>(nodes_.material(behind)), numberOf(a, axis));
    }

    /// A four-sided polygon is folded along the diagonal that leaves the smaller bend. One with face vertices is fanned
    /// out from such a one: a diagonal between the cells at its sides would be drawn by two polygons.
    void addTriangles(CavityWall::Place place, SurfaceTag tag, std::uint64_t faceId) {
        const auto begin = polygon_.begin();
        const auto end = begin + polygonSize_;
        if (polygonSize_ > 4) {
            const auto isOnFace = [&](std::uint32_t vertex) { return (wall_.vertexIds[vertex] & 15) >= kRounds; };
            std::rotate(begin, std::find_if(begin, end, isOnFace), end);
        } else if (bendAlong(1) < bendAlong(0)) {
            std::rotate(begin, begin + 1, end);
        }
        for (int i = 1; i + 1 < polygonSize_; ++i) {
            wall_.mesh.triangles.push_back({polygon_[0], polygon_[i], polygon_[i + 1]});
            wall_.tags.push_back(tag);
            wall_.places.push_back(place);
            wall_.faceIds.push_back(faceId * 8 + static_cast<std::uint64_t>(i));  // at most six triangles
        }
    }

    /// Grows with the angle between the two triangles on either side of a diagonal.
    [[nodiscard]] float bendAlong(int first) const {
        const auto corner = [&](int i) { return wall_.mesh.vertices[polygon_[(first + i) % 4]]; };
        const Vec3f diagonal = corner(2) - corner(0);
        const Vec3f one = (corner(1) - corner(0)).cross(diagonal);
        const Vec3f two = diagonal.cross(corner(3) - corner(0));
        const float cosine = one.dot(two);
        const float squares = one.squaredNorm() * two.squaredNorm();
        return squares > 0 ? -cosine * std::abs(cosine) / squares : 0;
    }

    const BrickNeighbourhood& nodes_;
    const BrickKey key_;
    const Lattice& lattice_;
    const double spacing_;
    CavityWall wall_;
    std::array<std::uint16_t, kCellSide * kCellSide * kCellSide> cellAt_;  // numbers of `cells_`
    std::vector<Cell> cells_;
    std::vector<CrossedEdge> edges_;
    std::array<std::uint32_t, 8> polygon_;
    int polygonSize_ = 0;
};

}  // namespace

CavityWall extractWall(const BrickNeighbourhood& nodes, const Lattice& lattice, const BrickKey& key) {
    if (!nodes.hasBorder()) return {};
    return WallExtractor(nodes, lattice, key).run();
}

}  // namespace tactooth
