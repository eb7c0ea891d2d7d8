// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cause/error_patch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "assessment/messages.h"
#include "collision/bvh/closest_point.h"
#include "geometry/util/disjoint_sets.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr double kLeastVolume = 0.005;   // mm^3: smaller patches are the roughness of a cut
constexpr double kFloorCosine = 0.7071;  // 45 degrees
constexpr std::size_t kGrain = 64;       // facets

Facet facetOf(const TriangleMesh& mesh, std::size_t i) {
    const Vec3 area = mesh.areaVector(i);
    return {(mesh.corner(i, 0) + mesh.corner(i, 1) + mesh.corner(i, 2)) / 3, area.stableNormalized(), area.norm() / 2};
}

/// The patches of `mesh` that lie inside `other`.
std::vector<ErrorPatch> patchesInside(const TriangleMesh& mesh, const SurfacePart& other, double tolerance,
                                      bool isOver) {
    std::vector<double> depths(mesh.triangles.size());
    parallelFor(
        depths.size(), [&](std::size_t i) { depths[i] = -signedDistance(other, facetOf(mesh, i).centre); }, kGrain);
    const double deepest = depths.empty() ? 0 : *std::ranges::max_element(depths);
    if (deepest < kCavityDepth) return {};
    const double least = std::min(tolerance, deepest / 2);
    DisjointSets sets(mesh.vertices.size());
    for (std::size_t i = 0; i < depths.size(); ++i) {
        if (depths[i] < least) continue;
        sets.join(mesh.triangles[i][0], mesh.triangles[i][1]);
        sets.join(mesh.triangles[i][0], mesh.triangles[i][2]);
    }
    std::map<std::uint32_t, ErrorPatch> pieces;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        if (depths[i] < least) continue;
        ErrorPatch& patch = pieces[sets.find(mesh.triangles[i][0])];
        const Facet facet = facetOf(mesh, i);
        if (patch.facets.empty()) patch.normal = Vec3::Zero();
        patch.volume += facet.area * depths[i];
        patch.normal += facet.area * facet.normal;
        if (depths[i] > patch.depth) {
            patch.depth = depths[i];
            patch.place = facet.centre;
        }
        patch.facets.push_back(facet);
    }
    std::vector<ErrorPatch> patches;
    for (auto& [first, patch] : pieces) {
        if (patch.volume < kLeastVolume) continue;
        patch.isOver = isOver;
        patch.normal = patch.normal.norm() > 0 ? Vec3(patch.normal.normalized()) : patch.facets.front().normal;
        patches.push_back(std::move(patch));
    }
    std::ranges::stable_sort(patches, std::ranges::greater(), &ErrorPatch::volume);
    return patches;
}

/// The side of a wall whose normal is level with one of four directions.
const MessageText& sideName(const Vec3& side, const DentalDirections& to) {
    const double mesial = side.dot(to.mesial), buccal = side.dot(to.buccal);
    const Vec3 up = Vec3::UnitZ() - to.axis.z() * to.axis;
    if (to.hasMesial && std::abs(mesial) >= std::abs(buccal)) return mesial > 0 ? msg::kWallMesial : msg::kWallDistal;
    if (to.hasBuccal && (to.hasMesial || std::abs(buccal) >= std::abs(mesial)))
        return buccal > 0 ? msg::kWallBuccal : msg::kWallLingual;
    return side.dot(up) > 0 ? msg::kWallOcclusal : msg::kWallGingival;
}

}  // namespace

ErrorPatches errorPatches(const Preparation& preparation, const CutSurfaces& surfaces) {
    return {patchesInside(surfaces.cut.mesh, *preparation.ideal, preparation.tolerance, true),
            patchesInside(surfaces.idealCut.mesh, *preparation.prepared, preparation.tolerance, false)};
}

const MessageText& wallName(const ErrorPatch& patch, const DentalDirections& to, bool isCrown) {
    if (patch.normal.dot(to.axis) > kFloorCosine) return isCrown ? msg::kWallEnd : msg::kWallFloor;
    // The normal of a cavity's wall points away from its side, that of a stump toward it.
    return sideName(isCrown ? patch.normal : Vec3(-patch.normal), to);
}

}  // namespace tactooth
