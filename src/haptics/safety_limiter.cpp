// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/safety_limiter.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"

// Saturation of magnitude, slew rate and power. Bad input gives zero force and is counted; it is never asserted. The
// asserts check the limits at the construction, and what leaves the limiter.

namespace tactooth {
namespace {

constexpr double kRounding = 1 + 1e-9;

bool isFiniteAndNotNegative(double value) { return std::isfinite(value) && value >= 0; }

Vec3 shortened(const Vec3& vector, double maxLength) {
    TACTOOTH_ASSERT(maxLength >= 0);
    const double length = vector.norm();
    return length > maxLength ? Vec3(vector * (maxLength / length)) : vector;
}

}  // namespace

SafetyLimiter::SafetyLimiter(const ForceLimits& limits) : limits_(limits) {
    TACTOOTH_ASSERT(isFiniteAndNotNegative(limits.force));
    TACTOOTH_ASSERT(isFiniteAndNotNegative(limits.torque));
    TACTOOTH_ASSERT(std::isfinite(limits.slew) && limits.slew > 0);
    TACTOOTH_ASSERT(std::isfinite(limits.torqueSlew) && limits.torqueSlew > 0);
    TACTOOTH_ASSERT(isFiniteAndNotNegative(limits.rampTime));
    TACTOOTH_ASSERT(std::isfinite(limits.tickTimeout) && limits.tickTimeout > 0);
    TACTOOTH_ASSERT(limits.continuousForce > 0);
    TACTOOTH_ASSERT(isFiniteAndNotNegative(limits.friction));
    TACTOOTH_ASSERT(limits.power >= 0);
}

/// The postcondition of `limit`.
void SafetyLimiter::checkResult([[maybe_unused]] const Wrench& before, [[maybe_unused]] double elapsed,
                                [[maybe_unused]] double speed) const {
    TACTOOTH_ASSERT(strength_ >= 0 && strength_ <= 1);
    TACTOOTH_ASSERT(last_.force.allFinite());
    TACTOOTH_ASSERT(last_.torque.allFinite());
    TACTOOTH_ASSERT(last_.force.norm() <= limits_.force * kRounding);
    TACTOOTH_ASSERT(last_.torque.norm() <= limits_.torque * kRounding);
    TACTOOTH_ASSERT(last_.force.norm() * speed <= limits_.power * kRounding);
    // The bound on power may reduce the force faster than the slew rate, but never raise it faster.
    TACTOOTH_ASSERT(last_.force.norm() <= before.force.norm() + limits_.slew * elapsed * kRounding + 1e-12);
    TACTOOTH_ASSERT((last_.torque - before.torque).norm() <= limits_.torqueSlew * elapsed * kRounding + 1e-9);
}

bool SafetyLimiter::isValid(const Wrench& wanted, double elapsed, double speed) const {
    const bool finite = wanted.force.allFinite() && wanted.torque.allFinite() && std::isfinite(speed) && speed >= 0;
    return finite && elapsed >= 0 && elapsed <= limits_.tickTimeout;
}

SafeWrench SafetyLimiter::limit(const Wrench& wanted, double elapsed, bool enabled, double speed) {
    const bool valid = isValid(wanted, elapsed, speed);
    if (!valid) ++faults_;
    if (!valid || !enabled) {
        strength_ = 0;
        last_ = {};
        return {};
    }
    strength_ = limits_.rampTime > 0 ? std::min(1.0, strength_ + elapsed / limits_.rampTime) : 1.0;
    // The length of a vector near the largest double would overflow: clamp the components first.
    const auto bounded = [](const Vec3& v, double limit) {
        return shortened(v.cwiseMax(-2 * limit).cwiseMin(2 * limit), limit);
    };
    const Vec3 force = strength_ * bounded(wanted.force, limits_.force);
    const Vec3 torque = strength_ * bounded(wanted.torque, limits_.torque);
    const Wrench before = last_;
    last_.force += shortened(force - last_.force, limits_.slew * elapsed);
    last_.torque += shortened(torque - last_.torque, limits_.torqueSlew * elapsed);
    if (speed > 0) last_.force = shortened(last_.force, limits_.power / speed);
    checkResult(before, elapsed, speed);
    return SafeWrench(last_);
}

SafeWrench SafetyLimiter::fade(const SafeWrench& earlier, double left) {
    TACTOOTH_ASSERT(earlier.force().norm() <= limits_.force * kRounding);
    TACTOOTH_ASSERT(earlier.torque().norm() <= limits_.torque * kRounding);
    const double share = left > 0 ? std::min(left, 1.0) : 0;  // false for NaN
    strength_ = 0;
    last_ = {shortened(share * earlier.force(), limits_.force), shortened(share * earlier.torque(), limits_.torque)};
    return SafeWrench(last_);
}

}  // namespace tactooth
