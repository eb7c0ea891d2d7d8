// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_repair.h"

#include <algorithm>
#include <map>
#include <vector>

#include "geometry/mesh/boundary_loops.h"
#include "geometry/mesh/crack_weld.h"
#include "geometry/mesh/mesh_edges.h"
#include "geometry/util/assert.h"
#include "geometry/util/disjoint_sets.h"

namespace tactooth {
namespace {

void dropUseless(TriangleMesh& mesh, RepairReport& report) {
    const std::size_t before = mesh.triangles.size();
    std::erase_if(mesh.triangles, isDegenerate);
    report.droppedDegenerate = before - mesh.triangles.size();
    report.droppedDuplicates = removeDuplicates(mesh);
    report.cracks = weldCracks(mesh);
}

/// The neighbours of each triangle, over edges of two triangles, and the connected components.
struct Neighbours {
    struct Meeting {
        std::uint32_t other;
        bool agree;  // on the outside
    };
    std::vector<std::vector<Meeting>> of;
    DisjointSets pieces;

    explicit Neighbours(const TriangleMesh& mesh) : of(mesh.triangles.size()), pieces(mesh.triangles.size()) {
        MeshEdges(mesh).forEachEdge([&](std::span<const EdgeUse> uses) {
            for (const EdgeUse& use : uses.subspan(1)) pieces.join(uses[0].corner / 3, use.corner / 3);
            if (uses.size() != 2) return;
            const std::uint32_t a = uses[0].corner / 3, b = uses[1].corner / 3;
            const bool agree = uses[0].upward != uses[1].upward;
            of[a].push_back({b, agree});
            of[b].push_back({a, agree});
        });
    }
};

/// The triangles of each component that must be turned to agree with its first one.
std::vector<bool> disagreeing(const Neighbours& neighbours) {
    const std::size_t count = neighbours.of.size();
    std::vector<bool> turned(count, false), reached(count, false);
    std::vector<std::uint32_t> front;
    for (std::uint32_t first = 0; first < count; ++first) {
        if (reached[first]) continue;
        reached[first] = true;
        front.assign(1, first);
        while (!front.empty()) {
            const std::uint32_t here = front.back();
            front.pop_back();
            for (const auto& [other, agree] : neighbours.of[here]) {
                if (reached[other]) continue;
                reached[other] = true;
                turned[other] = turned[here] != !agree;
                front.push_back(other);
            }
        }
    }
    return turned;
}

/// Signed volume of the tetrahedra from the middle of the box to the triangles. Its sign is a good hint at the
/// orientation of an open surface, too.
double volumeSeenFrom(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles, const Vec3& middle) {
    double sixfold = 0;
    for (const std::uint32_t t : triangles) {
        sixfold += (mesh.corner(t, 0) - middle).dot((mesh.corner(t, 1) - middle).cross(mesh.corner(t, 2) - middle));
    }
    return sixfold / 6;
}

struct Piece {
    std::vector<std::uint32_t> triangles;
    Box3 box;
    double area = 0;

    [[nodiscard]] double size() const { return box.diagonal().norm(); }
};

/// The component with the largest area, so that a thin or distant component is not chosen.
const Piece& largestBody(const std::vector<Piece>& pieces) {
    TACTOOTH_ASSERT(!pieces.empty());
    return *std::ranges::max_element(pieces, {}, &Piece::area);
}

/// All components, largest box first.
std::vector<Piece> gather(const TriangleMesh& mesh, DisjointSets& sets) {
    std::map<std::uint32_t, Piece> bySet;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        Piece& piece = bySet[sets.find(t)];
        piece.triangles.push_back(t);
        piece.area += mesh.areaVector(t).norm() / 2;
        for (int corner = 0; corner < 3; ++corner) piece.box.extend(mesh.corner(t, corner));
    }
    std::vector<Piece> pieces;
    for (auto& [set, piece] : bySet) pieces.push_back(std::move(piece));
    std::ranges::stable_sort(pieces, [](const Piece& a, const Piece& b) { return a.size() > b.size(); });
    return pieces;
}

void turn(Triangle& triangle) { std::swap(triangle[1], triangle[2]); }

/// Turns each component that faces inward, unless it is inside the largest one: it may be the wall of a void.
void orientOutward(TriangleMesh& mesh, const std::vector<Piece>& pieces, std::vector<bool>& turned) {
    const Piece& body = largestBody(pieces);
    for (const Piece& piece : pieces) {
        const bool isHollow = &piece != &body && body.box.contains(piece.box);
        if (isHollow || volumeSeenFrom(mesh, piece.triangles, piece.box.center()) >= 0) continue;
        for (const std::uint32_t t : piece.triangles) {
            turn(mesh.triangles[t]);
            turned[t] = !turned[t];
        }
    }
}

void orient(TriangleMesh& mesh, const RepairOptions& options, RepairReport& report) {
    Neighbours neighbours(mesh);
    std::vector<bool> turned = disagreeing(neighbours);
    for (std::size_t t = 0; t < turned.size(); ++t) {
        if (turned[t]) turn(mesh.triangles[t]);
    }
    TACTOOTH_ASSERT(turned.size() == mesh.triangles.size());
    std::vector<Piece> pieces = gather(mesh, neighbours.pieces);
    orientOutward(mesh, pieces, turned);
    const Piece& body = largestBody(pieces);
    const auto isSpeck = [&](const Piece& piece) {
        const bool isThin =
            piece.area < options.speckSize * options.speckSize * body.area && !body.box.contains(piece.box);
        const bool isLone = piece.triangles.size() == 1;  // it bounds nothing, however large it is
        return &piece != &body && (piece.size() < options.speckSize * body.size() || isThin || isLone);
    };
    double area = 0, areaOfSpecks = 0;
    for (const Piece& piece : pieces) {
        area += piece.area;
        areaOfSpecks += isSpeck(piece) ? piece.area : 0;
    }
    const bool dropsSpecks = areaOfSpecks <= (1 - kLeastBody) * area;  // else there is no body with specks beside it
    std::vector<bool> kept(mesh.triangles.size(), false);
    for (const Piece& piece : pieces) {
        const bool isDroppedSpeck = dropsSpecks && isSpeck(piece);
        report.droppedPieces += isDroppedSpeck;
        for (const std::uint32_t t : piece.triangles) kept[t] = !isDroppedSpeck;
    }
    std::vector<Triangle> rest;
    rest.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < kept.size(); ++t) {
        if (!kept[t]) continue;
        report.flippedTriangles += turned[t];
        rest.push_back(mesh.triangles[t]);
    }
    mesh.triangles = std::move(rest);
}

double lengthOf(const TriangleMesh& mesh, const BoundaryLoop& loop) {
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        length += (mesh.vertices[loop[i]] - mesh.vertices[loop[(i + 1) % loop.size()]]).cast<double>().norm();
    }
    return length;
}

void fill(TriangleMesh& mesh, const BoundaryLoop& loop) {
    TACTOOTH_ASSERT(loop.size() >= 3);
    if (loop.size() == 3) {
        mesh.triangles.push_back({loop[0], loop[1], loop[2]});
        return;
    }
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t vertex : loop) sum += mesh.vertices[vertex].cast<double>();
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back((sum / static_cast<double>(loop.size())).cast<float>());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        mesh.triangles.push_back({loop[i], loop[(i + 1) % loop.size()], middle});
    }
}

void fillHoles(TriangleMesh& mesh, const RepairOptions& options, RepairReport& report) {
    const double longest = options.smallHole * boundingBox(mesh).diagonal().norm();
    for (const BoundaryLoop& loop : boundaryLoops(mesh, report.openHoles)) {
        const double rim = lengthOf(mesh, loop);
        const bool fills = options.holes == HolesToFill::All || (options.holes == HolesToFill::Small && rim <= longest);
        if (!fills) {
            ++report.openHoles;
            continue;
        }
        fill(mesh, loop);
        ++report.filledHoles;
        report.longestFilledRim = std::max(report.longestFilledRim, rim);
    }
}

}  // namespace

RepairedMesh repaired(const TriangleMesh& mesh, const RepairOptions& options) {
    TACTOOTH_ASSERT(options.smallHole >= 0);
    TACTOOTH_ASSERT(options.speckSize >= 0 && options.speckSize <= 1);
    RepairedMesh result{mesh, {}};
    if (mesh.empty()) return result;
    dropUseless(result.mesh, result.report);
    if (result.mesh.empty()) return result;
    orient(result.mesh, options, result.report);
    fillHoles(result.mesh, options, result.report);
    return result;
}

std::vector<TriangleMesh> connectedComponents(const TriangleMesh& mesh) {
    Neighbours neighbours(mesh);
    std::vector<TriangleMesh> result;
    for (const Piece& piece : gather(mesh, neighbours.pieces)) {
        std::map<std::uint32_t, std::uint32_t> numbers;
        TriangleMesh part;
        for (const std::uint32_t t : piece.triangles) {
            Triangle triangle = mesh.triangles[t];
            for (std::uint32_t& vertex : triangle) {
                const auto [place, isNew] =
                    numbers.try_emplace(vertex, static_cast<std::uint32_t>(part.vertices.size()));
                if (isNew) part.vertices.push_back(mesh.vertices[vertex]);
                vertex = place->second;
            }
            part.triangles.push_back(triangle);
        }
        result.push_back(std::move(part));
    }
    return result;
}

}  // namespace tactooth
