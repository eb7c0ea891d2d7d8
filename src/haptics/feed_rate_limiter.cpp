// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/feed_rate_limiter.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kShortest = 0.001;  // s between two surfaces: one tick
constexpr double kLongest = 0.03;    // s: after a longer pause the cut starts anew
constexpr double kFeedMargin =
    1.1;  // share of the rate of the cut: the bur had better arrive a little early than lag behind
constexpr double kMinFeedRate = 2.0;  // mm/s: the bur also moves where nothing is cut

// A bur that lags behind farther than the pressure of a device explains catches up, as far as the cut has made room ...
constexpr double kTypicalLag = 0.5;  // mm: 1 N on 2 N/mm, the softest tooth
// ... by the excess within so many seconds: no user sees this lag, and no tick makes a jump of it.
constexpr double kCatchUp = 0.05;

// The distance that late ticks have left is added at once up to this, mm. A longer step has more uncertain pairs than a
// tick has time for, and would be late again.
constexpr double kMaxCarryOver = 0.01;

}  // namespace

void FeedRateLimiter::allow(double distance) {
    TACTOOTH_ASSERT(std::isfinite(distance) && distance >= 0);
    feedRate_ = kFeedMargin * distance / std::clamp(sinceGrant_, kShortest, kLongest);
    sinceGrant_ = 0;
}

void FeedRateLimiter::pass(double dt) {
    TACTOOTH_ASSERT(dt >= 0);
    sinceGrant_ += dt;
}

void FeedRateLimiter::carryOver(double distance) {
    TACTOOTH_ASSERT(distance >= 0);
    carriedOver_ = std::min(distance, kMaxCarryOver);
}

Pose FeedRateLimiter::goal(const Pose& device, const Pose& bur, const Vec3& deviceStep, double dt) const {
    TACTOOTH_ASSERT(dt >= 0);
    TACTOOTH_ASSERT(device.position.allFinite());
    TACTOOTH_ASSERT(bur.position.allFinite());
    TACTOOTH_ASSERT(deviceStep.allFinite());
    // Compare both as they were before this tick: from the new position of the device, the bur would be ahead by the
    // step of a tick, which is longer at a low rate than at a high one.
    const Vec3 displacement = device.position - deviceStep - bur.position;
    const double distance = displacement.norm();
    if (!(distance > 0)) return device;
    const Vec3 inward = displacement / distance;
    const double catchUp = (distance - kTypicalLag) / kCatchUp;  // mm/s
    const double step = std::max({feedRate_ * dt, kMinFeedRate * dt, catchUp * dt, deviceStep.norm()}) + carriedOver_;
    TACTOOTH_ASSERT(std::isfinite(step) && step >= 0);
    if (step >= (device.position - bur.position).norm()) return device;
    const Vec3 across = deviceStep - deviceStep.dot(inward) * inward;
    return {bur.position + step * inward + across, device.rotation};
}

}  // namespace tactooth
