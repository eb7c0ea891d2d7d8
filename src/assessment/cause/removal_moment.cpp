// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cause/removal_moment.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "assessment/cause/error_place.h"
#include "assessment/cause/removal_cause.h"

namespace tactooth {
namespace {

constexpr double kBefore = 0.06;  // mm: more than two voxels of 0.025 mm before the surface, which were removed
/// Values of material that is still there: they have a place, but no moment.
constexpr std::array<std::string_view, 2> kOfWhatIsLeft = {"decay_left", "decay_share"};

/// The facets within a millimetre of `place`.
std::vector<Facet> facetsAround(const std::vector<Facet>& facets, const Vec3& place) {
    constexpr double kAround = 1.0;  // mm
    std::vector<Facet> around;
    for (const Facet& facet : facets) {
        if ((facet.centre - place).squaredNorm() <= kAround * kAround) around.push_back(facet);
    }
    return around;
}

/// What was removed at `place` of the cut surface: a point before the mean of the facets around it. At an angle of two
/// walls their mean normal points away from both. Nothing where there are no facets.
std::optional<RemovedPoint> removedAt(const std::vector<Facet>& facets, const Vec3& place) {
    constexpr double kBeside = kCavityEdge;  // mm: a facet is no larger
    Vec3 sum = Vec3::Zero();
    const Facet* nearest = nullptr;
    for (const Facet& facet : facets) {
        const double distance = (facet.centre - place).squaredNorm();
        if (distance < kBeside * kBeside) sum += facet.area * facet.normal;
        if (nearest == nullptr || distance < (nearest->centre - place).squaredNorm()) nearest = &facet;
    }
    if (nearest == nullptr) return std::nullopt;
    if (sum.norm() > 0) return RemovedPoint{place + kBefore * sum.normalized(), 1};
    return RemovedPoint{nearest->centre + kBefore * nearest->normal, 1};  // the mean of a curved wall lies beside it
}

/// Before each facet a piece as large as the facet.
std::vector<RemovedPoint> removedBefore(const std::vector<Facet>& facets) {
    constexpr std::size_t kMost = 200;  // points: more say nothing new
    std::vector<RemovedPoint> points;
    const std::size_t step = facets.size() / kMost + 1;
    for (std::size_t i = 0; i < facets.size(); i += step)
        points.push_back({facets[i].centre + kBefore * facets[i].normal, facets[i].area});
    return points;
}

/// The errors of one session: all are looked up together, in two walks through its track.
class ErrorLookup {
public:
    /// `place`: of the error. `facets`: of the surface that the error has made.
    void add(std::optional<double>& moment, std::optional<RemovalCause>& cause, const Vec3& place,
             const std::vector<Facet>& facets) {
        const auto at = removedAt(facets, place);
        if (!at) return;
        places_.push_back(*at);
        pieces_.push_back(removedBefore(facets));
        moments_.push_back(&moment);
        causes_.push_back(&cause);
    }

    void run(const std::shared_ptr<const SessionTrack>& track, const Vec3& axis) const {
        TrackTooth tooth(track);
        const auto moments = removalTimes(*track, tooth, places_, 0);
        const auto causes = removalCauses(*track, tooth, pieces_, axis);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            *moments_[i] = moments[i];
            if (moments[i]) *causes_[i] = causes[i];
        }
    }

private:
    std::vector<RemovedPoint> places_;
    std::vector<std::vector<RemovedPoint>> pieces_;
    std::vector<std::optional<double>*> moments_;
    std::vector<std::optional<RemovalCause>*> causes_;
};

bool isOfNeighbour(const MetricResult& result) { return result.metric->id.starts_with("neighbour"); }

std::vector<OverPreparation> overPreparations(const ErrorPatches& patches, const Preparation& preparation,
                                              const PreparationMeasures& measures) {
    const DentalDirections to(preparation.axis, preparation.mesialX);
    std::vector<OverPreparation> errors;
    for (const ErrorPatch& patch : patches.over) {
        if (errors.size() == kMostOverPreparations) break;
        errors.push_back(
            {&wallName(patch, to, measures.surfaces.isCrown), patch.depth, patch.volume, patch.place, {}, {}});
    }
    return errors;
}

}  // namespace

std::vector<OverPreparation> traceErrors(std::vector<MetricResult>& results, const Preparation& preparation,
                                         const PreparationMeasures& measures,
                                         const std::shared_ptr<const SessionTrack>& track) {
    const ErrorPatches patches = errorPatches(preparation, measures.surfaces);
    const std::vector<const ErrorPatch*> sources = placeErrors(results, preparation, measures, patches);
    std::vector<OverPreparation> errors = overPreparations(patches, preparation, measures);
    if (track == nullptr) return errors;
    ErrorLookup lookup;
    for (std::size_t i = 0; i < errors.size(); ++i)
        lookup.add(errors[i].moment, errors[i].cause, errors[i].place, patches.over[i].facets);
    const std::vector<Facet> ofNeighbours = facetsOf(preparation.cutNeighbours);
    for (std::size_t i = 0; i < results.size(); ++i) {
        Measured& measured = results[i].measured;
        if (!measured.place || std::ranges::find(kOfWhatIsLeft, results[i].metric->id) != kOfWhatIsLeft.end()) continue;
        if (sources[i] != nullptr && !sources[i]->isOver) continue;  // nothing was removed there
        const std::vector<Facet>& cut = isOfNeighbour(results[i]) ? ofNeighbours : measures.surfaces.facets;
        lookup.add(measured.moment, measured.cause, *measured.place,
                   sources[i] != nullptr ? sources[i]->facets : facetsAround(cut, *measured.place));
    }
    lookup.run(track, preparation.axis);
    return errors;
}

}  // namespace tactooth
