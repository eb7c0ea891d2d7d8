// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/feed_rate_limiter.h"

#include <algorithm>

namespace tactooth {
namespace {

constexpr double kShortest = 0.001;   // s between two surfaces: a tick
constexpr double kLongest = 0.03;     // s: after a longer pause the cut begins anew
constexpr double kFeedMargin = 1.1;   // of the pace of the cut: rather there a little early than left behind
constexpr double kMinFeedRate = 2.0;  // mm/s: what no cut holds any more gives way all the same

// A bur that hangs back farther than a hand presses catches up as far as the cut has made room ...
constexpr double kTypicalLag = 0.5;  // mm: 1 N on 2 N/mm, as soft as a tooth is made to feel
// ... by what is beyond that within so many seconds: a person sees no such lag, and no tick makes a leap of it.
constexpr double kCatchUp = 0.05;

// What late ticks have left is made up for at once up to this, mm. Of a longer way more is in doubt than a tick has
// time to look at, and it would be late again.
constexpr double kMaxCarryOver = 0.01;

}  // namespace

void FeedRateLimiter::allow(double way) {
    feedRate_ = kFeedMargin * way / std::clamp(sinceGrant_, kShortest, kLongest);
    sinceGrant_ = 0;
}

void FeedRateLimiter::carryOver(double way) { carriedOver_ = std::min(way, kMaxCarryOver); }

Pose FeedRateLimiter::goal(const Pose& hand, const Pose& bur, const Vec3& deviceStep, double dt) const {
    // Where the two stood before this tick: a bur that looked to the new place of the hand would be ahead of itself by
    // a tick's way, more at a low rate than at a high one.
    const Vec3 way = hand.position - deviceStep - bur.position;
    const double left = way.norm();
    if (!(left > 0)) return hand;
    const Vec3 inward = way / left;
    const double catchUp = (left - kTypicalLag) / kCatchUp;  // mm/s
    const double step = std::max({feedRate_ * dt, kMinFeedRate * dt, catchUp * dt, deviceStep.norm()}) + carriedOver_;
    if (step >= (hand.position - bur.position).norm()) return hand;
    const Vec3 across = deviceStep - deviceStep.dot(inward) * inward;
    return {bur.position + step * inward + across, hand.rotation};
}

}  // namespace tactooth
