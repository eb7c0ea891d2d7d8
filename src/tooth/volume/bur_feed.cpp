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

constexpr int kTrials = 6;  // two or three are usual, since the required work is smooth and grows with the path
constexpr double kCloseEnough = 0.97;  // share of the work; the rest is cut at the next update
constexpr double kAim = 0.985;         // share of the work to aim at, so that a near miss still stays within it

/// Search for the largest share of a path for which the work suffices. It lies between two bounds.
struct Search {
    double work = 0;
    double low = 0;
    double high = 1;
    double below = 0;        // required work at `low` less the work to aim at, N*m: negative
    double above = 0;        // the same at `high`: positive
    PlannedRemoval best;     // at `low`
    double workInPlace = 0;  // for the clearance around the bur where it is, N*m

    [[nodiscard]] double next() const {
        TACTOOTH_ASSERT(low <= high && below < 0 && above > 0);
        const double middle = low - (high - low) * below / (above - below);
        TACTOOTH_ASSERT(middle >= low && middle <= high);
        return middle;
    }
    /// Takes a share for which the work suffices. Returns true if it uses nearly all of the work.
    [[nodiscard]] bool accept(double share, PlannedRemoval part, double required) {
        TACTOOTH_ASSERT(required <= work);
        low = share, best = std::move(part), below = required - kAim * work;
        return required >= kCloseEnough * work;
    }
    void refuse(double share, double required) { high = share, above = required - kAim * work; }
};

/// Cuts the part of a path for which the work suffices. For a share of `high` (the removal `whole`) it does not.
/// Source: the Illinois method (M. Dowell, P. Jarratt, "A Modified Regula Falsi Method", BIT 11, 1971): the value of a
/// bound that stays for a second time is halved.
template <class WorkOf>
FeedResult feedWithWork(CutVolume& volume, const RevolutionEnvelope& envelope, const Pose& from, const Pose& to,
                        double work, double high, const PlannedRemoval& whole, const WorkOf& requiredFor) {
    TACTOOTH_ASSERT(high > 0 && high <= 1);
    FeedResult result;
    result.requiredWork = requiredFor(whole);
    TACTOOTH_ASSERT(result.requiredWork > work);
    Search search{.work = work, .below = -kAim * work, .best = {}};
    search.refuse(high, result.requiredWork);
    bool wasAbove = true;
    for (int trial = 0; trial < kTrials && work > 0 && std::isfinite(search.above); ++trial) {
        const double middle = search.next();
        PlannedRemoval part = volume.removableUpTo(whole, envelope, from, between(from, to, middle));
        const double required = requiredFor(part);
        const bool isAbove = required > work;
        if (isAbove) {
            search.refuse(middle, result.requiredWork = required);
        } else if (search.accept(middle, std::move(part), required)) {
            break;
        }
        if (trial == 0 && isAbove) {
            // A bur that was pushed to a new place must first cut the clearance around it. Work that does not suffice
            // for that suffices for no step.
            PlannedRemoval inPlace = volume.removableUpTo(whole, envelope, from, from);
            const double workInPlace = requiredFor(inPlace);
            if (workInPlace > work) {
                result.requiredWork = workInPlace;
                break;
            }
            search.workInPlace = workInPlace;
            if (search.accept(0, std::move(inPlace), workInPlace)) {
                result.requiredWork = 0;
                break;
            }
        } else if (trial > 0 && isAbove == wasAbove) {
            (isAbove ? search.below : search.above) /= 2;
        }
        wasAbove = isAbove;
    }
    result.fraction = search.low;
    if (search.low > 0 || search.workInPlace > 0) result.carve = volume.carve(search.best);  // else no work is used
    if (search.low == 0) result.requiredWork = std::max(0.0, result.requiredWork - search.workInPlace);
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
    const auto requiredFor = [&](const PlannedRemoval& part) { return workFor(part.volumes, materials, sharpness); };
    double high = std::min(enough, 1.0);
    PlannedRemoval whole = volume.removable(envelope, from, between(from, to, high));
    if (high < 1 && requiredFor(whole) <= work) whole = volume.removable(envelope, from, between(from, to, high = 1));
    FeedResult result;
    if (requiredFor(whole) <= work) {
        result.fraction = 1;
        result.carve = volume.carve(whole);
    } else {
        result = feedWithWork(volume, envelope, from, to, work, high, whole, requiredFor);
    }
    result.work = workFor(result.carve.removed, materials, sharpness);
    TACTOOTH_ASSERT(result.work <= work);
    TACTOOTH_ASSERT(result.fraction >= 0 && result.fraction <= 1);
    return result;
}

}  // namespace tactooth
