// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/patch_bodies.h"

#include <algorithm>
#include <numeric>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

bool standsAlone(const SurfacePart& base) { return base.firstAdjacent() >= base.mesh().triangles.size(); }

/// Bodies do not touch, so that the surface nearest to a point of a body is its own.
bool isAdjacentAt(const SurfacePart& base, const Vec3& point) {
    const auto nearest = closestPoint(base, point);
    return nearest && base.isAdjacent(nearest->triangle);
}

std::vector<bool> adjacentFlags(const TriangleMesh& mesh, const SurfacePart& base) {
    std::vector<bool> flags(mesh.triangles.size());
    for (std::size_t t = 0; t < flags.size(); ++t)
        flags[t] = isAdjacentAt(base, (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3);
    return flags;
}

}  // namespace

BrickBodies bodiesIn(const SurfacePart& base, const std::vector<std::uint32_t>& near, const Vec3& middle) {
    TACTOOTH_ASSERT(middle.allFinite());
    if (standsAlone(base)) return BrickBodies::Tooth;
    if (near.empty()) return isAdjacentAt(base, middle) ? BrickBodies::Adjacent : BrickBodies::Tooth;
    const auto isAdjacent = [&](std::uint32_t triangle) { return base.isAdjacent(triangle); };
    if (std::ranges::all_of(near, isAdjacent)) return BrickBodies::Adjacent;
    return std::ranges::any_of(near, isAdjacent) ? BrickBodies::Either : BrickBodies::Tooth;
}

namespace {

/// Builds the tree quickly, since the next cut may replace it.
std::shared_ptr<const SurfacePart> quickPart(TriangleMesh mesh, std::vector<SurfaceTag> tags,
                                             std::uint32_t firstAdjacent) {
    return std::make_shared<const SurfacePart>(std::move(mesh), std::move(tags), firstAdjacent, TreeBuild::Quick);
}

}  // namespace

std::shared_ptr<const SurfacePart> patchPart(TaggedMesh patch, BrickBodies bodies, const SurfacePart& base) {
    auto& [mesh, tags] = patch;
    TACTOOTH_ASSERT(!mesh.empty());
    TACTOOTH_ASSERT(tags.size() == mesh.triangles.size());
    if (standsAlone(base) || bodies == BrickBodies::Tooth)
        return quickPart(std::move(mesh), std::move(tags), SurfacePart::kNoneAdjacent);
    if (bodies == BrickBodies::Adjacent) return quickPart(std::move(mesh), std::move(tags), 0);
    const std::vector<bool> around = adjacentFlags(mesh, base);
    std::vector<std::uint32_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    const auto others = std::stable_partition(order.begin(), order.end(), [&](std::uint32_t t) { return !around[t]; });
    const auto firstAdjacent = static_cast<std::uint32_t>(others - order.begin());
    std::vector<Triangle> triangles;
    std::vector<SurfaceTag> reordered;
    for (const std::uint32_t t : order) {
        triangles.push_back(mesh.triangles[t]);
        reordered.push_back(tags[t]);
    }
    mesh.triangles = std::move(triangles);
    return quickPart(std::move(mesh), std::move(reordered), firstAdjacent);
}

}  // namespace tactooth
