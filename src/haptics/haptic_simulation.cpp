// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/haptic_simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// Removal law: dV = k * F_n * v_rim * dt with k of the material (volume per force and rim travel); the tangential force
// that loads the spindle is about half the normal one (measured on glass ceramic: 0.4 to 0.6 between 0.6 and 2.9 N).

namespace tactooth {
namespace {

constexpr double kVelocityCutoff =
    100;  // Hz: above the hand's 10 Hz, below what an encoder step of 55 um makes of 1 kHz
constexpr double kTangentialShare = 0.5;  // of the normal force
constexpr double kCuttingSpeedRpm = 300;  // a bur slower than this rubs and does not cut
constexpr double kFurthest = 1e6;         // mm from the tooth: a hand beyond is a fault of the device
constexpr double kUnitTolerance = 1e-3;   // of a quaternion's squared length

/// False also for everything that is not a number.
bool isSomewhere(const Pose& hand) {
    return hand.position.allFinite() && hand.position.cwiseAbs().maxCoeff() < kFurthest &&
           std::abs(hand.rotation.squaredNorm() - 1) < kUnitTolerance;
}

}  // namespace

HapticSimulation::HapticSimulation(std::shared_ptr<const ToolShape> tool, double burRadius,
                                   std::shared_ptr<const Surface> surface, const HapticSettings& settings)
    : proxy_(std::move(tool), std::move(surface), settings.mode),
      materials_(settings.materials),
      spindle_(settings.spindle),
      burRadius_(burRadius) {
    force_.setOverrides(settings.force);
}

void HapticSimulation::filterVelocity(const Vec3& position, double dt) {
    if (!following_ || dt <= 0) {
        velocity_.setZero();
        lastPosition_ = position;
        following_ = true;
        return;
    }
    const Vec3 raw = (position - lastPosition_) / dt;
    velocity_ += (1 - std::exp(-2 * std::numbers::pi * kVelocityCutoff * dt)) * (raw - velocity_);
    lastPosition_ = position;
}

/// Turns the spindle one step under the load of the cut, and books the work that the cut may spend.
void HapticSimulation::turnBur(const HandInput& input, double dt, Tick& tick) {
    const bool bites = input.cutting && tick.contacts > 0 && bur_.speedRpm > kCuttingSpeedRpm;
    const double tangential = bites ? kTangentialShare * force_.normalForce() : 0;
    tick.load = tangential * burRadius_;
    bur_ = stepSpindle(spindle_, bur_, input.cutting ? tick.pedal : 0, tick.load, dt);
    const double rimSpeed = bur_.speedRpm / 60 * 2 * std::numbers::pi * burRadius_ * 1e-3;  // m/s
    tick.speedRpm = bur_.speedRpm;
    tick.removalWatt = tangential * rimSpeed;
    tick.cutWork = last_.cutWork + (bites ? force_.normalForce() * rimSpeed * dt : 0);
}

/// Follows the hand and makes the force.
void HapticSimulation::touch(const HandInput& input, double dt, Tick& tick) {
    tick.hand = input.handInTooth;
    tick.speed = following_ && dt > 0 ? (input.handInTooth.position - lastPosition_).norm() / dt : 0;
    filterVelocity(input.handInTooth.position, dt);

    const ProxyState state = proxy_.follow(input.handInTooth);
    tick.placed = state.placed;
    tick.proxy = state.placed ? state.proxy : input.handInTooth;
    tick.contacts = state.contacts;
    if (state.contacts > 0 && state.offset.norm() > 0) {
        tick.depth = state.offset.norm();
        tick.normal = state.offset / tick.depth;
        tick.material = std::ranges::max_element(state.heldAt(), {}, &HeldAt::share)->material;
    }
    tick.wrench =
        force_.at({input.handInTooth.position, state.offset, velocity_, state.travel, state.heldAt()}, materials_);
    tick.stiffness = force_.stiffness();
}

Tick HapticSimulation::step(const HandInput& input, double dt) {
    Tick tick;
    tick.time = last_.time + (started_ ? dt : 0);
    started_ = true;
    tick.cutting = input.cutting;
    tick.pedal = std::isfinite(input.pedal) ? std::clamp(input.pedal, 0.0, 1.0) : 0;
    if (isSomewhere(input.handInTooth)) {
        touch(input, dt, tick);
    } else {
        tick.hand = last_.hand;
        tick.proxy = last_.proxy;
        following_ = false;
    }
    turnBur(input, dt, tick);

    const bool touching = tick.contacts > 0;
    tick.landings = last_.landings + (touching && !touching_ ? 1 : 0);
    tick.landingSpeed = touching && !touching_ ? std::max(0.0, -velocity_.dot(tick.normal)) : last_.landingSpeed;
    touching_ = touching;
    last_ = tick;
    return tick;
}

}  // namespace tactooth
