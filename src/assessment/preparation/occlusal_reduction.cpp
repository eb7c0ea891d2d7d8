// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/occlusal_reduction.h"

#include <algorithm>
#include <vector>

#include "assessment/messages.h"
#include "assessment/preparation/cut_patch.h"
#include "assessment/preparation/quantile.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kWallCosine = 0.5;     // of normal and axis: a wall leans 30 degrees at most
constexpr double kEndCosine = 0.75;     // what looks up within 40 degrees is no slope of a lingual fossa
constexpr double kRoundedBorder = 0.1;  // mm: strip along the border; the end of an incisor is narrow
constexpr double kLeastEnd = 0.3;       // mm^2
constexpr double kLeastShare = 0.05;    // of the area: less may be the edge of one stroke

/// Mean height along the axis, by area.
double heightOf(const CutSurfaces& surfaces, const CutPatch& patch, const Vec3& axis) {
    double sum = 0;
    for (const std::uint32_t i : patch) sum += surfaces.facets[i].area * surfaces.facets[i].centre.dot(axis);
    return sum / std::max(areaOf(surfaces, patch), 1e-12);
}

}  // namespace

OcclusalReduction occlusalReduction(const Preparation& preparation, const CutSurfaces& surfaces) {
    const auto none = [](const MessageText& reason) {
        return OcclusalReduction{Measured::none(reason), Measured::none(reason)};
    };
    if (surfaces.facets.empty()) return none(msg::kNothingCut);
    if (!surfaces.isCrown) return none(msg::kNoCrownPreparation);
    const Vec3& axis = preparation.axis;
    const double middle = heightOf(surfaces, patchBetween(surfaces, axis, -kWallCosine, kWallCosine), axis);
    CutPatch end;
    for (const CutPatch& piece : connectedPieces(surfaces, patchBetween(surfaces, axis, kEndCosine, 1.1))) {
        if (heightOf(surfaces, piece, axis) > middle) end.insert(end.end(), piece.begin(), piece.end());
    }
    std::ranges::sort(end);
    end = withoutBorder(surfaces, end, kRoundedBorder);
    const double area = areaOf(surfaces, end);
    if (area < kLeastEnd) return none(msg::kNoOcclusalEnd);
    struct Depth {
        double depth, area;
        Vec3 place;
    };
    std::vector<Depth> depths;
    for (const std::uint32_t i : end) {
        const Facet& facet = surfaces.facets[i];
        depths.push_back({depthInside(*preparation.original, facet.centre, axis), facet.area, facet.centre});
    }
    std::ranges::stable_sort(depths, {}, &Depth::depth);
    const auto at = [&](double share) {
        const Depth& found = quantileByArea(depths, area, share, &Depth::area);
        return Measured::at(found.depth, found.place);
    };
    return {at(kLeastShare), Measured::of(*at(0.5).value)};
}

}  // namespace tactooth
