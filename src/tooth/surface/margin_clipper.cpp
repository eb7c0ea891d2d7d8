// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/margin_clipper.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory_resource>
#include <numeric>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"
#include "tooth/surface/intersection_filter.h"
#include "tooth/surface/vertex_groups.h"

// Own method. surface_intersection.cpp finds the segments of the cavity margin, and triangle_clip.cpp clips single
// triangles. This file decides which vertices of a wall are kept: cut lines decide for connected groups of vertices,
// and a test against the tooth decides for the others.

namespace tactooth {
namespace {

IntersectingFace baseFace(const TriangleMesh& mesh, std::uint32_t t) {
    const Triangle& v = mesh.triangles[t];
    return {{mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]}, {v[0], v[1], v[2]}};
}

IntersectingFace wallFace(const CavityWall& wall, std::uint32_t t) {
    const Triangle& v = wall.mesh.triangles[t];
    const auto& vertices = wall.mesh.vertices;
    return {{vertices[v[0]], vertices[v[1]], vertices[v[2]]},
            {wall.vertexIds[v[0]], wall.vertexIds[v[1]], wall.vertexIds[v[2]]}};
}

ClipPoint asSeenFrom(const IntersectionPoint& point, bool fromBase, std::uint64_t crossingFace) {
    if (point.onBaseEdge == fromBase) return {point.position, point.edge, point.along, crossingFace, {}};
    return {point.position, -1, 0, 0, point.edgeId};
}

std::array<bool, 3> forwardEdges(const std::array<std::uint64_t, 3>& id) {
    return {id[0] < id[1], id[1] < id[2], id[2] < id[0]};
}

/// Clips the wall of one brick at the tooth's surface.
class WallClipper {
public:
    WallClipper(const CavityWall& wall, const std::vector<MarginSegment>& margin, const SurfacePart& base)
        : wall_(wall), base_(base), linesBefore_(wall.mesh.triangles.size() + 1), groups_(wall.mesh.vertices.size()) {
        for (const MarginSegment& piece : margin) {
            TACTOOTH_ASSERT(piece.wall < wall.mesh.triangles.size());
            ++linesBefore_[piece.wall + 1];
        }
        std::partial_sum(linesBefore_.begin(), linesBefore_.end(), linesBefore_.begin());
        lines_.resize(margin.size());
        std::vector<std::uint32_t> next(linesBefore_.begin(), linesBefore_.end() - 1);
        for (const MarginSegment& piece : margin) lines_[next[piece.wall]++] = &piece;
    }

    WallPatch run() {
        groupVertices();
        patchVertex_.assign(wall_.mesh.vertices.size(), kNone);
        patch_.mesh.vertices.reserve(wall_.mesh.vertices.size() + 2 * lines_.size());
        patch_.mesh.triangles.reserve(wall_.mesh.triangles.size() + 2 * lines_.size());
        patch_.tags.reserve(wall_.mesh.triangles.size() + 2 * lines_.size());
        for (std::uint32_t t = 0; t < wall_.mesh.triangles.size(); ++t) {
            if (isCrossed(t)) {
                addClipped(t);
            } else if (isKept(t)) {
                addWhole(t);
            }
        }
        return std::move(patch_);
    }

private:
    static constexpr std::uint32_t kNone = ~0U;

    [[nodiscard]] bool mayIntersect(std::uint32_t t) const { return wall_.places[t] == CavityWall::Place::AtSurface; }

    [[nodiscard]] bool isCrossed(std::uint32_t t) const { return linesBefore_[t] != linesBefore_[t + 1]; }

    /// The cut lines in a triangle. Valid until the next call.
    const std::vector<ClipSegment>& linesIn(std::uint32_t t) {
        TACTOOTH_ASSERT(t + 1 < linesBefore_.size());
        segments_.clear();
        for (std::uint32_t i = linesBefore_[t]; i < linesBefore_[t + 1]; ++i) {
            const auto& [base, wall, wallId, crossing] = *lines_[i];
            // On the wall the line runs in the opposite direction.
            segments_.push_back({asSeenFrom(crossing.end, false, base), asSeenFrom(crossing.start, false, base)});
        }
        return segments_;
    }

    void groupVertices() {
        for (std::uint32_t t = 0; t < wall_.mesh.triangles.size(); ++t) {
            if (!mayIntersect(t)) continue;
            const Triangle& v = wall_.mesh.triangles[t];
            std::array<std::optional<EdgeEnds>, 3> ends;
            if (isCrossed(t)) ends = endsOfEdges(linesIn(t), forwardEdges(wallFace(wall_, t).id));
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t a = v[i];
                const std::uint32_t b = v[(i + 1) % 3];
                if (wall_.sides[a] != 0) groups_.report(a, wall_.sides[a] < 0, 1.0);
                groups_.addEdge(a, b, ends[i]);
            }
        }
    }

    bool isKept(std::uint32_t t) { return !mayIntersect(t) || isVertexKept(wall_.mesh.triangles[t][0]); }
    bool isVertexKept(std::uint32_t vertex) {
        if (const auto kept = groups_.isKept(vertex)) return *kept;
        const bool kept = contains(base_, wall_.mesh.vertices[vertex].cast<double>());
        groups_.report(vertex, kept, 0);
        return kept;
    }

    std::uint32_t patchVertexOf(std::uint32_t wallVertex) {
        std::uint32_t& vertex = patchVertex_[wallVertex];
        if (vertex == kNone) vertex = addVertex(wall_.mesh.vertices[wallVertex]);
        return vertex;
    }
    std::uint32_t marginVertex(const Vec3& point) {
        const Vec3f rounded = point.cast<float>();
        const auto [place, isNew] = marginVertices_.try_emplace({rounded.x(), rounded.y(), rounded.z()}, 0U);
        if (isNew) place->second = addVertex(rounded);
        return place->second;
    }
    std::uint32_t addVertex(const Vec3f& point) {
        patch_.mesh.vertices.push_back(point);
        return static_cast<std::uint32_t>(patch_.mesh.vertices.size() - 1);
    }

    void addWhole(std::uint32_t t) {
        const Triangle& v = wall_.mesh.triangles[t];
        patch_.mesh.triangles.push_back({patchVertexOf(v[0]), patchVertexOf(v[1]), patchVertexOf(v[2])});
        patch_.tags.push_back(wall_.tags[t]);
    }

    void addClipped(std::uint32_t t) {
        const std::array<Vec3, 3> corners = {wall_.mesh.corner(t, 0), wall_.mesh.corner(t, 1), wall_.mesh.corner(t, 2)};
        const Triangle& v = wall_.mesh.triangles[t];
        const std::array<bool, 3> keepsCorner = {isVertexKept(v[0]), isVertexKept(v[1]), isVertexKept(v[2])};
        const auto clipped = clipTriangle(corners, forwardEdges(wallFace(wall_, t).id), linesIn(t), keepsCorner);
        if (!clipped) {
            ++patch_.failures;
            addWhole(t);
            return;
        }
        for (const Triangle& triangle : clipped->triangles) {
            Triangle placed;
            for (int i = 0; i < 3; ++i) {
                TACTOOTH_ASSERT(triangle[i] < clipped->points.size());
                placed[i] =
                    triangle[i] < 3 ? patchVertexOf(v[triangle[i]]) : marginVertex(clipped->points[triangle[i]]);
            }
            patch_.mesh.triangles.push_back(placed);
            patch_.tags.push_back(wall_.tags[t]);
        }
    }

    const CavityWall& wall_;
    const SurfacePart& base_;
    std::vector<std::uint32_t> linesBefore_;   // number of cut lines in the triangles before each one
    std::vector<const MarginSegment*> lines_;  // grouped by triangle
    std::vector<ClipSegment> segments_;
    VertexGroups groups_;
    std::vector<std::uint32_t> patchVertex_;
    std::map<std::array<float, 3>, std::uint32_t> marginVertices_;
    WallPatch patch_;
};

}  // namespace

std::vector<MarginSegment> findMargin(const CavityWall& wall, const TriangleMesh& base,
                                      std::span<const std::uint32_t> near) {
    std::vector<MarginSegment> margin;
    if (wall.places.empty()) return margin;
    TACTOOTH_ASSERT(wall.places.size() == wall.mesh.triangles.size());
    TACTOOTH_ASSERT(wall.faceIds.size() == wall.places.size());
    TACTOOTH_ASSERT(wall.vertexIds.size() == wall.mesh.vertices.size());
    const IntersectionFilter filter(base, near);
    for (std::uint32_t w = 0; w < wall.places.size() && !filter.empty(); ++w) {
        if (wall.places[w] != CavityWall::Place::AtSurface) continue;
        const IntersectingFace face = wallFace(wall, w);
        filter.forCandidates(face.corner, [&](std::uint32_t t) {
            TACTOOTH_ASSERT(t < base.triangles.size());
            if (const auto crossing = intersectionOf(baseFace(base, t), face)) {
                margin.push_back({t, w, wall.faceIds[w], *crossing});
            }
        });
    }
    std::sort(margin.begin(), margin.end(), [](const MarginSegment& a, const MarginSegment& b) {
        return a.base != b.base ? a.base < b.base : a.wall < b.wall;
    });
    return margin;
}

WallPatch clipWall(CavityWall wall, const std::vector<MarginSegment>& margin, const SurfacePart& base) {
    TACTOOTH_ASSERT(wall.tags.size() == wall.mesh.triangles.size());
    TACTOOTH_ASSERT(!wall.places.empty() || margin.empty());
    const auto isInside = [](CavityWall::Place place) { return place == CavityWall::Place::Inside; };
    if (std::all_of(wall.places.begin(), wall.places.end(), isInside)) {
        return {std::move(wall.mesh), std::move(wall.tags), 0};
    }
    return WallClipper(wall, margin, base).run();
}

std::vector<ClipSegment> segmentsOnBase(const std::vector<const MarginSegment*>& pieces) {
    std::vector<ClipSegment> segments;
    for (const MarginSegment* piece : pieces) {
        TACTOOTH_ASSERT(piece != nullptr);
        TACTOOTH_ASSERT(piece->base == pieces.front()->base);
        segments.push_back({asSeenFrom(piece->crossing.start, true, piece->wallId),
                            asSeenFrom(piece->crossing.end, true, piece->wallId)});
    }
    return segments;
}

std::array<std::optional<EdgeEnds>, 3> endsOfEdges(const std::vector<ClipSegment>& segments,
                                                   const std::array<bool, 3>& isForward) {
    std::array<std::optional<EdgeEnds>, 3> result;
    if (segments.empty()) return result;
    std::array<std::byte, 1024> memory;  // enough in most cases
    std::pmr::monotonic_buffer_resource pool(memory.data(), memory.size());
    std::pmr::vector<EdgeCrossing> crossings(&pool);
    crossings.reserve(2 * segments.size());
    for (int edge = 0; edge < 3; ++edge) {
        crossings.clear();
        for (std::uint32_t i = 0; i < segments.size(); ++i) {
            const auto& [start, end] = segments[i];
            TACTOOTH_ASSERT(start.edge >= -1 && start.edge < 3 && end.edge >= -1 && end.edge < 3);
            if (start.edge == edge) crossings.push_back({start.along, start.crossingFace, isForward[edge], i});
            if (end.edge == edge) crossings.push_back({end.along, end.crossingFace, !isForward[edge], i});
        }
        if (crossings.empty()) continue;
        const int surplus = exitSurplus(crossings);
        if (surplus == 0) {
            std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.liesBefore(b); });
            TACTOOTH_ASSERT(crossings.size() >= 2);
            const bool isKept = crossings[0].leaves;
            const auto pointOf = [&](const EdgeCrossing& crossing) {
                const auto& [start, end] = segments[crossing.segment];
                return crossing.leaves == isForward[edge] ? start.position : end.position;
            };
            result[edge] = {isKept, isKept, (pointOf(crossings[1]) - pointOf(crossings[0])).norm()};
        } else if (std::abs(surplus) == 1) {
            const bool firstLeaves = (surplus > 0) == isForward[edge];
            result[edge] = {firstLeaves, !firstLeaves, VertexGroups::kCertain};
        }
    }
    return result;
}

}  // namespace tactooth
