// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/tissue_damage.h"

#include <algorithm>
#include <functional>

#include "assessment/messages.h"
#include "collision/bvh/closest_point.h"
#include "geometry/mesh/vertex_welder.h"
#include "geometry/util/disjoint_sets.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr double kScratchDepth = 0.05, kNickDepth = 0.2;  // mm
constexpr std::size_t kGrain = 64;                        // distances: about half a millisecond

/// The value of `measure(vertex)` at each vertex that a triangle uses that is best by `isBetter`, and its place.
template <class Measure, class IsBetter>
Measured extreme(const TriangleMesh& mesh, const Measure& measure, const IsBetter& isBetter) {
    std::vector<std::uint32_t> used;
    for (const Triangle& t : mesh.triangles) used.insert(used.end(), t.begin(), t.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<double> values(used.size());
    parallelFor(
        used.size(), [&](std::size_t i) { values[i] = measure(mesh.vertices[used[i]].cast<double>()); }, kGrain);
    std::size_t best = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (isBetter(values[i], values[best])) best = i;
    }
    return Measured::at(values[best], mesh.vertices[used[best]].cast<double>());
}

/// Depth of each connected cut in the neighbours that is deep enough to count, mm.
std::vector<double> scratchesIn(const TriangleMesh& cut, const SurfacePart& neighbours) {
    std::vector<Vec3f> corners;  // the pieces of surface meet at equal places
    for (const Triangle& t : cut.triangles) {
        for (const std::uint32_t vertex : t) corners.push_back(cut.vertices[vertex]);
    }
    const TriangleMesh mesh = weld(corners);
    std::vector<double> depths(mesh.vertices.size());
    parallelFor(
        depths.size(), [&](std::size_t i) { depths[i] = -signedDistance(neighbours, mesh.vertices[i].cast<double>()); },
        kGrain);
    DisjointSets pieces(mesh.vertices.size());
    for (const Triangle& t : mesh.triangles) {
        const bool isDeep = std::ranges::any_of(t, [&](std::uint32_t v) { return depths[v] > kScratchDepth; });
        if (!isDeep) continue;
        pieces.join(t[0], t[1]);
        pieces.join(t[0], t[2]);
    }
    std::vector<double> deepest(mesh.vertices.size());
    for (std::uint32_t i = 0; i < depths.size(); ++i) {
        double& depth = deepest[pieces.find(i)];
        depth = std::max(depth, depths[i]);
    }
    std::erase_if(deepest, [](double depth) { return depth <= kScratchDepth; });
    return deepest;
}

}  // namespace

TissueDamage tissueDamage(const Preparation& preparation, const CutSurfaces& surfaces) {
    TissueDamage damage;
    if (preparation.pulps.empty()) {
        damage.remainingDentin = damage.pulpOpen = Measured::none(msg::kNoPulpKnown);
    } else if (surfaces.facets.empty()) {
        damage.remainingDentin = Measured::none(msg::kNothingCut);
        damage.pulpOpen = Measured::of(0);
    } else {
        const auto toPulp = [&](const Vec3& place) {
            double least = signedDistance(*preparation.pulps.front(), place);
            for (const auto& pulp : preparation.pulps) least = std::min(least, signedDistance(*pulp, place));
            return least;
        };
        damage.remainingDentin = extreme(surfaces.cut.mesh, toPulp, std::less<>());
        const bool isOpen = *damage.remainingDentin.value <= 0;
        damage.pulpOpen = isOpen ? Measured::at(1, *damage.remainingDentin.place) : Measured::of(0);
        if (isOpen) damage.remainingDentin.value = 0;
    }
    if (preparation.neighbours == nullptr) {
        damage.neighbourDepth = damage.neighbourScratches = damage.neighbourNicks =
            Measured::none(msg::kNoNeighbourKnown);
    } else if (preparation.cutNeighbours.empty()) {
        damage.neighbourDepth = damage.neighbourScratches = damage.neighbourNicks = Measured::of(0);
    } else {
        const auto depth = [&](const Vec3& place) {
            return std::max(0.0, -signedDistance(*preparation.neighbours, place));
        };
        damage.neighbourDepth = extreme(preparation.cutNeighbours, depth, std::greater<>());
        if (*damage.neighbourDepth.value == 0) damage.neighbourDepth.place.reset();
        const std::vector<double> scratches = scratchesIn(preparation.cutNeighbours, *preparation.neighbours);
        const auto nicks = std::ranges::count_if(scratches, [](double deep) { return deep > kNickDepth; });
        damage.neighbourScratches = Measured::of(static_cast<double>(scratches.size()));
        damage.neighbourNicks = Measured::of(static_cast<double>(nicks));
    }
    return damage;
}

}  // namespace tactooth
