// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/force_pipeline.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"

// The bound on the direction of the force: a force whose direction jumps at a sharp edge shakes the hand (J. Hernantes
// et al., "Effective haptic rendering method for complex interactions", 2007). So the force grows more slowly across
// the force of the last tick than along it.
//
// Bad input is handled first, by `stop`. The asserts are in the stages behind it, where the input is valid.

namespace tactooth {
namespace {

constexpr double kTurnSlew = 150;   // N/s across the last force: 1 N turns by a right angle in 10 ms
constexpr double kMaxPause = 0.25;  // s: the reaction time of a hand; after a longer pause the hand may be anywhere
constexpr double kMaxDeflection = 1000;  // mm: no tooth is that deep
constexpr double kMaxStiffness = 1e6;    // N/mm: even steel is softer
constexpr double kMinForce = 0.02;       // N: the hand does not feel the direction of a smaller force

/// False also for NaN.
bool isBetween(double value, double low, double high) { return value >= low && value <= high; }

/// Whether the force and its input are finite, and in the range of a tooth.
bool isValid(const ForceCommand& wanted) {
    return wanted.wrench.force.allFinite() && wanted.wrench.torque.allFinite() && wanted.driveForce.allFinite() &&
           isBetween(wanted.deflection, 0, kMaxDeflection) && isBetween(wanted.stiffness, 0, kMaxStiffness) &&
           std::isfinite(wanted.motorTemperature);
}

}  // namespace

ForceCommand forceCommandFrom(const Tick& tick) {
    TACTOOTH_ASSERT(tick.contact.triangles >= 0);
    TACTOOTH_ASSERT(tick.contact.placed || tick.contact.triangles == 0);
    ForceCommand wanted;
    wanted.wrench = tick.force.wrench;
    wanted.hand = tick.input.device.position;
    wanted.driveForce = tick.force.drive;
    wanted.deflection = tick.force.deflection;
    wanted.stiffness = tick.force.stiffness;
    wanted.touching = tick.contact.triangles > 0;
    wanted.allowed = tick.contact.placed;
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

/// Zero force at once, and zero until the tool has been in free space.
SafeWrench ForcePipeline::stop(const ForceCommand& wanted, double elapsed) {
    ++faults_;
    state_ = ForceState::Fault;
    awaitsFreeSpace_ = true;
    passivity_.reset();
    const double reported = wanted.connected && std::isfinite(wanted.motorTemperature) ? wanted.motorTemperature : 0;
    if (elapsed > 0 && std::isfinite(elapsed)) heat_.add(0, elapsed, reported);
    sent_ = limiter_.limit({}, elapsed, false, 0);
    TACTOOTH_ASSERT(sent_.force().isZero(0) && sent_.torque().isZero(0));
    return sent_;
}

/// Switched off, after the force has faded out.
SafeWrench ForcePipeline::rest(const ForceCommand& wanted, double elapsed) {
    TACTOOTH_ASSERT(!wanted.allowed && wanted.connected);
    TACTOOTH_ASSERT(sent_.force().isZero(0) && sent_.torque().isZero(0));
    state_ = ForceState::Off;
    awaitsFreeSpace_ = true;
    passivity_.reset();
    heat_.add(0, elapsed, wanted.motorTemperature);
    sent_ = limiter_.limit({}, elapsed, false, 0);
    return sent_;
}

Vec3 ForcePipeline::directionLimited(const Vec3& force, double elapsed) const {
    TACTOOTH_ASSERT(force.allFinite());
    TACTOOTH_ASSERT(isBetween(elapsed, 0, kMaxPause));
    const double last = sent_.force().norm();
    if (last < kMinForce) return force;
    const Vec3 along = sent_.force() / last;
    const Vec3 across = force - force.dot(along) * along;
    const double maxAcross = kTurnSlew * elapsed;
    if (across.norm() <= maxAcross) return force;
    const Vec3 limited = force - (1 - maxAcross / across.norm()) * across;
    TACTOOTH_ASSERT(limited.norm() <= force.norm() * (1 + 1e-9));
    return limited;
}

/// The sent force without the pull of the drive, if the limits have reduced both alike. The pull may do work on the
/// hand: a spinning bur does climb and drag. A controller that counted this as a leak of the wall would damp it away.
Vec3 ForcePipeline::wallForceSent(const Vec3& force, const Vec3& driveForce) const {
    const double squared = force.squaredNorm();
    if (!(squared > 0)) return sent_.force();
    TACTOOTH_ASSERT(driveForce.allFinite());
    const double share = std::clamp(sent_.force().dot(force) / squared, 0.0, 1.0);
    return sent_.force() - share * driveForce;
}

/// The force that the passivity controller adds. It takes away no more than the force itself, because a tooth does not
/// pull.
Vec3 ForcePipeline::damping(const Vec3& force, const ForceCommand& wanted, double elapsed) {
    TACTOOTH_ASSERT(wanted.touching && force.allFinite());
    TACTOOTH_ASSERT(wanted.deflection >= 0 && wanted.stiffness >= 0);
    const SpringState spring{wanted.deflection, wanted.stiffness, heat_.bound(), limiter_.strength()};
    const Vec3 added = passivity_.damp(wanted.hand, wallForceSent_, spring, elapsed);
    const double length = force.norm();
    if (!(length > 0)) return Vec3::Zero();
    const double along = added.dot(force) / length;
    const Vec3 bounded = along < -length ? Vec3(added * (length / -along)) : added;
    // False for NaN, which `push` handles: the tooth does not pull.
    TACTOOTH_ASSERT(!((force + bounded).dot(force) < -1e-9 * force.squaredNorm()));
    return bounded;
}

SafeWrench ForcePipeline::send(const Wrench& wrench, const ForceCommand& wanted, double elapsed) {
    TACTOOTH_ASSERT(fault_ == PoseFault::None && state_ != ForceState::Fault);
    TACTOOTH_ASSERT(wrench.force.allFinite() && wrench.torque.allFinite());
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
    TACTOOTH_ASSERT(wanted.allowed && !awaitsFreeSpace_);
    Wrench wrench = wanted.wrench;
    // The length of a vector near the largest double would overflow.
    const double maxComponent = 2 * limiter_.limits().force;
    wrench.force = wrench.force.cwiseMax(-maxComponent).cwiseMin(maxComponent);
    if (wanted.touching) {
        wrench.force += damping(wrench.force, wanted, elapsed);
    } else {
        passivity_.reset();
    }
    if (!wrench.force.allFinite()) {  // the sums of the controller were not finite, and it has started anew
        fault_ = PoseFault::Force;
        return stop(wanted, elapsed);
    }
    const double bound = heat_.bound();
    TACTOOTH_ASSERT(bound >= 0 && bound <= limiter_.limits().force);
    const double length = wrench.force.norm();
    state_ = length > bound && bound < limiter_.limits().force ? ForceState::Warm : ForceState::On;
    if (length > bound) wrench.force *= bound / length;
    TACTOOTH_ASSERT(wrench.force.norm() <= bound * (1 + 1e-9));
    wrench.force = directionLimited(wrench.force, elapsed);
    send(wrench, wanted, elapsed);
    wallForceSent_ = wallForceSent(wrench.force, wanted.driveForce);
    return sent_;
}

}  // namespace tactooth
