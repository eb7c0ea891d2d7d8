// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/device_set.h"

#include <algorithm>

#include "devices/base/workspace_fit.h"

namespace tactooth {
namespace {

constexpr double kAtEnd = 2;   // mm from the limit of the workspace
constexpr double kBackIn = 8;  // mm, hysteresis: a hand that trembles at the limit is reported once

PoseReading readingOf(const DeviceSample& sample) {
    return {sample.hand.position, sample.hand.rotation, sample.age, sample.isFresh};
}

/// The springs of tooth and fixture are in a row, and their forces add up. What counts for the passivity controller is
/// the energy in both.
void addFixture(ForceCommand& wanted, const FixtureForce& fixture) {
    if (!(fixture.beyond > 0)) return;
    wanted.wrench.force += fixture.force;
    const double twiceEnergy = wanted.stiffness * wanted.deflection * wanted.deflection + 2 * fixture.energy;
    wanted.deflection += fixture.beyond;
    wanted.stiffness = twiceEnergy / (wanted.deflection * wanted.deflection);
    wanted.touching = true;
}

}  // namespace

DeviceSet::HeldDevice::HeldDevice(HapticDevice& held, const std::optional<DeviceRegistration>& turbineRegistration,
                                  const DeviceRegistration& mirrorRegistration)
    : device(&held),
      pipeline(held.info().limits, held.info().poseLimits),
      frames{DeviceMapping(turbineRegistration), DeviceMapping(mirrorRegistration)} {}

DeviceSet::DeviceSet(HapticDevice& first, HapticDevice* second, const std::optional<DeviceRegistration>& registration) {
    // The mirror follows the device's motion, starting where it is parked.
    const DeviceRegistration mirrorRegistration{Pose(), registration ? registration->turn : Quat::Identity()};
    first_.emplace(first, registration, mirrorRegistration);
    // An instrument that the second device takes over is never at that device's position, so the device needs a
    // registration with the same rotation.
    if (second != nullptr) second_.emplace(*second, mirrorRegistration, mirrorRegistration);
    devices_ = {&*first_, second_ ? &*second_ : nullptr};
    holders_ = {0, second_ ? 1 : kNoHolder};
}

bool DeviceSet::swapped() const { return first_->buttons.swapToggled() != (second_ && second_->buttons.swapToggled()); }

int DeviceSet::holderOf(std::size_t instrument) const {
    const int hand = (instrument == kMirror) != swapped() ? 1 : 0;
    return hand == 1 && !second_ ? kNoHolder : hand;
}

bool DeviceSet::cutToggled() const {
    return first_->buttons.cutToggled() != (second_ && second_->buttons.cutToggled());
}

double DeviceSet::pedal() const {
    double pedal = 0;
    for (const HeldDevice* const hand : devices_) {
        if (hand != nullptr && hand->poseValid) pedal = std::max(pedal, hand->sample.pedal);
    }
    return pedal;
}

double DeviceSet::age() const {
    const int holder = holders_[kTurbine];
    return holder == kNoHolder ? 0 : devices_[static_cast<std::size_t>(holder)]->sample.age;
}

double DeviceSet::maxStiffness() const {
    const int holder = holders_[kTurbine];
    return holder == kNoHolder ? std::numeric_limits<double>::infinity()
                               : devices_[static_cast<std::size_t>(holder)]->device->info().stiffness;
}

/// Leaves an instrument at rest while its device is lost or has a pose fault. A bur that was pressed deeper than the
/// tooth allowed stays at the surface.
void DeviceSet::rest(std::size_t instrument) {
    if (instrument == kTurbine && proxy_) instruments_[kTurbine] = *proxy_;
}

/// Moves an instrument with its device. An instrument that no device holds, or whose device is lost or has a pose
/// fault, stays where it is.
void DeviceSet::move(std::size_t instrument, const DeviceControls& controls, double elapsed) {
    const int holder = holderOf(instrument);
    const bool isNew = holder != holders_[instrument];
    holders_[instrument] = holder;
    if (holder == kNoHolder) return;
    HeldDevice& hand = *devices_[static_cast<std::size_t>(holder)];
    DeviceMapping& frame = hand.frames[instrument];
    if (isNew && instruments_[instrument].position.allFinite()) frame.takeOver(instruments_[instrument]);
    if (!hand.poseValid) return rest(instrument);
    frame.setMotionScaling(controls.motionScaling);
    frame.setClutch(controls.clutch || hand.buttons.clutchHeld());
    const Pose wanted = frame.toolFor(hand.sample.hand);
    if (instrument != kTurbine) {
        instruments_[instrument] = wanted;
        return;
    }
    instruments_[kTurbine] = depthStop_.hold(wanted, controls.depthStop, elapsed, proxy_ ? &proxy_->position : nullptr);
    if (controls.guide != nullptr) guide_ = controls.guide->push(instruments_[kTurbine]);
}

void DeviceSet::read(double elapsed, const DeviceControls& controls) {
    for (HeldDevice* const hand : devices_) {
        if (hand == nullptr) continue;
        const DeviceSample& sample = hand->sample = hand->device->read(elapsed);
        hand->poseValid = sample.connected && hand->pipeline.check(readingOf(sample), elapsed) == PoseFault::None;
        if (!hand->poseValid) continue;
        hand->buttons.press(hand->sample.buttons, controls.buttons);
        hand->atWorkspaceLimit = !controls.clutch && !hand->buttons.clutchHeld() &&
                                 isNearWorkspaceLimit(hand->device->info(), hand->sample.hand.position,
                                                      hand->atWorkspaceLimit ? kBackIn : kAtEnd);
    }
    guide_ = {};
    move(kTurbine, controls, elapsed);
    move(kMirror, controls, elapsed);
}

ForceCommand DeviceSet::wantedFor(const HeldDevice& hand, const Tick& tick, bool enabled) const {
    const int holder = holders_[kTurbine];
    const bool holds = holder != kNoHolder && devices_[static_cast<std::size_t>(holder)] == &hand;
    ForceCommand wanted = holds ? forceCommandFrom(tick) : ForceCommand{};
    if (holds) {
        const double beyond = depthStop_.beyond();
        addFixture(wanted, {depthStop_.force(), beyond, DepthStop::kStiffness * beyond * beyond / 2});
        addFixture(wanted, guide_);
    }
    const DeviceMapping& frame = hand.frames[kTurbine];
    wanted.wrench = frame.toDevice(wanted.wrench);
    wanted.driveForce = frame.toDevice(Wrench{wanted.driveForce, Vec3::Zero()}).force;
    wanted.hand = hand.sample.hand.position;
    wanted.turn = hand.sample.hand.rotation;
    wanted.age = hand.sample.age;
    wanted.isFresh = hand.sample.isFresh;
    wanted.deflection *= frame.motionScaling();
    wanted.stiffness /= frame.motionScaling();
    wanted.allowed &= enabled && holds && !frame.isHeld();
    wanted.connected = hand.sample.connected;
    wanted.motorTemperature = hand.sample.motorTemperature;
    return wanted;
}

void DeviceSet::write(const Tick& tick, bool enabled, double elapsed) {
    if (tick.contact.placed) proxy_ = tick.contact.proxy;
    silent_ = true;
    for (HeldDevice* const hand : devices_) {
        if (hand == nullptr) continue;
        const SafeWrench safe = hand->pipeline.pass(wantedFor(*hand, tick, enabled), elapsed);
        hand->device->write(safe);
        hand->device->recordPoseFault(hand->pipeline.fault(), elapsed);
        silent_ &= safe.force().isZero(0) && safe.torque().isZero(0);
    }
}

bool DeviceSet::isAtWorkspaceLimit() const {
    return first_->atWorkspaceLimit || (second_ && second_->atWorkspaceLimit);
}

ForceState DeviceSet::forceState() const {
    const int holder = holders_[kTurbine];
    return devices_[static_cast<std::size_t>(std::max(0, holder))]->pipeline.state();
}

}  // namespace tactooth
