// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/bur_feed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/util/assert.h"

// Source of the removal law: F. W. Preston, "The Theory and Design of Plate Glass Polishing Machines", J. Soc. Glass
// Technology 11, 1927. The removed volume is proportional to normal force times rim travel. Difference: each material
// has its own coefficient.

namespace tactooth {
namespace {

constexpr int kTrials = 6;             // two or three are usual, since the cost is smooth and grows with the path
constexpr double kCloseEnough = 0.97;  // share of the work; the rest is cut at the next update
constexpr double kAim = 0.985;         // share of the work to aim at, so that a near miss stays affordable

/// The affordable part of a path ends between two shares of it.
struct Search {
    double work = 0;
    double low = 0;
    double high = 1;
    double below = 0;        // cost at `low`, from the work to aim at, N*m: below 0
    double above = 0;        // the same at `high`: above 0
    PlannedRemoval best;     // at `low`
    double paidInPlace = 0;  // price of the clearance around the bur where it is, N*m

    [[nodiscard]] double next() const {
        TACTOOTH_ASSERT(low <= high && below < 0 && above > 0);
        const double middle = low - (high - low) * below / (above - below);
        TACTOOTH_ASSERT(middle >= low && middle <= high);
        return middle;
    }
    /// A share that the work pays for. Returns true if it is close enough.
    [[nodiscard]] bool accept(double share, PlannedRemoval part, double cost) {
        TACTOOTH_ASSERT(cost <= work);
        low = share, best = std::move(part), below = cost - kAim * work;
        return cost >= kCloseEnough * work;
    }
    void refuse(double share, double cost) { high = share, above = cost - kAim * work; }
};

/// Cuts the affordable part of a path. A share of `high` (the removal `whole`) is too expensive. Source: the Illinois
/// method (M. Dowell, P. Jarratt, "A Modified Regula Falsi Method", BIT 11, 1971): an end that stays for a second time
/// counts half.
template <class CostOf>
FeedResult feedPartWay(CutVolume& volume, const RevolutionEnvelope& envelope, const Pose& from, const Pose& to,
                       double work, double high, const PlannedRemoval& whole, const CostOf& costOf) {
    TACTOOTH_ASSERT(high > 0 && high <= 1);
    FeedResult result;
    result.wanted = costOf(whole);
    TACTOOTH_ASSERT(result.wanted > work);
    Search search{.work = work, .below = -kAim * work, .best = {}};
    search.refuse(high, result.wanted);
    bool wasAbove = true;
    for (int trial = 0; trial < kTrials && work > 0 && std::isfinite(search.above); ++trial) {
        const double middle = search.next();
        PlannedRemoval part = volume.removablePartWay(whole, envelope, from, between(from, to, middle));
        const double cost = costOf(part);
        const bool isAbove = cost > work;
        if (isAbove) {
            search.refuse(middle, result.wanted = cost);
        } else if (search.accept(middle, std::move(part), cost)) {
            break;
        }
        if (trial == 0 && isAbove) {
            // A bur that was pushed to a new place must first cut the clearance around it. Work that does not pay for
            // that pays for no step.
            PlannedRemoval inPlace = volume.removablePartWay(whole, envelope, from, from);
            const double price = costOf(inPlace);
            if (price > work) {
                result.wanted = price;
                break;
            }
            search.paidInPlace = price;
            if (search.accept(0, std::move(inPlace), price)) {
                result.wanted = 0;
                break;
            }
        } else if (trial > 0 && isAbove == wasAbove) {
            (isAbove ? search.below : search.above) /= 2;
        }
        wasAbove = isAbove;
    }
    result.fraction = search.low;
    if (search.low > 0 || search.paidInPlace > 0) result.carve = volume.carve(search.best);  // else the work is kept
    if (search.low == 0) result.wanted = std::max(0.0, result.wanted - search.paidInPlace);
    return result;
}

}  // namespace

double workFor(const MaterialVolumes& volumes, const MaterialTable& materials, double sharpness) {
    TACTOOTH_ASSERT(std::isfinite(sharpness) && sharpness >= 0);
    double work = 0;
    for (const MaterialId id : materials.registry().ids()) {
        const double volume = volumes[static_cast<std::size_t>(id)];
        if (volume > 0) work += volume / (materials[id].removal * sharpness);
    }
    TACTOOTH_ASSERT(work >= 0);
    return sharpness > 0 || work == 0 ? work : std::numeric_limits<double>::infinity();
}

Pose between(const Pose& from, const Pose& to, double fraction) {
    TACTOOTH_ASSERT(fraction >= 0);
    if (fraction >= 1) return to;
    return {from.position + fraction * (to.position - from.position),
            from.rotation.slerp(fraction, to.rotation).normalized()};
}

FeedResult feedBur(CutVolume& volume, const RevolutionEnvelope& envelope, const Pose& from, const Pose& to, double work,
                   const MaterialTable& materials, double sharpness, double enough) {
    TACTOOTH_ASSERT(work >= 0);
    TACTOOTH_ASSERT(enough > 0);
    const auto costOf = [&](const PlannedRemoval& part) { return workFor(part.volumes, materials, sharpness); };
    double high = std::min(enough, 1.0);
    PlannedRemoval whole = volume.removable(envelope, from, between(from, to, high));
    if (high < 1 && costOf(whole) <= work) whole = volume.removable(envelope, from, between(from, to, high = 1));
    FeedResult result;
    if (costOf(whole) <= work) {
        result.fraction = 1;
        result.carve = volume.carve(whole);
    } else {
        result = feedPartWay(volume, envelope, from, to, work, high, whole, costOf);
    }
    result.work = workFor(result.carve.removed, materials, sharpness);
    TACTOOTH_ASSERT(result.work <= work);
    TACTOOTH_ASSERT(result.fraction >= 0 && result.fraction <= 1);
    return result;
}

}  // namespace tactooth
