// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_specks.h"

#include <algorithm>
#include <vector>

#include "geometry/mesh/mesh_edges.h"
#include "geometry/util/assert.h"
#include "geometry/util/disjoint_sets.h"

namespace tactooth {
namespace {

struct Piece {
    std::size_t triangles = 0;
    double area = 0;
    Box3 box;
};

}  // namespace

std::size_t dropSpecks(TriangleMesh& mesh) {
    const std::size_t count = mesh.triangles.size();
    DisjointSets sets(count);
    MeshEdges(mesh).forEachEdge([&](std::span<const EdgeUse> uses) {
        for (const EdgeUse& use : uses.subspan(1)) sets.join(uses[0].corner / 3, use.corner / 3);
    });
    std::vector<Piece> pieces(count);  // by the number of their set
    std::size_t largest = 0;
    for (std::uint32_t t = 0; t < count; ++t) {
        if (isDegenerate(mesh.triangles[t])) continue;
        Piece& piece = pieces[sets.find(t)];
        ++piece.triangles;
        piece.area += mesh.areaVector(t).norm() / 2;
        for (int corner = 0; corner < 3; ++corner) piece.box.extend(mesh.corner(t, corner));
        if (piece.area > pieces[largest].area) largest = sets.find(t);
    }
    if (count == 0) return 0;
    const Piece body = pieces[largest];
    constexpr std::size_t kFewest = 4;  // least number of triangles of a body
    if (body.triangles < kFewest) return 0;
    const double shortest = kSpeck * body.box.diagonal().norm();
    const auto isSpeck = [&](const Piece& piece) {
        if (piece.box.isEmpty() || piece.area == body.area) return false;
        if (piece.area == 0) return true;
        if (body.box.contains(piece.box)) return false;
        return piece.box.diagonal().norm() < shortest || piece.area < kSpeck * kSpeck * body.area;
    };
    // A triangle with two equal corners belongs to no component, but counts for the box.
    const auto isStray = [&](const Triangle& t) {
        return isDegenerate(t) && !std::ranges::all_of(t, [&](std::uint32_t vertex) {
                   return body.box.contains(mesh.vertices[vertex].cast<double>());
               });
    };
    std::size_t dropped = 0;
    double keptArea = 0, area = 0;
    std::vector<Triangle> kept;
    kept.reserve(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        const std::uint32_t piece = sets.find(t);
        const bool isOfSpeck = isSpeck(pieces[piece]);
        const bool goes = isOfSpeck || isStray(mesh.triangles[t]);
        if (!goes) kept.push_back(mesh.triangles[t]);
        if (piece != t) continue;
        dropped += goes;
        area += pieces[piece].area;
        keptArea += isOfSpeck ? 0 : pieces[piece].area;
    }
    TACTOOTH_ASSERT(!(keptArea > area));
    if (kept.size() == count || keptArea < kLeastBody * area) return 0;
    mesh.triangles = std::move(kept);
    return dropped;
}

Box3 boxExcludingSpecks(TriangleMesh mesh) {
    dropSpecks(mesh);
    return boundingBox(mesh);
}

}  // namespace tactooth
