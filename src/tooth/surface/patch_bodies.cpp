// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/patch_bodies.h"

#include <algorithm>
#include <numeric>

#include "collision/bvh/closest_point.h"

namespace tactooth {
namespace {

bool standsAlone(const SurfacePart& base) { return base.firstAround() >= base.mesh().triangles.size(); }

/// Bodies do not touch, so what is next to a point in one of them or on its surface is its own surface.
bool isAroundAt(const SurfacePart& base, const Vec3& point) {
    const auto nearest = closestPoint(base, point);
    return nearest && base.isAround(nearest->triangle);
}

std::vector<bool> aroundFlags(const TriangleMesh& mesh, const SurfacePart& base) {
    std::vector<bool> flags(mesh.triangles.size());
    for (std::size_t t = 0; t < flags.size(); ++t)
        flags[t] = isAroundAt(base, (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3);
    return flags;
}

}  // namespace

BrickBodies bodiesIn(const SurfacePart& base, const std::vector<std::uint32_t>& near, const Vec3& middle) {
    if (standsAlone(base)) return BrickBodies::Tooth;
    if (near.empty()) return isAroundAt(base, middle) ? BrickBodies::Around : BrickBodies::Tooth;
    const auto isAround = [&](std::uint32_t triangle) { return base.isAround(triangle); };
    if (std::ranges::all_of(near, isAround)) return BrickBodies::Around;
    return std::ranges::any_of(near, isAround) ? BrickBodies::Either : BrickBodies::Tooth;
}

namespace {

/// With a tree that is made soon: the next cut may replace it.
std::shared_ptr<const SurfacePart> quickPart(TriangleMesh mesh, std::vector<SurfaceTag> tags,
                                             std::uint32_t firstAround) {
    return std::make_shared<const SurfacePart>(std::move(mesh), std::move(tags), firstAround, TreeBuild::Quick);
}

}  // namespace

std::shared_ptr<const SurfacePart> patchPart(TaggedMesh patch, BrickBodies bodies, const SurfacePart& base) {
    auto& [mesh, tags] = patch;
    if (standsAlone(base) || bodies == BrickBodies::Tooth)
        return quickPart(std::move(mesh), std::move(tags), SurfacePart::kNoneAround);
    if (bodies == BrickBodies::Around) return quickPart(std::move(mesh), std::move(tags), 0);
    const std::vector<bool> around = aroundFlags(mesh, base);
    std::vector<std::uint32_t> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    const auto others = std::stable_partition(order.begin(), order.end(), [&](std::uint32_t t) { return !around[t]; });
    const auto firstAround = static_cast<std::uint32_t>(others - order.begin());
    std::vector<Triangle> triangles;
    std::vector<SurfaceTag> reordered;
    for (const std::uint32_t t : order) {
        triangles.push_back(mesh.triangles[t]);
        reordered.push_back(tags[t]);
    }
    mesh.triangles = std::move(triangles);
    return quickPart(std::move(mesh), std::move(reordered), firstAround);
}

}  // namespace tactooth
