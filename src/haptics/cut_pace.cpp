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

// A bur that hangs back farther than a hand presses catches up as far as the cut has made room ...
constexpr double kUsualLag = 0.5;  // mm: 1 N on 2 N/mm, as soft as a tooth is made to feel
// ... by what is beyond that within so many seconds: a person sees no such lag, and no tick makes a leap of it.
constexpr double kCatchUp = 0.05;

// What late ticks have left is made up for at once up to this, mm. Of a longer way more is in doubt than a tick has
// time to look at, and it would be late again.
constexpr double kMostOwed = 0.01;

}  // namespace

void CutPace::grant(double way) {
    pace_ = kEager * way / std::clamp(sinceGrant_, kShortest, kLongest);
    sinceGrant_ = 0;
}

void CutPace::owe(double way) { owed_ = std::min(way, kMostOwed); }

Pose CutPace::goal(const Pose& hand, const Pose& bur, const Vec3& handStep, double dt) const {
    // Where the two stood before this tick: a bur that looked to the new place of the hand would be ahead of itself by
    // a tick's way, more at a low rate than at a high one.
    const Vec3 way = hand.position - handStep - bur.position;
    const double left = way.norm();
    if (!(left > 0)) return hand;
    const Vec3 inward = way / left;
    const double catchUp = (left - kUsualLag) / kCatchUp;  // mm/s
    const double step = std::max({pace_ * dt, kLeastPace * dt, catchUp * dt, handStep.norm()}) + owed_;
    if (step >= (hand.position - bur.position).norm()) return hand;
    const Vec3 across = handStep - handStep.dot(inward) * inward;
    return {bur.position + step * inward + across, hand.rotation};
}

}  // namespace tactooth
