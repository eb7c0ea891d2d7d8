// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/cavity_wall.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <bit>
#include <cmath>

#include "tooth/brick_neighbourhood.h"
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
/// Directions in which the planes of a cell agree to this share of their weight are not an edge: the vertex stays at
/// the mean of the crossings there. Keeps edges sharper than about 20 degrees.
constexpr double kFlat = 0.03;
/// Bits of a cell's corners on its lower side of each axis.
constexpr std::array<unsigned, 3> kLowCorners = {0x55, 0x33, 0x0F};

struct Crossing {
    Vec3 point;
    Vec3 normal;
};

using Place = BrickNeighbourhood::Place;

Place moved(Place place, int axis, int step) {
    place[axis] += step;
    return place;
}

/// The planes in which the border crosses a cell, near a point (the quadric of the paper).
class Planes {
public:
    explicit Planes(const Vec3& centre) : centre_(centre) {}

    void add(const Vec3& point, const Vec3& normal) {
        normals_ += normal * normal.transpose();
        offsets_ += normal * normal.dot(point - centre_);
        sum_ += normal;
    }

    /// The point of `room` nearest to all planes and then to the centre, directions without an edge left out. Where the
    /// planes meet outside, the point slides along the wall of the room: a sharp edge that leaves through it stays
    /// sharp.
    [[nodiscard]] Vec3 nearestPoint(const Box3& room) const {
        Vec3 held = Vec3::Zero();  // how far the centre is moved along the axes that are not free
        Vec3 free = Vec3::Ones();
        Vec3 way = nearestWay(held, free);
        for (int i = 0; i < 3 && !room.contains(centre_ + way); ++i) {
            const Vec3 inside = clamped(centre_ + way, room) - centre_;
            int worst = 0;
            (inside - way).cwiseAbs().maxCoeff(&worst);
            held[worst] = inside[worst];
            free[worst] = 0;
            way = nearestWay(held, free);
        }
        return clamped(centre_ + way, room);
    }

    /// Whether the normals agree so well that the mean one alone counts: the weight in all other directions together is
    /// what it leaves of theirs.
    [[nodiscard]] bool isFlat() const {
        const double along = sum_.dot(normals_ * sum_) / sum_.squaredNorm();
        return normals_.trace() - along < kFlat * along;
    }
    /// The point of a flat border along its normal from the centre.
    [[nodiscard]] Vec3 pointOfFlat() const {
        const Vec3 mean = sum_.normalized();
        return centre_ + mean * (mean.dot(offsets_) / mean.dot(normals_ * mean));
    }

private:
    [[nodiscard]] static Vec3 clamped(const Vec3& point, const Box3& room) {
        return point.cwiseMax(room.min()).cwiseMin(room.max());
    }

    /// The way from the centre to the nearest point, along axes that are free (1) or held (0).
    [[nodiscard]] Vec3 nearestWay(const Vec3& held, const Vec3& free) const {
        Eigen::SelfAdjointEigenSolver<Mat3> solver;
        solver.computeDirect(free.asDiagonal() * normals_ * free.asDiagonal());
        const Vec3 wanted = free.asDiagonal() * (offsets_ - normals_ * held);
        const double largest = solver.eigenvalues()[2];
        Vec3 way = held;
        for (int i = 0; i < 3; ++i) {
            const double value = solver.eigenvalues()[i];
            const Vec3 direction = solver.eigenvectors().col(i);
            if (value > kFlat * largest) way += direction * (direction.dot(wanted) / value);
        }
        return way;
    }

    Vec3 centre_;
    Vec3 sum_ = Vec3::Zero();
    Mat3 normals_ = Mat3::Zero();
    Vec3 offsets_ = Vec3::Zero();
};

class WallExtractor {
public:
    WallExtractor(const BrickMap& bricks, const Lattice& lattice, const BrickKey& key)
        : nodes_(bricks, key, lattice.spacing()), key_(key), lattice_(lattice), spacing_(lattice.spacing()) {}

    CavityWall run() {
        if (!nodes_.hasBorder()) return {};
        reserve();
        cellVertex_.fill(kNoVertex);
        edgeCrossing_.fill(kNoCrossing);
        for (int z = 0; z < kBrickSide; ++z) {
            for (int y = 0; y < kBrickSide; ++y) {
                const unsigned row = removedRow(y, z);
                addCrossed(row ^ row >> 1, y, z, 0);
                addCrossed(row ^ removedRow(y + 1, z), y, z, 1);
                addCrossed(row ^ removedRow(y, z + 1), y, z, 2);
            }
        }
        return std::move(wall_);
    }

private:
    static constexpr std::uint32_t kNoVertex = ~0U;
    static constexpr std::uint16_t kNoCrossing = 0xFFFF;
    static constexpr int kCellSide = kBrickSide + 1;
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
        crossings_.reserve(kTriangles);
    }

    /// Which nodes of a row along x are removed, one bit each: the brick's own and the one after.
    [[nodiscard]] unsigned removedRow(int y, int z) const { return nodes_.removedRow(y, z) >> 1; }
    /// The polygons around those edges of a row on one axis that the border crosses, one bit each.
    void addCrossed(unsigned crossed, int y, int z, int axis) {
        for (crossed &= (1U << kBrickSide) - 1; crossed != 0; crossed &= crossed - 1) {
            addPolygon({std::countr_zero(crossed), y, z}, axis);
        }
    }

    static int nodeAt(const Place& p) { return BrickNeighbourhood::index(p[0], p[1], p[2]); }
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

    /// Each crossing is asked for by the four cells around it.
    Crossing crossingAt(const Place& a, int axis) {
        std::uint16_t& slot = edgeCrossing_[3 * nodeAt(a) + axis];
        if (slot == kNoCrossing) {
            slot = static_cast<std::uint16_t>(crossings_.size());
            const auto [place, normal] = nodes_.border(a, axis);
            crossings_.push_back({position(a) + place * spacing_ * Vec3::Unit(axis), normal});
        }
        return crossings_[slot];
    }

    [[nodiscard]] unsigned insideBits(const Place& cell) const {
        const auto pair = [&](int dy, int dz) {
            return nodes_.removedRow(cell[1] + dy, cell[2] + dz) >> (cell[0] + 1) & 3U;
        };
        return pair(0, 0) | pair(1, 0) << 2 | pair(0, 1) << 4 | pair(1, 1) << 6;
    }

    /// The vertex of the round of `cell` that crosses lattice edge (`a`, `axis`).
    std::uint32_t vertexOf(const Place& cell, const CellRounds& rounds, const Place& a, int axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        const int round = rounds.roundOfEdge[cellEdge(axis, a[u] - cell[u], a[v] - cell[v])];
        const int slot = round + kRounds * (cell[0] + 1 + kCellSide * (cell[1] + 1 + kCellSide * (cell[2] + 1)));
        std::uint32_t& vertex = cellVertex_[slot];
        if (vertex == kNoVertex) vertex = addVertex(placeVertex(cell, rounds, round), numberOf(cell, round), cell);
        return vertex;
    }

    [[nodiscard]] Vec3 placeVertex(const Place& cell, const CellRounds& rounds, int round) {
        std::array<Crossing, 12> crossings;
        int count = 0;
        Vec3 mean = Vec3::Zero();
        for (unsigned edges = rounds.edgesOfRound[round]; edges != 0; edges &= edges - 1) {
            const int edge = std::countr_zero(edges);
            const int first = cellEdgeCorners(edge)[0];
            const Place a = {cell[0] + (first & 1), cell[1] + (first >> 1 & 1), cell[2] + (first >> 2)};
            crossings[count] = crossingAt(a, edge / 4);
            mean += crossings[count++].point;
        }
        mean /= count;
        if (rounds.count > 1) return mean;  // see the top: each round keeps to its own side
        Planes planes(mean);
        for (int i = 0; i < count; ++i) planes.add(crossings[i].point, crossings[i].normal);
        if (!planes.isFlat()) return planes.nearestPoint(roomOf(cell));
        const Vec3 point = planes.pointOfFlat();
        return grownCell(position(cell)).contains(point) ? point : mean;
    }

    /// A flat border moves its vertices along its normal alone, so that they keep their places.
    [[nodiscard]] Box3 grownCell(const Vec3& corner) const {
        return {corner - Vec3::Constant(kPokesOut * spacing_), corner + Vec3::Constant((1 + kPokesOut) * spacing_)};
    }

    /// Where the vertex of a cell may be: not beyond a face behind which there is another one.
    [[nodiscard]] Box3 roomOf(const Place& cell) const {
        const unsigned inside = insideBits(cell);
        const Vec3 corner = position(cell);
        Box3 room(corner, corner + Vec3::Constant(spacing_));
        for (int axis = 0; axis < 3; ++axis) {
            room.min()[axis] -= beyond(inside & kLowCorners[axis], kLowCorners[axis]);
            room.max()[axis] += beyond(inside & ~kLowCorners[axis], ~kLowCorners[axis] & 0xFFU);
        }
        return room;
    }
    /// mm that a vertex may be beyond a face of which these corners are inside.
    [[nodiscard]] double beyond(unsigned inside, unsigned corners) const {
        const bool isCrossed = inside != 0 && inside != corners;
        return (isCrossed ? -kApart : kPokesOut) * spacing_;
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
        const Crossing first = crossingAt(onU, u);
        const Crossing second = crossingAt(onV, v);
        const Vec3 place = 0.5 * (first.point + second.point);
        const std::uint64_t id = numberOf(faceCorner, kRounds + 2 * faceAxis + (end >= 2 ? 1 : 0));
        const auto known = std::find(wall_.vertexIds.begin(), wall_.vertexIds.end(), id);
        polygon_[polygonSize_++] = known != wall_.vertexIds.end()
                                       ? static_cast<std::uint32_t>(known - wall_.vertexIds.begin())
                                       : addVertex(place, id, faceCorner);
    }

    /// The polygon around one lattice edge that the border crosses.
    void addPolygon(const Place& a, int axis) {
        const Place b = moved(a, axis, 1);
        const double toothA = nodes_.tooth(a) / spacing_;
        const double toothB = nodes_.tooth(b) / spacing_;
        if (std::min(toothA, toothB) > kNearerReach || std::max(toothA, toothB) > kTriangleReach) return;

        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
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

    [[nodiscard]] double bendAlong(int first) const {
        const auto corner = [&](int i) { return wall_.mesh.vertices[polygon_[(first + i) % 4]].cast<double>(); };
        const Vec3 diagonal = corner(2) - corner(0);
        const Vec3 one = (corner(1) - corner(0)).cross(diagonal);
        const Vec3 two = diagonal.cross(corner(3) - corner(0));
        return -one.normalized().dot(two.normalized());
    }

    const BrickNeighbourhood nodes_;
    const BrickKey key_;
    const Lattice& lattice_;
    const double spacing_;
    CavityWall wall_;
    std::array<std::uint32_t, kCellSide * kCellSide * kCellSide * kRounds> cellVertex_;
    std::array<std::uint16_t, 3 * BrickNeighbourhood::kSide * BrickNeighbourhood::kSide * BrickNeighbourhood::kSide>
        edgeCrossing_;
    std::vector<Crossing> crossings_;
    std::array<std::uint32_t, 8> polygon_;
    int polygonSize_ = 0;
};

}  // namespace

CavityWall extractWall(const BrickMap& bricks, const Lattice& lattice, const BrickKey& key) {
    return WallExtractor(bricks, lattice, key).run();
}

}  // namespace tactooth
