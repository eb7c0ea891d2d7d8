// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/cut_pace.h"

#include <algorithm>

namespace tactooth {
namespace {

constexpr double kShortest = 0.001;  // s between two surfaces: a tick
constexpr double kLongest = 0.03;    // s: after a longer pause the cut begins anew
constexpr double kEager = 1.1;       // of the pace of the cut: rather there a little early than left behind
constexpr double kLeastPace = 2.0;   // mm/s: what no cut holds any more gives way all the same

}  // namespace

void CutPace::grant(double way) {
    pace_ = kEager * way / std::clamp(sinceGrant_, kShortest, kLongest);
    sinceGrant_ = 0;
}

Pose CutPace::goal(const Pose& hand, const Pose& bur, const Vec3& handStep, double dt) const {
    const Vec3 way = hand.position - bur.position;
    const double left = way.norm();
    if (!(left > 0)) return hand;
    const Vec3 inward = way / left;
    const double step = std::max({pace_ * dt, kLeastPace * dt, handStep.norm()});
    if (step >= left) return hand;
    const Vec3 across = handStep - handStep.dot(inward) * inward;
    return {bur.position + step * inward + across, hand.rotation};
}

}  // namespace tactooth
