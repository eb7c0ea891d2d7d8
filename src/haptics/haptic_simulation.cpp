// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/haptic_simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// Removal law: dV = k * F_n * v_rim * dt with k of the material (volume per force and rim travel); the tangential force
// that loads the spindle is about half the normal one (see cutting_force.h).

namespace tactooth {
namespace {

constexpr double kVelocityCutoff =
    100;                           // Hz: above the hand's 10 Hz, below what an encoder step of 55 um makes of 1 kHz
constexpr double kFurthest = 1e6;  // mm from the tooth: a hand beyond is a fault of the device
constexpr double kUnitTolerance = 1e-3;  // of a quaternion's squared length

/// False also for everything that is not a number.
bool isSomewhere(const Pose& hand) {
    return hand.position.allFinite() && hand.position.cwiseAbs().maxCoeff() < kFurthest &&
           std::abs(hand.rotation.squaredNorm() - 1) < kUnitTolerance;
}

}  // namespace

HapticSimulation::HapticSimulation(std::shared_ptr<const ToolShape> tool, double burRadius,
                                   std::shared_ptr<const Surface> surface, const HapticSettings& settings)
    : proxy_(std::move(tool), std::move(surface), settings.mode, settings.freedom),
      materials_(settings.materials),
      spindle_(settings.spindle),
      burRadius_(burRadius),
      freedom_(settings.freedom),
      tickWork_(settings.tickWork) {
    force_.setOverrides(settings.force);
}

void HapticSimulation::setSurface(FeltSurface& felt) {
    const Vec3 reach = felt.reach;
    if (proxy_.setSurface(felt)) pace_.grant((reach - proxy_.pose().position).norm());
}

/// A bur that cuts goes on at the pace of its cut, so a tick that leaves some of its way to the next one is late by
/// micrometres. A tool that touches is exact at every tick.
Pose HapticSimulation::goalOf(const HandInput& input, double dt) {
    pace_.pass(dt);
    const bool cuts = input.cutting && last_.contacts > 0 && last_.speedRpm > kRubsRpm && following_;
    const Pose& hand = input.handInTooth;
    proxy_.setBudget(cuts ? tickWork_ : kUnlimitedWork);
    return cuts ? pace_.goal(hand, proxy_.pose(), hand.position - lastHand_.position, dt) : hand;
}

void HapticSimulation::filterVelocity(const Pose& hand, double dt) {
    if (!following_ || dt <= 0) {
        velocity_.setZero();
        spin_.setZero();
        lastHand_ = hand;
        following_ = true;
        return;
    }
    const double newShare = 1 - std::exp(-2 * std::numbers::pi * kVelocityCutoff * dt);
    velocity_ += newShare * ((hand.position - lastHand_.position) / dt - velocity_);
    if (freedom_ == Freedom::ShiftAndTurn) {
        const Quat turn = hand.rotation * lastHand_.rotation.conjugate();
        spin_ += newShare * ((turn.w() < 0 ? -2 : 2) / dt * turn.vec() - spin_);  // for small angles
    }
    lastHand_ = hand;
}

/// mm/s
double HapticSimulation::rimSpeed() const { return bur_.speedRpm / 60 * 2 * std::numbers::pi * burRadius_; }

/// Turns the spindle one step under the load of the cut, and books the work that the cut may spend.
void HapticSimulation::turnBur(const HandInput& input, double dt, Tick& tick) {
    const bool bites = input.cutting && tick.contacts > 0 && bur_.speedRpm > kRubsRpm;
    const double tangential = bites ? kTangentialShare * force_.normalForce() : 0;
    tick.load = tangential * burRadius_;
    bur_ = stepSpindle(spindle_, bur_, input.cutting ? tick.pedal : 0, tick.load, dt);
    const double rimMeters = 1e-3 * rimSpeed();  // a second
    tick.speedRpm = bur_.speedRpm;
    tick.removalWatt = tangential * rimMeters;
    const Vec3 axis = tick.proxy.rotation * Vec3::UnitZ();
    const double force = bites ? force_.normalForce() : 0;
    const Vec3 pull = cuttingForce_.at({tick.normal, axis, force, bur_.speedRpm, spindle_.freeSpeedRpm}, dt);
    tick.drivePull = pull;
    tick.wrench.force += pull;
    tick.wrench.torque += lever_.cross(pull);
    // The mean of both ends of the tick: the same for a force that grows whatever the rate.
    const double power = force * rimMeters;  // N*m a second
    tick.cutWork = last_.cutWork + (bites ? (power_ + power) / 2 * dt : 0);
    power_ = power;
}

/// Follows the hand and makes the force.
void HapticSimulation::touch(const HandInput& input, double dt, Tick& tick) {
    tick.hand = input.handInTooth;
    tick.speed = following_ && dt > 0 ? (input.handInTooth.position - lastHand_.position).norm() / dt : 0;
    const Pose goal = goalOf(input, dt);
    filterVelocity(input.handInTooth, dt);

    const ProxyState state = proxy_.follow(input.handInTooth, goal, dt);
    pace_.owe(state.late);
    tick.placed = state.placed;
    tick.ownLists = proxy_.ownLists();
    tick.proxy = state.placed ? state.proxy : input.handInTooth;
    tick.contacts = state.contacts;
    if (state.contacts > 0 && state.offset.norm() > 0) {
        tick.depth = state.offset.norm();
        tick.normal = state.offset / tick.depth;
        tick.material = std::ranges::max_element(state.heldAt(), {}, &HeldAt::share)->material;
    }
    for (const HeldAt& held : state.heldAt()) {
        if (held.isAround) tick.around = held.material;
    }
    const ContactState contact{state.handTip,  state.offset, velocity_, state.travel,
                               state.heldAt(), spin_,        dt,        rimSpeed() * dt};
    tick.wrench = force_.at(contact, materials_);
    tick.stiffness = force_.stiffness();
    tick.stretch = force_.stretch();
    lever_.setZero();
    double shares = 0;
    for (const HeldAt& held : state.heldAt()) {
        lever_ += held.share * (held.point - state.proxy.position);
        shares += held.share;
    }
    if (shares > 0) lever_ /= shares;
}

Tick HapticSimulation::step(const HandInput& input, double elapsed) {
    const double dt = std::isfinite(elapsed) ? elapsed : 0;  // else the speeds would stay what they become for ever
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
