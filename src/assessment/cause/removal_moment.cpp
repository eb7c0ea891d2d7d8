// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cause/removal_moment.h"

#include <algorithm>
#include <array>

#include "assessment/cause/removal_cause.h"
#include "collision/bvh/closest_point.h"

namespace tactooth {
namespace {

constexpr double kBefore = 0.06;  // mm: more than two voxels of 0.025 mm before the surface, which were removed
constexpr std::array<std::string_view, 5> kOfRemoval = {"over_max", "undercut_depth", "pulp_open",
                                                        "remaining_dentin_min", "floor_depth_median"};

/// The mean normal of the facets around `place`: at an angle of two walls it points away from both.
Vec3 outwardAt(const CutSurfaces& surfaces, const Vec3& place) {
    constexpr double kAround = kCavityEdge;  // mm: a facet is no larger
    Vec3 sum = Vec3::Zero();
    for (const Facet& facet : surfaces.facets) {
        if ((facet.centre - place).squaredNorm() < kAround * kAround) sum += facet.area * facet.normal;
    }
    return sum.norm() > 0 ? Vec3(sum.normalized()) : sum;
}

/// What was removed beside an error: over each facet around `place` a piece as large as the facet. `least`: how far the
/// facets lie beyond the ideal surface, mm; nothing: anywhere.
std::vector<RemovedPoint> removedAround(const Preparation& preparation, const CutSurfaces& surfaces, const Vec3& place,
                                        std::optional<double> least) {
    constexpr double kAround = 1.0;     // mm
    constexpr std::size_t kMost = 200;  // points: more say nothing new
    std::vector<RemovedPoint> points;
    for (const Facet& facet : surfaces.facets) {
        if ((facet.centre - place).squaredNorm() > kAround * kAround) continue;
        if (least && -signedDistance(*preparation.ideal, facet.centre) < *least) continue;
        points.push_back({facet.centre + kBefore * facet.normal, facet.area});
    }
    const std::size_t step = points.size() / kMost + 1;
    std::vector<RemovedPoint> some;
    for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
    return some;
}

}  // namespace

std::optional<double> removalMoment(const SessionTrack& track, TrackTooth& tooth, const Vec3& place,
                                    const Vec3& outward) {
    const Vec3 removed = place + kBefore * outward;
    const auto isThere = [&](std::uint64_t moment) {
        tooth.moveTo(moment);
        return contains(*tooth.model().surface(), removed);
    };
    std::uint64_t there = 0, gone = track.ticks();
    if (gone == 0 || !isThere(there) || isThere(gone)) return std::nullopt;
    while (gone - there > 1) {
        const std::uint64_t middle = there + (gone - there) / 2;
        (isThere(middle) ? there : gone) = middle;
    }
    return track.tickBefore(gone).time;
}

void addMoments(std::vector<MetricResult>& results, const Preparation& preparation, const PreparationMeasures& measures,
                const std::shared_ptr<const SessionTrack>& track) {
    if (measures.surfaces.facets.empty()) return;
    TrackTooth tooth(track);
    for (MetricResult& result : results) {
        const bool isOfRemoval = std::ranges::find(kOfRemoval, result.metric->id) != kOfRemoval.end();
        if (!isOfRemoval || !result.measured.place) continue;
        const Vec3& place = *result.measured.place;
        result.measured.moment = removalMoment(*track, tooth, place, outwardAt(measures.surfaces, place));
        if (!result.measured.moment) continue;
        const bool isOver = result.metric->id == "over_max";
        const auto points = removedAround(preparation, measures.surfaces, place,
                                          isOver ? std::optional(*result.measured.value / 2) : std::nullopt);
        result.measured.cause = removalCause(*track, tooth, points, preparation.axis);
    }
}

}  // namespace tactooth
