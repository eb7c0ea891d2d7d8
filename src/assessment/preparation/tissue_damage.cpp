// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/tissue_damage.h"

#include <algorithm>
#include <functional>

#include "assessment/messages.h"
#include "collision/bvh/closest_point.h"
#include "geometry/util/parallel_for.h"

namespace tactooth {
namespace {

constexpr std::size_t kGrain = 64;  // distances: about half a millisecond

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
        damage.neighbourDepth = Measured::none(msg::kNoNeighbourKnown);
    } else if (preparation.cutNeighbours.empty()) {
        damage.neighbourDepth = Measured::of(0);
    } else {
        const auto depth = [&](const Vec3& place) {
            return std::max(0.0, -signedDistance(*preparation.neighbours, place));
        };
        damage.neighbourDepth = extreme(preparation.cutNeighbours, depth, std::greater<>());
        if (*damage.neighbourDepth.value == 0) damage.neighbourDepth.place.reset();
    }
    return damage;
}

}  // namespace tactooth
