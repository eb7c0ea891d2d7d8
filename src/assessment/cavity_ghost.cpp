// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cavity_ghost.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr double kGhostPatch = 0.1;  // mm: size of a group of triangles; five pixels in a picture of a whole crown
constexpr double kReached = 0.05;    // mm, two samples of a cut tooth: a wall with less before it counts as reached
constexpr float kCordRadius =
    0.04F;  // mm: half of it stands out of the enamel; three pixels in a picture of a whole crown
constexpr std::uint32_t kCordSides = 6;
constexpr std::size_t kTrianglesPerEdge = 2 * kCordSides;
constexpr double kDash = 0.4, kGap = 0.3;  // mm along the rim; an edge of it is at most kCavityEdge long

Vec3 middleOf(const TriangleMesh& mesh, std::size_t triangle) {
    return (mesh.corner(triangle, 0) + mesh.corner(triangle, 1) + mesh.corner(triangle, 2)) / 3;
}

/// The grid cell of a point; the grid spacing is kGhostPatch.
std::array<int, 3> cellOf(const Vec3& point) {
    const Eigen::Array3i cell = (point / kGhostPatch).array().floor().cast<int>();
    return {cell.x(), cell.y(), cell.z()};
}

/// A point before the middle of a triangle of the walls, still inside the uncut tooth.
Vec3f pointBefore(const TriangleMesh& walls, std::size_t triangle, const SurfacePart& outer) {
    const Vec3 middle = middleOf(walls, triangle);
    const double depth = closestPoint(outer, middle)->distance;
    const Vec3 normal = walls.areaVector(triangle).stableNormalized();
    return (middle + std::min(kReached, depth / 2) * normal).cast<float>();
}

/// A ring of kCordSides vertices around `place`, square to `along`; the first one stands to the side of `up`.
void addRing(TriangleMesh& cord, const Vec3f& place, const Vec3f& along, const Vec3f& up) {
    const Vec3f aside = along.cross(up).stableNormalized();
    const Vec3f above = aside.cross(along);
    for (std::uint32_t i = 0; i < kCordSides; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kCordSides;
        cord.vertices.push_back(place + kCordRadius * (std::cos(angle) * above + std::sin(angle) * aside));
    }
}

/// The rim as a thin cord. Each of its vertices has one edge before it and one behind it.
TriangleMesh cordAlongRim(const CavityWalls& walls, const SurfacePart& outer) {
    constexpr std::uint32_t kNone = UINT32_MAX;
    const std::vector<Vec3f>& points = walls.mesh.vertices;
    std::vector<Vec3f> along(points.size(), Vec3f::Zero());
    std::vector<std::uint32_t> ringOf(points.size(), kNone);
    for (const auto& [from, to] : walls.rim) {
        for (const std::uint32_t end : {from, to}) along[end] += (points[to] - points[from]).stableNormalized();
    }
    TriangleMesh cord;
    const auto ring = [&](std::uint32_t vertex) {
        if (ringOf[vertex] != kNone) return ringOf[vertex];
        ringOf[vertex] = static_cast<std::uint32_t>(cord.vertices.size());
        const Vec3f surface = closestPoint(outer, points[vertex].cast<double>())->point.cast<float>();
        addRing(cord, points[vertex], along[vertex].stableNormalized(), surface - points[vertex]);
        return ringOf[vertex];
    };
    for (const auto& [from, to] : walls.rim) {
        const std::uint32_t first = ring(from), second = ring(to);
        for (std::uint32_t i = 0; i < kCordSides; ++i) {
            const std::uint32_t next = (i + 1) % kCordSides;
            cord.triangles.push_back({first + i, second + next, second + i});
            cord.triangles.push_back({first + i, first + next, second + next});
        }
    }
    return cord;
}

/// For each edge of the rim: its part of a dashed line, kGhostRim or kGhostRimGap.
std::vector<SurfaceTag> dashesOf(const CavityWalls& walls) {
    std::unordered_map<std::uint32_t, std::size_t> edgeFrom;
    for (std::size_t i = 0; i < walls.rim.size(); ++i) edgeFrom.emplace(walls.rim[i][0], i);
    std::vector<SurfaceTag> dashes(walls.rim.size(), kGhostRim);
    std::vector<bool> isVisited(walls.rim.size());
    for (std::size_t first = 0; first < walls.rim.size(); ++first) {
        double along = 0;  // mm
        for (std::size_t edge = first; !isVisited[edge];) {
            isVisited[edge] = true;
            const auto [from, to] = walls.rim[edge];
            const double length = (walls.mesh.vertices[to] - walls.mesh.vertices[from]).norm();
            if (std::fmod(along + length / 2, kDash + kGap) > kDash) dashes[edge] = kGhostRimGap;
            along += length;
            const auto next = edgeFrom.find(to);
            if (next == edgeFrom.end()) break;
            edge = next->second;
        }
    }
    return dashes;
}

}  // namespace

CavityGhost::CavityGhost(CavityWalls walls, const SurfacePart& outer) {
    divideIntoPatches(walls.mesh, outer);
    const TriangleMesh cord = cordAlongRim(walls, outer);
    std::vector<SurfaceTag> tags(walls.mesh.triangles.size(), kGhostWall);
    for (const SurfaceTag dash : dashesOf(walls)) tags.insert(tags.end(), kTrianglesPerEdge, dash);
    TACTOOTH_ASSERT(tags.size() == walls.mesh.triangles.size() + cord.triangles.size());
    append(walls.mesh, cord);
    reached_.resize((tags.size() + 63) / 64);
    shown_.base = std::make_shared<const SurfacePart>(std::move(walls.mesh), std::move(tags));
    last_ = std::make_shared<const Surface>(shown_);
}

/// Sorts the triangles by their groups.
void CavityGhost::divideIntoPatches(TriangleMesh& walls, const SurfacePart& outer) {
    std::vector<std::pair<std::array<int, 3>, std::uint32_t>> placed;
    for (std::uint32_t i = 0; i < walls.triangles.size(); ++i) placed.emplace_back(cellOf(middleOf(walls, i)), i);
    std::sort(placed.begin(), placed.end());
    std::vector<Triangle> ordered;
    for (std::uint32_t i = 0; i < placed.size(); ++i) {
        ordered.push_back(walls.triangles[placed[i].second]);
        const bool isNew = i == 0 || placed[i].first != placed[i - 1].first;
        if (isNew) ghostPatches_.push_back({Vec3f::Zero(), i, i});
        ghostPatches_.back().end = i + 1;
    }
    walls.triangles = std::move(ordered);
    constexpr std::size_t kGrain = 64;  // distance queries: about half a millisecond
    parallelFor(
        ghostPatches_.size(),
        [&](std::size_t i) {
            ghostPatches_[i].before = pointBefore(walls, (ghostPatches_[i].first + ghostPatches_[i].end) / 2, outer);
        },
        kGrain);
}

void CavityGhost::show(const GhostPatch& spot, bool shows) {
    for (std::uint32_t i = spot.first; i < spot.end; ++i) {
        const std::uint64_t bit = std::uint64_t{1} << (i % 64);
        shows ? reached_[i / 64] &= ~bit : reached_[i / 64] |= bit;
    }
}

std::shared_ptr<const Surface> CavityGhost::over(const std::shared_ptr<const Surface>& tooth) {
    Box3 changed = change_.changedBox(*tooth);
    if (changed.isEmpty()) return last_;
    changed.min().array() -= kReached;
    changed.max().array() += kReached;
    const TriangleMask before = reached_;
    for (const GhostPatch& spot : ghostPatches_) {
        const Vec3 point = spot.before.cast<double>();
        if (changed.contains(point)) show(spot, contains(*tooth, point));
    }
    if (reached_ == before) return last_;
    shown_.hidden = std::make_shared<const TriangleMask>(reached_);
    ++shown_.revision;
    return last_ = std::make_shared<const Surface>(shown_);
}

}  // namespace tactooth
