// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/haptic_simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/util/assert.h"

// Removal law: dV = k * F_n * v_rim * dt with k of the material (volume per force and rim travel). The tangential force
// that loads the spindle is about half of the normal force (see cutting_force.h).

namespace tactooth {
namespace {

// Hz: above the 10 Hz of a hand, below the noise of an encoder step of 55 um at 1 kHz.
constexpr double kVelocityCutoff = 100;

/// Whether a device can have this pose. False also for a pose that is not finite.
bool isPlausible(const Pose& device) {
    return isRigid(device) && device.position.cwiseAbs().maxCoeff() < kMaxCoordinate;
}

/// The input with a rotation of unit length. A device may be off by more than rounding; rounding itself stays as it is.
OperatorInput withUnitRotation(OperatorInput input) {
    constexpr double kRounding = 1e-12;  // of the squared length
    Quat& rotation = input.deviceInTooth.rotation;
    if (std::abs(rotation.squaredNorm() - 1) > kRounding) rotation.normalize();
    return input;
}

}  // namespace

HapticSimulation::HapticSimulation(std::shared_ptr<const ToolShape> tool, double burRadius,
                                   std::shared_ptr<const Surface> surface, const HapticSettings& settings)
    : proxy_(std::move(tool), std::move(surface), settings.mode, settings.freedom),
      force_(settings.materials),
      spindle_(settings.spindle),
      burRadius_(burRadius),
      freedom_(settings.freedom),
      tickBudget_(settings.tickBudget) {
    TACTOOTH_ASSERT(std::isfinite(burRadius) && burRadius >= 0);
    TACTOOTH_ASSERT(settings.tickBudget > 0);
    TACTOOTH_ASSERT(std::isfinite(settings.spindle.freeSpeedRpm) && settings.spindle.freeSpeedRpm >= 0);
    force_.setOverrides(settings.force);
}

void HapticSimulation::holdByHand(HandInstrument kind, const MaterialTable& materials) {
    TACTOOTH_ASSERT(!started_);
    hand_ = kind;
    for (const MaterialId id : materials.registry().ids()) {
        softness_[static_cast<std::size_t>(id)] = softness(materials, id);
    }
}

void HapticSimulation::setTickBudget(Work work) {
    TACTOOTH_ASSERT(work > 0);
    tickBudget_ = work;
}

void HapticSimulation::setSurface(HapticSurface& hapticSurface) {
    TACTOOTH_ASSERT(hapticSurface.surface != nullptr);
    TACTOOTH_ASSERT(hapticSurface.reach.allFinite());
    const Vec3 reach = hapticSurface.reach;
    if (!proxy_.setSurface(hapticSurface)) return;
    feedLimiter_.allow((reach - proxy_.pose().position).norm());
    isHoldOutdated_ = tipHold_.force() > 0;
}

/// A cutting bur moves at the rate of its cut, so a tick that leaves some displacement to the next one is late by
/// micrometres. A tool that only touches is exact at every tick.
Pose HapticSimulation::targetOf(const OperatorInput& input, double dt) {
    feedLimiter_.pass(dt);
    const bool cuts =
        input.cutting && last_.contact.triangles > 0 && last_.spindle.speedRpm > kMinCuttingRpm && following_;
    const Pose& device = input.deviceInTooth;
    if (hand_ == HandInstrument::Explorer) {
        proxy_.setBudget(kUnlimitedWork);
        const std::optional<Vec3> held = tipHold_.placeFor(device.position);
        return {held.value_or(device.position), device.rotation};
    }
    proxy_.setBudget(cuts ? tickBudget_ : kUnlimitedWork);
    return cuts ? feedLimiter_.goal(device, proxy_.pose(), device.position - lastDevice_.position, dt) : device;
}

void HapticSimulation::filterVelocity(const Pose& device, double dt) {
    TACTOOTH_ASSERT(isPlausible(device));
    if (!following_ || dt <= 0) {
        velocity_.setZero();
        spin_.setZero();
        lastDevice_ = device;
        following_ = true;
        return;
    }
    const double filterGain = 1 - std::exp(-2 * std::numbers::pi * kVelocityCutoff * dt);
    TACTOOTH_ASSERT(filterGain >= 0 && filterGain <= 1);
    velocity_ += filterGain * ((device.position - lastDevice_.position) / dt - velocity_);
    if (freedom_ == Freedom::TranslationAndRotation) {
        const Quat turn = device.rotation * lastDevice_.rotation.conjugate();
        spin_ += filterGain * ((turn.w() < 0 ? -2 : 2) / dt * turn.vec() - spin_);  // for small angles
    }
    lastDevice_ = device;
}

/// Speed of the bur's rim, mm/s.
double HapticSimulation::rimSpeed() const { return bur_.speedRpm / 60 * 2 * std::numbers::pi * burRadius_; }

/// Of the tissue that holds the tip itself, not the hook behind it; 0 if none does.
double HapticSimulation::softnessAtTip(const ProxyState& state) const {
    constexpr double kTip = 0.4;  // mm
    const ContactPoint* nearest = nullptr;
    for (const ContactPoint& held : state.contactPoints()) {
        if (held.isAdjacent || (held.point - state.proxy.position).norm() > kTip) continue;
        if (nearest == nullptr || held.multiplier > nearest->multiplier) nearest = &held;
    }
    return nearest != nullptr ? softness_[static_cast<std::size_t>(nearest->material)] : 0;
}

void HapticSimulation::updateTipHold(const ProxyState& state, double dt, Tick& tick) {
    if (hand_ != HandInstrument::Explorer) return;
    if (!state.placed || state.contacts == 0 || tick.contact.normal.isZero(0)) {
        // A hand that is where the tip is held pulls at nothing.
        if (!state.placed || tipHold_.force() == 0) tipHold_.release();
    } else {
        tipHold_.touch(
            {state.proxy.position, tick.contact.normal, force_.normalForce(), force_.stiffness(), softnessAtTip(state)},
            dt);
    }
    tick.force.tipHold = tipHold_.force();
}

/// A pull-out is a hold that the hand has overcome, with nothing that holds the tip afterwards. A faulty pose ends a
/// hold, too, and so may a tooth that is put back; neither is a pull-out. A tip that is dragged on within the decay is
/// held again in the same tick, so it has not come free.
void HapticSimulation::countPullOut(Tick& tick) {
    const double holdBefore = last_.force.tipHold;
    const bool isHeld = tick.force.tipHold > 0;
    const bool cameFree = holdBefore > 0 && !isHeld && tick.contact.placed && !isHoldOutdated_;
    if (!isHeld) isHoldOutdated_ = false;
    tick.contact.pullOuts = last_.contact.pullOuts + (cameFree ? 1 : 0);
    tick.contact.pullOutForce = cameFree ? holdBefore : last_.contact.pullOutForce;
    TACTOOTH_ASSERT(std::isfinite(tick.contact.pullOutForce) && tick.contact.pullOutForce >= 0);
}

/// The work of a blade in this tick, N*m: of its force along the path of the hand, less the part of the path out of the
/// tissue.
double HapticSimulation::bladeWork(const Tick& tick, double dt) const {
    if (tick.contact.triangles == 0) return 0;
    Vec3 displacement = dt * velocity_;
    displacement -= std::max(0.0, displacement.dot(tick.contact.normal)) * tick.contact.normal;
    return 1e-3 * force_.normalForce() * displacement.norm();
}

/// Advances the spindle by one step under the load of the cut, and adds up the work that the cut may spend.
void HapticSimulation::stepBur(double dt, Tick& tick) {
    TACTOOTH_ASSERT(tick.input.pedal >= 0 && tick.input.pedal <= 1);
    const bool isEngaged = tick.input.cutting && tick.contact.triangles > 0 && bur_.speedRpm > kMinCuttingRpm;
    const double tangential = isEngaged ? kTangentialRatio * force_.normalForce() : 0;
    tick.spindle.load = tangential * burRadius_;
    bur_ = stepSpindle(spindle_, bur_, tick.input.cutting ? tick.input.pedal : 0, tick.spindle.load, dt);
    TACTOOTH_ASSERT(tick.spindle.load >= 0);
    TACTOOTH_ASSERT(std::isfinite(bur_.speedRpm) && bur_.speedRpm >= 0);
    const double rimMeters = 1e-3 * rimSpeed();  // a second
    tick.spindle.speedRpm = bur_.speedRpm;
    tick.spindle.removalPower = tangential * rimMeters;
    const Vec3 axis = tick.contact.proxy.rotation * Vec3::UnitZ();
    const double force = isEngaged ? force_.normalForce() : 0;
    const Vec3 pull = cuttingForce_.at({tick.contact.normal, axis, force, bur_.speedRpm, spindle_.freeSpeedRpm}, dt);
    tick.force.drive = pull;
    tick.force.wrench.force += pull;
    tick.force.wrench.torque += lever_.cross(pull);
    // The mean of both ends of the tick: for a growing force it gives the same at any rate.
    const double power = force * rimMeters;  // N*m a second
    tick.spindle.cutWork = last_.spindle.cutWork + (isEngaged ? (power_ + power) / 2 * dt : 0);
    if (hand_ == HandInstrument::Excavator) tick.spindle.cutWork += bladeWork(tick, dt);
    TACTOOTH_ASSERT(tick.spindle.cutWork >= last_.spindle.cutWork);
    power_ = power;
}

/// Of a proxy that has touched at both ends of the tick.
double HapticSimulation::slideSpeed(const Tick::Contact& now, double dt) const {
    if (last_.contact.triangles == 0 || dt <= 0) return 0;
    const Vec3 displacement = now.proxy.position - last_.contact.proxy.position;
    return (displacement - displacement.dot(now.normal) * now.normal).norm() / dt;
}

/// Moves the proxy toward the device and computes the force.
void HapticSimulation::touch(const OperatorInput& input, double dt, Tick& tick) {
    tick.input.device = input.deviceInTooth;
    tick.input.speed = following_ && dt > 0 ? (input.deviceInTooth.position - lastDevice_.position).norm() / dt : 0;
    const Pose goal = targetOf(input, dt);
    filterVelocity(input.deviceInTooth, dt);

    const ProxyState state = proxy_.follow(input.deviceInTooth, goal, dt);
    feedLimiter_.carryOver(state.late);
    tick.contact.placed = state.placed;
    tick.diagnostics.ownListRebuilds = proxy_.ownListRebuilds();
    tick.contact.proxy = state.placed ? state.proxy : input.deviceInTooth;
    tick.contact.triangles = state.contacts;
    if (state.contacts > 0 && state.offset.norm() > 0) {
        tick.contact.depth = state.offset.norm();
        tick.contact.normal = state.offset / tick.contact.depth;
        TACTOOTH_ASSERT(isUnit(tick.contact.normal));
        tick.contact.slideSpeed = slideSpeed(tick.contact, dt);
        TACTOOTH_ASSERT(state.contactPointCount > 0);
        tick.contact.material =
            std::ranges::max_element(state.contactPoints(), {}, &ContactPoint::multiplier)->material;
    }
    for (const ContactPoint& held : state.contactPoints()) {
        if (held.isAdjacent) tick.contact.around = held.material;
    }
    const ContactState contact{state.deviceTip,       state.offset, velocity_, state.travel,
                               state.contactPoints(), spin_,        dt,        rimSpeed() * dt};
    tick.force.wrench = force_.at(contact);
    updateTipHold(state, dt, tick);
    tick.force.stiffness = force_.stiffness();
    tick.force.deflection = force_.deflection();
    lever_.setZero();
    double sum = 0;
    for (const ContactPoint& held : state.contactPoints()) {
        lever_ += held.multiplier * (held.point - state.proxy.position);
        sum += held.multiplier;
    }
    TACTOOTH_ASSERT(!(sum < 0));
    if (sum > 0) lever_ /= sum;
}

Tick HapticSimulation::step(const OperatorInput& input, double elapsed) {
    TACTOOTH_ASSERT(!(elapsed < 0));
    const double dt = std::isfinite(elapsed) ? elapsed : 0;  // else the low-passed speeds would stay NaN
    Tick tick;
    tick.time = last_.time + (started_ ? dt : 0);
    started_ = true;
    tick.input.cutting = input.cutting && !hand_;  // no drive: nothing turns, whatever pedal and buttons say
    tick.input.pedal = std::isfinite(input.pedal) && !hand_ ? std::clamp(input.pedal, 0.0, 1.0) : 0;
    if (isPlausible(input.deviceInTooth)) {
        touch(withUnitRotation(input), dt, tick);
    } else {
        tick.input.device = last_.input.device;
        tick.contact.proxy = last_.contact.proxy;
        following_ = false;
        tipHold_.release();
    }
    stepBur(dt, tick);
    countPullOut(tick);

    TACTOOTH_ASSERT(tick.contact.placed || tick.contact.triangles == 0);
    TACTOOTH_ASSERT(tick.contact.triangles > 0 || tick.force.wrench.force.isZero(0));
    const bool touching = tick.contact.triangles > 0;
    tick.contact.onsets = last_.contact.onsets + (touching && !touching_ ? 1 : 0);
    tick.contact.impactSpeed =
        touching && !touching_ ? std::max(0.0, -velocity_.dot(tick.contact.normal)) : last_.contact.impactSpeed;
    TACTOOTH_ASSERT(tick.time >= last_.time);
    TACTOOTH_ASSERT(tick.contact.impactSpeed >= 0);
    touching_ = touching;
    last_ = tick;
    return tick;
}

}  // namespace tactooth
