// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/bur_feed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// Removal law: the volume cut grows with normal force and rim travel (F. W. Preston, "The Theory and Design of Plate
// Glass Polishing Machines", J. Soc. Glass Technology 11, 1927), with one coefficient a material.

namespace tactooth {
namespace {

constexpr int kTrials = 6;             // two or three as a rule: the cost is smooth and grows with the way
constexpr double kCloseEnough = 0.97;  // of the work: a last per cent is cut at the next update
constexpr double kStepAtLeast = 1.05;  // of the price of the least step that was tried: one a hair longer is found, too
constexpr double kAim = 0.985;         // of the work: a trial that misses by a hair shall miss on the affordable side

/// Cuts a part of a way of which a share of `high` (`whole`) is too dear. The Illinois method (M. Dowell, P. Jarratt,
/// "A Modified Regula Falsi Method", BIT 11, 1971): an end that stays for a second time counts half.
template <class CostOf>
FeedResult feedPartWay(CutVolume& volume, const RevolutionEnvelope& envelope, const Pose& from, const Pose& to,
                       double work, double high, const PlannedRemoval& whole, const CostOf& costOf) {
    FeedResult result;
    result.wanted = costOf(whole);
    PlannedRemoval best;
    double low = 0;
    double below = -kAim * work;
    double above = result.wanted - kAim * work;
    bool wasAbove = true;
    for (int trial = 0; trial < kTrials && work > 0 && std::isfinite(above); ++trial) {
        const double middle = low - (high - low) * below / (above - below);
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
    if (low > 0) result.carve = volume.carve(best);  // else nothing is affordable yet: the work is kept
    return result;
}

}  // namespace

double workFor(const MaterialVolumes& volumes, const MaterialTable& materials, double sharpness) {
    double work = 0;
    for (const MaterialId id : materials.registry().ids()) {
        const double volume = volumes[static_cast<std::size_t>(id)];
        if (volume > 0) work += volume / (materials[id].removal * sharpness);
    }
    return sharpness > 0 || work == 0 ? work : std::numeric_limits<double>::infinity();
}

Pose between(const Pose& from, const Pose& to, double fraction) {
    if (fraction >= 1) return to;
    return {from.position + fraction * (to.position - from.position),
            from.rotation.slerp(fraction, to.rotation).normalized()};
}

FeedResult feedBur(CutVolume& volume, const RevolutionEnvelope& envelope, const Pose& from, const Pose& to, double work,
                   const MaterialTable& materials, double sharpness, double enough) {
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
    return result;
}

}  // namespace tactooth
