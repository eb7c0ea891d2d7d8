// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/bur_feed.h"

#include <limits>

// Removal law: the volume cut grows with normal force and rim travel (F. W. Preston, "The Theory and Design of Plate
// Glass Polishing Machines", J. Soc. Glass Technology 11, 1927), with one coefficient a material.

namespace tactooth {
namespace {

constexpr int kTrials = 6;             // of regula falsi: the cost is smooth and grows with the way
constexpr double kCloseEnough = 0.97;  // of the work: a last per cent is cut at the next update
constexpr double kAim = 0.985;         // of the work: a trial that misses by a hair shall miss on the affordable side

}  // namespace

double workFor(const MaterialVolumes& volumes, const MaterialTable& materials, double sharpness) {
    double work = 0;
    for (std::size_t i = 0; i < kMaterialCount; ++i) {
        if (volumes[i] > 0) work += volumes[i] / (materials[static_cast<MaterialId>(i)].removal * sharpness);
    }
    return sharpness > 0 || work == 0 ? work : std::numeric_limits<double>::infinity();
}

Pose between(const Pose& from, const Pose& to, double fraction) {
    if (fraction >= 1) return to;
    return {from.position + fraction * (to.position - from.position),
            from.rotation.slerp(fraction, to.rotation).normalized()};
}

FeedResult feedBur(CutVolume& volume, const RevolutionEnvelope& envelope, const Pose& from, const Pose& to, double work,
                   const MaterialTable& materials, double sharpness) {
    const Removable removable = volume.removable(envelope, from, to);
    const auto costOf = [&](double fraction) {
        return workFor(volume.removableOnTheWay(removable, envelope, from, between(from, to, fraction)), materials,
                       sharpness);
    };
    const double whole = workFor(removable.volumes, materials, sharpness);
    double low = 0;
    double lowCost = 0;
    double high = 1;
    double highCost = whole;
    if (whole <= work) {
        low = 1;
        lowCost = whole;
    }
    for (int trial = 0; trial < kTrials && low < 1 && lowCost < kCloseEnough * work; ++trial) {
        const double middle =
            trial % 2 == 0 ? low + (high - low) * (kAim * work - lowCost) / (highCost - lowCost) : (low + high) / 2;
        const double cost = costOf(middle);
        if (cost <= work) {
            low = middle, lowCost = cost;
        } else {
            high = middle, highCost = cost;
        }
    }
    FeedResult result;
    result.fraction = low;
    if (low == 0) {  // nothing is affordable yet: the work is kept for the next time
        result.wanted = highCost;
        return result;
    }
    result.carve = low < 1 ? volume.carve(envelope, from, between(from, to, low)) : volume.carve(removable);
    result.work = workFor(result.carve.removed, materials, sharpness);
    return result;
}

}  // namespace tactooth
