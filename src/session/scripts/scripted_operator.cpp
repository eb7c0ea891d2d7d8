// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/scripted_operator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kYield = 8;      // mm/s for each newton of force error: settles in 0.1 s on enamel
constexpr double kApproach = 4;   // mm/s at most downwards
constexpr double kLift = 8;       // mm/s at most upwards
constexpr double kSideways = 12;  // mm/s at most: a stroke of a trained hand

}  // namespace

ScriptedOperator::ScriptedOperator(const Vec3& start, const Quat& grip, std::vector<OperatorPhase> script)
    : script_(std::move(script)), waitingHeight_(start.z()), tip_(start), grip_(grip) {
    TACTOOTH_ASSERT(!script_.empty());
    info_.name = "scripted operator";
    info_.rendersForce = info_.hasPedal = true;
}

DeviceSample ScriptedOperator::read(double elapsed) {
    time_ += elapsed;
    while (!finished_ && time_ >= script_[phase_].seconds) {
        time_ -= script_[phase_].seconds;
        finished_ = phase_ + 1 == script_.size();
        if (!finished_) ++phase_;
    }
    const OperatorPhase& now = script_[phase_];
    const double progress = finished_ ? now.strokes : now.strokes * time_ / now.seconds;
    const double part = (1 - std::cos(std::numbers::pi * progress)) / 2;  // slow at the turning points, as a wrist is
    Vec3 sideways = now.from + part * (now.to - now.from) - tip_;
    sideways.z() = 0;
    const double longest = kSideways * elapsed;
    if (sideways.norm() > longest) sideways *= longest / sideways.norm();
    sideways += kYield * elapsed * Vec3(force_.x(), force_.y(), 0);  // a wall pushes the hand aside
    const double wanted = now.force > 0 ? -kYield * (now.force - force_.norm()) : kLift;
    tip_ += sideways + Vec3(0, 0, std::clamp(wanted, -kApproach, kLift) * elapsed);
    tip_.z() = std::min(tip_.z(), waitingHeight_);
    return {{tip_, grip_}, now.pedal, 0, true};
}

}  // namespace tactooth
