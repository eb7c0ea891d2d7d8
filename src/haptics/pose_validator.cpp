// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/pose_validator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactooth {
namespace {

constexpr double kMaxDistance = 1e6;     // mm
constexpr double kUnitTolerance = 1e-3;  // of a quaternion's squared length
constexpr double kMinSpan = 0.9e-3;      // s: over less, a clock's jitter makes any speed
constexpr double kMaxGap = 0.003;        // s between two readings: after more of them the way says less than the speed
constexpr double kFaultHold = 0.1;       // s of sound readings until a device is believed again
constexpr double kMinAge = -0.001;       // s: an age below is that of a clock that runs wrong

/// What a clock tells of the time since the last tick, s; nothing where it tells nonsense.
double timeOf(double elapsed) { return elapsed > 0 && std::isfinite(elapsed) ? elapsed : 0; }

/// False also for what is no number. Without a root: this is asked several times a tick.
bool isShorter(const Vec3& displacement, double length) { return displacement.squaredNorm() < length * length; }

}  // namespace

PoseFault PoseValidator::find(const PoseReading& reading, double elapsed, bool touching) const {
    if (!reading.position.allFinite() || !reading.rotation.coeffs().allFinite()) return PoseFault::NotANumber;
    if (reading.position.cwiseAbs().maxCoeff() > kMaxDistance) return PoseFault::Jump;
    if (!(std::abs(reading.rotation.squaredNorm() - 1) < kUnitTolerance)) return PoseFault::InvalidRotation;
    if (!(reading.age <= limits_.maxAge) || !(reading.age >= kMinAge)) return PoseFault::Stale;
    if (!following_ || !reading.isFresh) return PoseFault::None;
    return findMotion(reading, now_ + elapsed - reading.age, touching || touching_ || faultHold_ > 0);
}

/// `strict`: with the limits of a tool that touches.
PoseFault PoseValidator::findMotion(const PoseReading& reading, double time, bool strict) const {
    const double gap = std::max(0.0, time - lastTime_);
    const Vec3 displacement = reading.position - last_;
    if (!isShorter(displacement, limits_.freeJump + limits_.freeSpeed * gap)) return PoseFault::Jump;
    if (strict && gap <= kMaxGap && !isShorter(displacement, limits_.jump)) return PoseFault::Jump;
    const double span = std::max(kMinSpan, time - anchorTime_);
    if (strict && !isShorter(reading.position - anchor_, limits_.speed * span)) return PoseFault::TooFast;
    return rotatesTooFast(reading.rotation, time) ? PoseFault::RotatesTooFast : PoseFault::None;
}

bool PoseValidator::rotatesTooFast(const Quat& rotation, double time) const {
    if (rotation.coeffs() == rotation_.coeffs()) return false;
    const double most =
        0.5 * limits_.maxAngularSpeed * std::max(kMinSpan, time - rotationTime_);  // rad, half of the angle
    if (most >= std::numbers::pi / 2) return false;
    return (rotation_.conjugate() * rotation).vec().norm() > std::sin(most);
}

double PoseValidator::faultHoldAfter(double elapsed) const {
    return faultHold_ - std::min(faultHold_, timeOf(elapsed));
}

PoseFault PoseValidator::judge(const PoseReading& reading, double elapsed, bool touching) const {
    const PoseFault found = find(reading, elapsed, touching);
    return found == PoseFault::None && faultHoldAfter(elapsed) > 0 ? fault_ : found;
}

PoseFault PoseValidator::take(const PoseReading& reading, double elapsed, bool touching) {
    const PoseFault found = find(reading, elapsed, touching);
    now_ += timeOf(elapsed);
    touching_ = touching;
    if (found == PoseFault::NotANumber || found == PoseFault::InvalidRotation) {
        forget();
    } else if (found != PoseFault::Stale && reading.isFresh) {
        follow(reading, now_ - reading.age, found != PoseFault::None || !following_);
    }
    if (found != PoseFault::None) {
        fault_ = found;
        faultHold_ = kFaultHold;
        return found;
    }
    faultHold_ = faultHoldAfter(elapsed);
    return faultHold_ > 0 ? fault_ : PoseFault::None;
}

/// `anew`: whatever was before says nothing about how this reading came about.
void PoseValidator::follow(const PoseReading& reading, double time, bool anew) {
    following_ = true;
    last_ = reading.position;
    lastTime_ = time;
    const double span = time - anchorTime_;
    if (anew || span >= kMinSpan) {
        speed_ = anew ? 0 : (reading.position - anchor_).norm() / span;
        anchor_ = reading.position;
        anchorTime_ = time;
    }
    followRotation(reading.rotation, time, anew);
}

/// A turn that did not change may just not have been read again: its time goes on only after `rotationPeriod`.
void PoseValidator::followRotation(const Quat& rotation, double time, bool anew) {
    if (anew) {
        rotation_ = rotation;
        rotationTime_ = time;
    } else if (rotation.coeffs() == rotation_.coeffs()) {
        rotationTime_ = std::max(rotationTime_, time - limits_.rotationPeriod);
    } else if (time - rotationTime_ >= kMinSpan) {
        rotation_ = rotation;
        rotationTime_ = time;
    }
}

}  // namespace tactooth
