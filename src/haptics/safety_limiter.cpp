// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/safety_limiter.h"

#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

Vec3 shortened(const Vec3& vector, double longest) {
    const double length = vector.norm();
    return length > longest ? Vec3(vector * (longest / length)) : vector;
}

}  // namespace

bool SafetyLimiter::isValid(const Wrench& wanted, double elapsed, double speed) const {
    const bool finite = wanted.force.allFinite() && wanted.torque.allFinite() && std::isfinite(speed) && speed >= 0;
    return finite && elapsed >= 0 && elapsed <= limits_.tickTimeout;
}

SafeWrench SafetyLimiter::limit(const Wrench& wanted, double elapsed, bool enabled, double speed) {
    const bool sound = isValid(wanted, elapsed, speed);
    if (!sound) ++faults_;
    if (!sound || !enabled) {
        strength_ = 0;
        last_ = {};
        return {};
    }
    strength_ = limits_.rampTime > 0 ? std::min(1.0, strength_ + elapsed / limits_.rampTime) : 1.0;
    // A number near the largest double would overflow when its length is taken: cut the components first.
    const auto bounded = [](const Vec3& v, double limit) {
        return shortened(v.cwiseMax(-2 * limit).cwiseMin(2 * limit), limit);
    };
    const Vec3 force = strength_ * bounded(wanted.force, limits_.force);
    const Vec3 torque = strength_ * bounded(wanted.torque, limits_.torque);
    last_.force += shortened(force - last_.force, limits_.slew * elapsed);
    last_.torque += shortened(torque - last_.torque, limits_.torqueSlew * elapsed);
    if (speed > 0) last_.force = shortened(last_.force, limits_.power / speed);
    return SafeWrench(last_);
}

}  // namespace tactooth
