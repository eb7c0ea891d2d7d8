// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/pose_validator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kMinSpan = 0.9e-3;  // s: over a shorter time, the jitter of a clock gives any speed
constexpr double kMaxGap = 0.003;    // s between two readings: after a longer gap the distance says less than the speed
constexpr double kFaultHold = 0.1;   // s of valid readings until the device counts as valid again
constexpr double kMinAge = -0.001;   // s: a smaller age is that of a wrong clock

/// The time since the last tick, s; 0 if the clock gives nonsense.
double timeOf(double elapsed) { return elapsed > 0 && std::isfinite(elapsed) ? elapsed : 0; }

/// False also for NaN. It needs no square root, because it is called several times in a tick.
bool isShorter(const Vec3& displacement, double length) { return displacement.squaredNorm() < length * length; }

}  // namespace

PoseValidator::PoseValidator(const PoseLimits& limits) : limits_(limits) {
    TACTOOTH_ASSERT(std::isfinite(limits.freeJump) && limits.freeJump >= 0);
    TACTOOTH_ASSERT(std::isfinite(limits.freeSpeed) && limits.freeSpeed > 0);
    TACTOOTH_ASSERT(std::isfinite(limits.jump) && limits.jump > 0);
    TACTOOTH_ASSERT(std::isfinite(limits.speed) && limits.speed > 0);
    TACTOOTH_ASSERT(std::isfinite(limits.maxAngularSpeed) && limits.maxAngularSpeed > 0);
    TACTOOTH_ASSERT(std::isfinite(limits.rotationPeriod) && limits.rotationPeriod >= 0);
    TACTOOTH_ASSERT(std::isfinite(limits.maxAge) && limits.maxAge >= 0);
}

PoseFault PoseValidator::find(const PoseReading& reading, double elapsed, bool touching) const {
    if (!reading.position.allFinite() || !reading.rotation.coeffs().allFinite()) return PoseFault::NotANumber;
    if (reading.position.cwiseAbs().maxCoeff() > kMaxCoordinate) return PoseFault::Jump;
    if (!isUnit(reading.rotation)) return PoseFault::InvalidRotation;
    if (!(reading.age <= limits_.maxAge) || !(reading.age >= kMinAge)) return PoseFault::Stale;
    if (!following_ || !reading.isFresh) return PoseFault::None;
    return findMotion(reading, now_ + elapsed - reading.age, touching || touching_ || faultHold_ > 0);
}

/// `strict`: apply the limits of a tool in contact.
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
    const double maxHalfAngle = 0.5 * limits_.maxAngularSpeed * std::max(kMinSpan, time - rotationTime_);  // rad
    TACTOOTH_ASSERT(maxHalfAngle >= 0);
    if (maxHalfAngle >= std::numbers::pi / 2) return false;
    return (rotation_.conjugate() * rotation).vec().norm() > std::sin(maxHalfAngle);
}

double PoseValidator::faultHoldAfter(double elapsed) const {
    return faultHold_ - std::min(faultHold_, timeOf(elapsed));
}

PoseFault PoseValidator::check(const PoseReading& reading, double elapsed, bool touching) const {
    const PoseFault found = find(reading, elapsed, touching);
    return found == PoseFault::None && faultHoldAfter(elapsed) > 0 ? fault_ : found;
}

PoseFault PoseValidator::take(const PoseReading& reading, double elapsed, bool touching) {
    const PoseFault found = find(reading, elapsed, touching);
    now_ += timeOf(elapsed);
    touching_ = touching;
    if (found == PoseFault::NotANumber || found == PoseFault::InvalidRotation) {
        forget();
    } else if (found != PoseFault::Stale && reading.isFresh && std::isfinite(reading.age) && isUnit(reading.rotation)) {
        follow(reading, now_ - reading.age, found != PoseFault::None || !following_);
    }
    if (found != PoseFault::None) {
        fault_ = found;
        faultHold_ = kFaultHold;
        return found;
    }
    faultHold_ = faultHoldAfter(elapsed);
    TACTOOTH_ASSERT(faultHold_ >= 0 && faultHold_ <= kFaultHold);
    TACTOOTH_ASSERT(faultHold_ == 0 || fault_ != PoseFault::None);
    return faultHold_ > 0 ? fault_ : PoseFault::None;
}

/// `anew`: earlier readings say nothing about this one.
void PoseValidator::follow(const PoseReading& reading, double time, bool anew) {
    TACTOOTH_ASSERT(reading.position.allFinite());
    TACTOOTH_ASSERT(std::isfinite(time));
    following_ = true;
    last_ = reading.position;
    lastTime_ = time;
    const double span = time - anchorTime_;
    if (anew || span >= kMinSpan) {
        speed_ = anew ? 0 : (reading.position - anchor_).norm() / span;
        TACTOOTH_ASSERT(speed_ >= 0);
        anchor_ = reading.position;
        anchorTime_ = time;
    }
    followRotation(reading.rotation, time, anew);
}

/// The device may not have read an unchanged rotation again. So its time advances only after `rotationPeriod`.
void PoseValidator::followRotation(const Quat& rotation, double time, bool anew) {
    TACTOOTH_ASSERT(isUnit(rotation));
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
