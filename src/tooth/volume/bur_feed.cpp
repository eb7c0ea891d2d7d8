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
constexpr double kStepAtLeast = 1.05;  // share of the least price that was tried; finds a slightly longer step too
constexpr double kAim = 0.985;         // share of the work to aim at, so that a near miss stays affordable

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
    PlannedRemoval best;
    double low = 0;
    double below = -kAim * work;
    double above = result.wanted - kAim * work;
    bool wasAbove = true;
    for (int trial = 0; trial < kTrials && work > 0 && std::isfinite(above); ++trial) {
        TACTOOTH_ASSERT(low <= high && below < 0 && above > 0);
        const double middle = low - (high - low) * below / (above - below);
        TACTOOTH_ASSERT(middle >= low && middle <= high);
        PlannedRemoval part = volume.removablePartWay(whole, envelope, from, between(from, to, middle));
        const double cost = costOf(part);
        const bool isAbove = cost > work;
        (isAbove ? above : below) = cost - kAim * work;
        if (isAbove) {
            high = middle, result.wanted = cost;
        } else {
            low = middle, best = std::move(part);
            if (cost >= kCloseEnough * work) break;
        }
        if (trial > 0 && isAbove == wasAbove) (isAbove ? below : above) /= 2;
        wasAbove = isAbove;
    }
    result.wanted *= kStepAtLeast;
    result.fraction = low;
    if (low > 0) result.carve = volume.carve(best);  // else nothing is affordable yet, and the work is kept
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
