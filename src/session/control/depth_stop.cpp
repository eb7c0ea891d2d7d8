// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/depth_stop.h"

#include <algorithm>
#include <cmath>

namespace tactooth {
namespace {

// A step in the floor, as at the edge of the tooth or when the stop is switched on in a cavity, must not throw the
// tool: beyond the motion of the hand it moves at this speed.
constexpr double kDrift = 15;  // mm/s
// How steep a floor may be, so that a tool that slides up on it is held exactly: 72 degrees.
constexpr double kSteepest = 3;
constexpr double kFinish = 0.08;    // mm beyond the floor until the proxy is there: no more can be cut too deep
constexpr double kAtFloor = 0.015;  // mm: there

}  // namespace

/// How far the device is beyond the floor, as far as the tool can follow in this tick.
double DepthStop::next(const Pose& wanted, const DepthControl* control, double elapsed, const Vec3* proxy) const {
    const Vec3 inward = wanted.rotation * -Vec3::UnitZ();
    double target = 0;
    if (control != nullptr) {
        const auto toGo = proxy != nullptr ? control->toFloor(*proxy, inward) : std::nullopt;
        const double finish = toGo && *toGo > kAtFloor ? kFinish : 0;
        if (const auto left = control->toFloor(wanted.position, inward)) target = std::max(0.0, -*left - finish);
    }
    const double motion = hasLast_ ? (wanted.position - last_).norm() : 0;
    const double reach = kSteepest * motion + kDrift * elapsed;
    return std::clamp(target, std::max(0.0, beyond_ - reach), beyond_ + reach);
}

Pose DepthStop::hold(const Pose& wanted, const DepthControl* control, double elapsed, const Vec3* proxy) {
    const bool isValid = wanted.position.allFinite() && isUnit(wanted.rotation * Vec3::UnitZ());
    if (!isValid || !(elapsed >= 0) || (control == nullptr && beyond_ == 0)) {
        beyond_ = 0;
        force_ = Vec3::Zero();
        hasLast_ = false;
        return wanted;
    }
    const double beyond = next(wanted, control, elapsed, proxy);
    const double deeper = elapsed > 0 ? (beyond - beyond_) / elapsed : 0;  // mm/s
    const Vec3 outward = wanted.rotation * Vec3::UnitZ();
    force_ = beyond > 0 ? Vec3(std::max(0.0, kStiffness * beyond + kDamping * deeper) * outward) : Vec3(Vec3::Zero());
    beyond_ = beyond;
    last_ = wanted.position;
    hasLast_ = true;
    return {wanted.position + beyond * outward, wanted.rotation};
}

}  // namespace tactooth
