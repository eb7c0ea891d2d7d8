// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/base_clipper.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"
#include "geometry/util/index_bitset.h"
#include "geometry/util/parallel_for.h"
#include "tooth/surface/margin_clipper.h"
#include "tooth/surface/vertex_groups.h"

// Own method. The cut lines decide which vertices of the tooth's own surface are kept, in groups that no line
// separates. The cut field decides for groups without a line. Triangles that a line crosses are clipped by
// triangle_clip.cpp.

namespace tactooth {
namespace {

std::array<bool, 3> forwardEdges(const Triangle& v) { return {v[0] < v[1], v[1] < v[2], v[2] < v[0]}; }

/// The vertices of a list of triangles, numbered from 0.
struct LocalVertices {
    LocalVertices(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles) : corners(triangles.size()) {
        IndexBitset used(mesh.vertices.size());
        for (const std::uint32_t triangle : triangles) {
            TACTOOTH_ASSERT(triangle < mesh.triangles.size());
            for (const std::uint32_t vertex : mesh.triangles[triangle]) used.add(vertex);
        }
        global = used.sorted();
        const BitsetRank places(used);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            for (int c = 0; c < 3; ++c) corners[i][c] = places[mesh.triangles[triangles[i]][c]];
        }
    }
    std::vector<std::uint32_t> global;
    std::vector<Triangle> corners;  ///< of each triangle of the list, as local numbers
};

/// Decides which vertices are kept. Cut lines at an edge decide first, else the cut field at the vertex of the group
/// that is farthest from the boundary.
VertexGroups groupVertices(const CutVolume& volume, const LocalVertices& vertices,
                           const std::vector<std::vector<ClipSegment>>& segments) {
    const TriangleMesh& mesh = volume.tooth()->outer()->mesh();
    std::vector<double> cut(vertices.global.size());
    parallelFor(cut.size(),
                [&](std::size_t i) { cut[i] = volume.cutDistance(mesh.vertices[vertices.global[i]].cast<double>()); });
    VertexGroups groups(cut.size());
    for (std::uint32_t i = 0; i < cut.size(); ++i) groups.report(i, cut[i] >= 0, std::abs(cut[i]));
    for (std::size_t i = 0; i < vertices.corners.size(); ++i) {
        const Triangle& v = vertices.corners[i];  // local numbers have the same order as the global ones
        const auto ends = endsOfEdges(segments[i], forwardEdges(v));
        for (int edge = 0; edge < 3; ++edge) groups.addEdge(v[edge], v[(edge + 1) % 3], ends[edge]);
    }
    return groups;
}

void clip(const TriangleMesh& mesh, std::uint32_t t, const std::vector<ClipSegment>& segments,
          const std::array<bool, 3>& keepsCorner, ClippedBaseTriangle& remains) {
    const auto clipped = clipTriangle({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)},
                                      forwardEdges(mesh.triangles[t]), segments, keepsCorner);
    if (!clipped) {
        remains.failed = true;  // kept or dropped as a whole
        return;
    }
    remains.hidden = true;
    for (const Triangle& piece : clipped->triangles) {
        TACTOOTH_ASSERT(
            std::ranges::all_of(piece, [&](std::uint32_t point) { return point < clipped->points.size(); }));
        remains.pieces.emplace_back();
        for (int c = 0; c < 3; ++c) remains.pieces.back()[c] = clipped->points[piece[c]].cast<float>();
    }
}

}  // namespace

std::vector<ClippedBaseTriangle> clipBase(const CutVolume& volume, const std::vector<std::uint32_t>& triangles,
                                          const std::vector<std::vector<ClipSegment>>& segments) {
    TACTOOTH_ASSERT(segments.size() == triangles.size());
    const TriangleMesh& mesh = volume.tooth()->outer()->mesh();
    const LocalVertices vertices(mesh, triangles);
    VertexGroups groups = groupVertices(volume, vertices, segments);
    std::vector<ClippedBaseTriangle> results(triangles.size());
    std::vector<std::array<bool, 3>> keepsCorner(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            TACTOOTH_ASSERT(groups.isKept(vertices.corners[i][c]).has_value());
            keepsCorner[i][c] = *groups.isKept(vertices.corners[i][c]);
        }
        TACTOOTH_ASSERT(!segments[i].empty() ||
                        (keepsCorner[i][0] == keepsCorner[i][1] && keepsCorner[i][1] == keepsCorner[i][2]));
        results[i].hidden = !keepsCorner[i][0];
    }
    parallelFor(triangles.size(), [&](std::size_t i) {
        if (!segments[i].empty()) clip(mesh, triangles[i], segments[i], keepsCorner[i], results[i]);
    });
    return results;
}

}  // namespace tactooth
