// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/enamel_support.h"

#include <algorithm>
#include <limits>

#include "assessment/messages.h"
#include "assessment/preparation/cut_patch.h"
#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kLift = 0.03;      // mm: into the tooth, more than a cut of a voxel and a simplified wall differ
constexpr std::size_t kGrain = 64;  // facets

std::vector<Surface> dentinOf(const LayeredTooth& tooth) {
    std::vector<Surface> dentin;
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        if (tooth.materials().hasRole(layer.material, MaterialRole::Dentin)) dentin.push_back({.base = layer.part});
    }
    return dentin;
}

}  // namespace

Measured unsupportedEnamel(const Preparation& preparation, const CutSurfaces& surfaces) {
    if (preparation.tooth == nullptr) return Measured::none(msg::kNoTissueKnown);
    const LayeredTooth& tooth = *preparation.tooth;
    const std::vector<Surface> dentin = dentinOf(tooth);
    if (dentin.empty()) return Measured::none(msg::kNoTissueKnown);
    if (surfaces.facets.empty()) return Measured::none(msg::kNothingCut);
    const Surface prepared{.base = preparation.prepared};
    const auto isUnsupported = [&](const Facet& facet) {
        const Vec3 below = facet.centre - kLift * facet.normal;
        if (!tooth.materials().hasRole(tooth.materialAt(below), MaterialRole::Enamel)) return false;
        const auto outside = closestPoint(*preparation.original, below);
        if (!outside || !(outside->distance > 0)) return false;
        const Ray inward{below, (below - outside->point) / outside->distance};
        double toDentin = std::numeric_limits<double>::infinity();
        for (const Surface& each : dentin) toDentin = std::min(toDentin, firstHit(each, inward).value_or(toDentin));
        const auto out = firstHit(prepared, inward);
        return out.has_value() && *out < toDentin;
    };
    std::vector<std::uint8_t> found(surfaces.facets.size());
    parallelFor(
        found.size(), [&](std::size_t i) { found[i] = isUnsupported(surfaces.facets[i]) ? 1 : 0; }, kGrain);
    CutPatch patch;
    for (std::uint32_t i = 0; i < found.size(); ++i) {
        if (found[i] != 0) patch.push_back(i);
    }
    if (patch.empty()) return Measured::of(0);
    Vec3 place = Vec3::Zero();
    const CutPatch largest = connectedPieces(surfaces, patch).front();
    const double area = areaOf(surfaces, largest);
    for (const std::uint32_t i : largest) place += surfaces.facets[i].area / area * surfaces.facets[i].centre;
    return Measured::at(areaOf(surfaces, patch), place);
}

}  // namespace tactooth
