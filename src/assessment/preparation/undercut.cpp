// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/undercut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "assessment/messages.h"
#include "assessment/preparation/cut_patch.h"
#include "geometry/util/degree.h"
#include "geometry/util/parallel_for.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

const double kFacingAway = -std::sin(kDegree);  // cosine: a degree is more than the noise of a cut
const double kFacingAwayOfScan = -std::sin(2 * kDegree);
constexpr double kLift = 0.01;        // mm: start of a ray off the surface, so that it does not meet its own triangle
constexpr double kStep = 0.05;        // mm: of the search for the end of an overhang
constexpr double kDeepest = 3;        // mm: more than any wall hangs over
constexpr double kFloorLevel = 0.95;  // cosine: a floor has no side toward which its overhang ends
constexpr int kHalvings = 9;          // to a ten-thousandth of a millimetre
constexpr std::size_t kGrain = 32;    // facets: some hundred rays
constexpr std::size_t kRow = 512;     // facets after which it is seen whether the rest can still matter

class Overhang {
public:
    Overhang(const Surface& prepared, const Vec3& axis) : prepared_(prepared), axis_(axis) {}

    [[nodiscard]] bool isHidden(const Vec3& place) const { return meetsAny(prepared_, {place, axis_}); }

    /// Whether something hangs over even `depth` mm from `place` along `aside`.
    [[nodiscard]] bool isDeeperAt(const Vec3& place, const Vec3& aside, double depth) const {
        return isHidden(place + kLift * axis_ + depth * aside);
    }

    /// Level distance from `place` along `aside` (unit) to where nothing hangs over; nothing if there is no such place.
    [[nodiscard]] double depthAt(const Vec3& place, const Vec3& aside) const {
        const Vec3 start = place + kLift * axis_;
        double hidden = 0;
        while (isHidden(start + (hidden + kStep) * aside)) {
            hidden += kStep;
            if (hidden > kDeepest) return 0;
        }
        double free = hidden + kStep;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = (hidden + free) / 2;
            (isHidden(start + middle * aside) ? hidden : free) = middle;
        }
        return (hidden + free) / 2;
    }

private:
    const Surface& prepared_;
    Vec3 axis_;
};

/// The directions within 10 degrees of the axis, on a grid of one degree.
std::vector<Vec3> directionsAround(const Vec3& axis) {
    constexpr int kMostTilt = 10;  // degrees
    const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
    std::vector<Vec3> directions;
    for (int i = -kMostTilt; i <= kMostTilt; ++i) {
        for (int j = -kMostTilt; j <= kMostTilt; ++j) {
            const double tilt = std::hypot(i, j) * kDegree;
            if (tilt > kMostTilt * kDegree + 1e-9 || tilt == 0) continue;
            const Vec3 aside = (i * u + j * v).normalized();
            directions.emplace_back(std::cos(tilt) * axis + std::sin(tilt) * aside);
        }
    }
    return directions;
}

using RowMarks = std::array<std::uint8_t, kRow>;

/// Whether each facet of a row is hidden along `direction`, though it does not face away from it.
void findHidden(const Surface& prepared, std::span<const Facet> row, const Vec3& direction, RowMarks& isHidden) {
    parallelFor(
        row.size(),
        [&](std::size_t i) {
            const Facet& facet = row[i];
            const double cosine = facet.normal.dot(direction);
            // Along a wall that faces away by less than a degree, so that its ray does not run into it.
            const Vec3 ray = cosine < 0 ? Vec3((direction - cosine * facet.normal).normalized()) : direction;
            isHidden[i] =
                cosine >= kFacingAway && Overhang(prepared, ray).isHidden(facet.centre + kLift * facet.normal);
        },
        kGrain);
}

/// The undercut area along `direction`, of which `facingAway` faces away from it; or, as soon as it is known that the
/// area is not less than `limit`, any that is not.
double undercutAlong(const Surface& prepared, const std::vector<Facet>& facets, const Vec3& direction,
                     double facingAway, double limit) {
    RowMarks isHidden;
    double area = facingAway;
    for (std::size_t from = 0; from < facets.size() && area < limit; from += kRow) {
        const std::span<const Facet> row = std::span(facets).subspan(from, std::min(kRow, facets.size() - from));
        findHidden(prepared, row, direction, isHidden);
        for (std::size_t i = 0; i < row.size(); ++i) area += isHidden[i] != 0 ? row[i].area : 0;
    }
    return area;
}

/// The least undercut of all directions. What faces away needs no rays, so the directions with the least of it come
/// first, and most of the others need no more than that.
double leastUndercut(const Surface& prepared, const CutSurfaces& surfaces, const Vec3& axis, double ofAxis) {
    // Of a large preparation one facet stands for some, so that all directions take about a second.
    constexpr std::size_t kMostFacets = 8000;
    const std::size_t every = (surfaces.facets.size() + kMostFacets - 1) / kMostFacets;
    std::vector<Facet> facets;
    double all = 0, chosen = 0;
    for (std::size_t i = 0; i < surfaces.facets.size(); ++i) {
        all += surfaces.facets[i].area;
        if (i % every != 0) continue;
        facets.push_back(surfaces.facets[i]);
        chosen += facets.back().area;
    }
    for (Facet& facet : facets) facet.area *= all / chosen;
    struct Tried {
        double facingAway;
        Vec3 direction;
    };
    std::vector<Tried> tried;
    for (const Vec3& direction : directionsAround(axis)) {
        double area = 0;
        for (const Facet& facet : facets) {
            if (facet.normal.dot(direction) < kFacingAway) area += facet.area;
        }
        tried.push_back({area, direction});
    }
    std::ranges::stable_sort(tried, {}, &Tried::facingAway);
    double least = ofAxis;
    for (const auto& [facingAway, direction] : tried) {
        if (!(facingAway < least)) break;
        least = std::min(least, undercutAlong(prepared, facets, direction, facingAway, least));
    }
    return least;
}

/// Whether something hangs over the facet along its own wall, which faces away by less than two degrees: not the wall.
bool isHiddenAlong(const Surface& prepared, const Facet& facet, const Vec3& axis) {
    const double cosine = facet.normal.dot(axis);
    if (cosine >= 0) return true;  // hidden along the axis
    const Vec3 along = (axis - cosine * facet.normal).normalized();
    return Overhang(prepared, along).isHidden(facet.centre + kLift * facet.normal);
}

struct Found {
    double depth = 0;  // mm
    bool isUndercut = false, isOfScan = false;
    Vec3 place = Vec3::Zero();
};

}  // namespace

Undercut undercut(const Preparation& preparation, const CutSurfaces& surfaces) {
    if (surfaces.facets.empty())
        return {Measured::none(msg::kNothingCut), Measured::none(msg::kNothingCut), Measured::none(msg::kNothingCut),
                Measured::none(msg::kNothingCut)};
    const Surface prepared{.base = preparation.prepared};
    const Overhang overhang(prepared, preparation.axis);
    std::vector<Found> found(surfaces.facets.size());
    parallelFor(
        found.size(),
        [&](std::size_t i) {
            const Facet& facet = surfaces.facets[i];
            const double cosine = facet.normal.dot(preparation.axis);
            const bool isHidden = overhang.isHidden(facet.centre + kLift * facet.normal);
            found[i].isUndercut = cosine < kFacingAway || isHidden;
            found[i].isOfScan =
                cosine < kFacingAwayOfScan || (isHidden && isHiddenAlong(prepared, facet, preparation.axis));
            if (!found[i].isUndercut || !isHidden || std::abs(cosine) > kFloorLevel) return;
            const Vec3 aside = (facet.normal - cosine * preparation.axis).normalized();
            for (int corner = 0; corner < 3; ++corner) {
                const Vec3 place = surfaces.cut.mesh.corner(i, corner);
                if (!overhang.isDeeperAt(place, aside, found[i].depth)) continue;
                const double depth = overhang.depthAt(place, aside);
                if (depth > found[i].depth) {
                    found[i].depth = depth;
                    found[i].place = place;
                }
            }
        },
        kGrain);
    double area = 0, ofScan = 0;
    Found deepest;
    CutPatch patch;
    for (std::uint32_t i = 0; i < found.size(); ++i) {
        if (found[i].isUndercut) area += surfaces.facets[i].area;
        if (found[i].isUndercut) patch.push_back(i);
        if (found[i].isOfScan) ofScan += surfaces.facets[i].area;
        if (found[i].depth > deepest.depth) deepest = found[i];
    }
    const bool isAny = deepest.depth > 0;
    if (!(area > 0)) return {Measured::of(0), Measured::of(0), Measured::of(0), Measured::of(0)};
    const Vec3 place = isAny ? deepest.place : surfaces.facets[connectedPieces(surfaces, patch).front().front()].centre;
    const double best = leastUndercut(prepared, surfaces, preparation.axis, area);
    return {Measured::at(area, place), best > 0 ? Measured::at(best, place) : Measured::of(0),
            ofScan > 0 ? Measured::at(ofScan, place) : Measured::of(0),
            isAny ? Measured::at(deepest.depth, deepest.place) : Measured::of(0)};
}

}  // namespace tactooth
