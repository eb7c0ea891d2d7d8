// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/pose_guard.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactooth {
namespace {

constexpr double kFurthest = 1e6;         // mm
constexpr double kUnitTolerance = 1e-3;   // of a quaternion's squared length
constexpr double kShortestSpan = 0.9e-3;  // s: over less, a clock's jitter makes any speed
constexpr double kLongestGap = 0.003;     // s between two readings: after more of them the way says less than the speed
constexpr double kDoubt = 0.1;            // s of sound readings until a device is believed again
constexpr double kEarlyClock = -0.001;    // s: an age below is that of a clock that runs wrong

/// What a clock tells of the time since the last tick, s; nothing where it tells nonsense.
double timeOf(double elapsed) { return elapsed > 0 && std::isfinite(elapsed) ? elapsed : 0; }

/// False also for what is no number. Without a root: this is asked several times a tick.
bool isShorter(const Vec3& way, double length) { return way.squaredNorm() < length * length; }

}  // namespace

HandFault PoseGuard::find(const PoseReading& reading, double elapsed, bool touching) const {
    if (!reading.position.allFinite() || !reading.rotation.coeffs().allFinite()) return HandFault::NoNumber;
    if (reading.position.cwiseAbs().maxCoeff() > kFurthest) return HandFault::Jump;
    if (!(std::abs(reading.rotation.squaredNorm() - 1) < kUnitTolerance)) return HandFault::BrokenTurn;
    if (!(reading.age <= limits_.oldest) || !(reading.age >= kEarlyClock)) return HandFault::Stale;
    if (!following_ || !reading.isFresh) return HandFault::None;
    return findMotion(reading, now_ + elapsed - reading.age, touching || touching_ || doubt_ > 0);
}

/// `strict`: with the limits of a tool that touches.
HandFault PoseGuard::findMotion(const PoseReading& reading, double time, bool strict) const {
    const double gap = std::max(0.0, time - lastTime_);
    const Vec3 way = reading.position - last_;
    if (!isShorter(way, limits_.airJump + limits_.airSpeed * gap)) return HandFault::Jump;
    if (strict && gap <= kLongestGap && !isShorter(way, limits_.jump)) return HandFault::Jump;
    const double span = std::max(kShortestSpan, time - anchorTime_);
    if (strict && !isShorter(reading.position - anchor_, limits_.speed * span)) return HandFault::TooFast;
    return turnsTooFast(reading.rotation, time) ? HandFault::TurnsTooFast : HandFault::None;
}

bool PoseGuard::turnsTooFast(const Quat& rotation, double time) const {
    if (rotation.coeffs() == turn_.coeffs()) return false;
    const double most = 0.5 * limits_.turnSpeed * std::max(kShortestSpan, time - turnTime_);  // rad, half of the angle
    if (most >= std::numbers::pi / 2) return false;
    return (turn_.conjugate() * rotation).vec().norm() > std::sin(most);
}

double PoseGuard::doubtAfter(double elapsed) const { return doubt_ - std::min(doubt_, timeOf(elapsed)); }

HandFault PoseGuard::judge(const PoseReading& reading, double elapsed, bool touching) const {
    const HandFault found = find(reading, elapsed, touching);
    return found == HandFault::None && doubtAfter(elapsed) > 0 ? fault_ : found;
}

HandFault PoseGuard::take(const PoseReading& reading, double elapsed, bool touching) {
    const HandFault found = find(reading, elapsed, touching);
    now_ += timeOf(elapsed);
    touching_ = touching;
    if (found == HandFault::NoNumber || found == HandFault::BrokenTurn) {
        forget();
    } else if (found != HandFault::Stale && reading.isFresh) {
        follow(reading, now_ - reading.age, found != HandFault::None || !following_);
    }
    if (found != HandFault::None) {
        fault_ = found;
        doubt_ = kDoubt;
        return found;
    }
    doubt_ = doubtAfter(elapsed);
    return doubt_ > 0 ? fault_ : HandFault::None;
}

/// `anew`: whatever was before says nothing about how this reading came about.
void PoseGuard::follow(const PoseReading& reading, double time, bool anew) {
    following_ = true;
    last_ = reading.position;
    lastTime_ = time;
    const double span = time - anchorTime_;
    if (anew || span >= kShortestSpan) {
        speed_ = anew ? 0 : (reading.position - anchor_).norm() / span;
        anchor_ = reading.position;
        anchorTime_ = time;
    }
    followTurn(reading.rotation, time, anew);
}

/// A turn that did not change may just not have been read again: its time goes on only after `turnPeriod`.
void PoseGuard::followTurn(const Quat& rotation, double time, bool anew) {
    if (anew) {
        turn_ = rotation;
        turnTime_ = time;
    } else if (rotation.coeffs() == turn_.coeffs()) {
        turnTime_ = std::max(turnTime_, time - limits_.turnPeriod);
    } else if (time - turnTime_ >= kShortestSpan) {
        turn_ = rotation;
        turnTime_ = time;
    }
}

}  // namespace tactooth
