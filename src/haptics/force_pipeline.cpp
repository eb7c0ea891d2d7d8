// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/force_pipeline.h"

#include <algorithm>
#include <cmath>

// The bound on turning: a force whose direction jumps at a sharp edge shakes the hand (J. Hernantes et al., "Effective
// haptic rendering method for complex interactions", 2007): across the force of the last tick, it grows slower than
// along it.

namespace tactooth {
namespace {

constexpr double kTurnSlew = 150;        // N/s across the last force: 1 N turns by a right angle in 10 ms
constexpr double kMaxPause = 0.25;       // s: as quick as a hand reacts; after a longer one it may be anywhere
constexpr double kMaxDeflection = 1000;  // mm: no tooth is as deep
constexpr double kMaxStiffness = 1e6;    // N/mm: steel is not
constexpr double kMinForce = 0.02;       // N: below, a force has no direction that the hand could feel

/// False also for what is no number.
bool isBetween(double value, double least, double most) { return value >= least && value <= most; }

/// Whether the force and what it was computed from are numbers that a tooth can give.
bool isValid(const ForceCommand& wanted) {
    return wanted.wrench.force.allFinite() && wanted.wrench.torque.allFinite() && wanted.driveForce.allFinite() &&
           isBetween(wanted.deflection, 0, kMaxDeflection) && isBetween(wanted.stiffness, 0, kMaxStiffness) &&
           std::isfinite(wanted.motorTemperature);
}

}  // namespace

ForceCommand forceCommandFrom(const Tick& tick) {
    ForceCommand wanted;
    wanted.wrench = tick.wrench;
    wanted.hand = tick.hand.position;
    wanted.driveForce = tick.driveForce;
    wanted.deflection = tick.deflection;
    wanted.stiffness = tick.stiffness;
    wanted.touching = tick.contacts > 0;
    wanted.allowed = tick.placed;
    return wanted;
}

ForcePipeline::ForcePipeline(const ForceLimits& limits, const PoseLimits& poseLimits)
    : validator_(poseLimits),
      limiter_(limits),
      heat_(limits.force, limits.continuousForce),
      passivity_(limits.friction) {}

bool ForcePipeline::isFault(const ForceCommand& wanted, double elapsed) {
    fault_ = PoseFault::None;
    if (!wanted.connected || !isBetween(elapsed, 0, kMaxPause)) {
        validator_.forget();
        return true;
    }
    fault_ = validator_.take({wanted.hand, wanted.turn, wanted.age, wanted.isFresh}, elapsed, wanted.touching);
    if (fault_ == PoseFault::None && !isValid(wanted)) fault_ = PoseFault::Force;
    return fault_ != PoseFault::None;
}

/// Nothing, at once; and nothing later until the tool has been free.
SafeWrench ForcePipeline::stop(const ForceCommand& wanted, double elapsed) {
    ++faults_;
    state_ = ForceState::Fault;
    awaitsFreeSpace_ = true;
    passivity_.reset();
    const double reported = wanted.connected && std::isfinite(wanted.motorTemperature) ? wanted.motorTemperature : 0;
    if (elapsed > 0 && std::isfinite(elapsed)) heat_.add(0, elapsed, reported);
    sent_ = limiter_.limit({}, elapsed, false, 0);
    return sent_;
}

/// Switched off, after the force has faded out.
SafeWrench ForcePipeline::rest(const ForceCommand& wanted, double elapsed) {
    state_ = ForceState::Off;
    awaitsFreeSpace_ = true;
    passivity_.reset();
    heat_.add(0, elapsed, wanted.motorTemperature);
    sent_ = limiter_.limit({}, elapsed, false, 0);
    return sent_;
}

Vec3 ForcePipeline::directionLimited(const Vec3& force, double elapsed) const {
    const double last = sent_.force().norm();
    if (last < kMinForce) return force;
    const Vec3 along = sent_.force() / last;
    const Vec3 across = force - force.dot(along) * along;
    const double most = kTurnSlew * elapsed;
    return across.norm() > most ? Vec3(force - (1 - most / across.norm()) * across) : force;
}

/// What of the force sent is not the drive's pull, if the limits have cut both alike. The pull may do work on the hand:
/// a spinning bur does climb and drag, and a controller that took this for a leak of the wall would damp it away.
Vec3 ForcePipeline::wallForceSent(const Vec3& force, const Vec3& driveForce) const {
    const double squared = force.squaredNorm();
    if (!(squared > 0)) return sent_.force();
    const double share = std::clamp(sent_.force().dot(force) / squared, 0.0, 1.0);
    return sent_.force() - share * driveForce;
}

/// What the passivity controller adds to a force; it takes no more from it than there is, because a tooth does not
/// pull.
Vec3 ForcePipeline::damping(const Vec3& force, const ForceCommand& wanted, double elapsed) {
    const SpringState spring{wanted.deflection, wanted.stiffness, heat_.bound(), limiter_.strength()};
    const Vec3 added = passivity_.damp(wanted.hand, wallForceSent_, spring, elapsed);
    const double length = force.norm();
    if (!(length > 0)) return Vec3::Zero();
    const double along = added.dot(force) / length;
    return along < -length ? Vec3(added * (length / -along)) : added;
}

SafeWrench ForcePipeline::send(const Wrench& wrench, const ForceCommand& wanted, double elapsed) {
    sent_ = limiter_.limit(wrench, elapsed, true, validator_.speed());
    wallForceSent_ = sent_.force();
    heat_.add(sent_.force().norm(), elapsed, wanted.motorTemperature);
    return sent_;
}

SafeWrench ForcePipeline::pass(const ForceCommand& wanted, double elapsed) {
    if (isFault(wanted, elapsed)) return stop(wanted, elapsed);
    if (!wanted.allowed && sent_.force().isZero(0) && sent_.torque().isZero(0)) return rest(wanted, elapsed);
    if (wanted.allowed && !wanted.touching) awaitsFreeSpace_ = false;
    if (!wanted.allowed || awaitsFreeSpace_) {
        state_ = wanted.allowed ? ForceState::AwaitsFreeSpace : ForceState::Off;
        passivity_.reset();
        return send({}, wanted, elapsed);
    }
    return push(wanted, elapsed);
}

SafeWrench ForcePipeline::push(const ForceCommand& wanted, double elapsed) {
    Wrench wrench = wanted.wrench;
    // A number near the largest double would overflow when its length is taken.
    const double most = 2 * limiter_.limits().force;
    wrench.force = wrench.force.cwiseMax(-most).cwiseMin(most);
    if (wanted.touching) {
        wrench.force += damping(wrench.force, wanted, elapsed);
    } else {
        passivity_.reset();
    }
    if (!wrench.force.allFinite()) {  // the controller's sums were no numbers, and begin anew
        fault_ = PoseFault::Force;
        return stop(wanted, elapsed);
    }
    const double bound = heat_.bound();
    const double length = wrench.force.norm();
    state_ = length > bound && bound < limiter_.limits().force ? ForceState::Warm : ForceState::On;
    if (length > bound) wrench.force *= bound / length;
    wrench.force = directionLimited(wrench.force, elapsed);
    send(wrench, wanted, elapsed);
    wallForceSent_ = wallForceSent(wrench.force, wanted.driveForce);
    return sent_;
}

}  // namespace tactooth
