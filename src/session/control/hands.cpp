// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/hands.h"

#include <algorithm>

#include "devices/workspace_fit.h"

namespace tactooth {
namespace {

constexpr double kAtEnd = 2;   // mm from the end of the room
constexpr double kBackIn = 8;  // mm: a hand that trembles there is told once

PoseReading readingOf(const DeviceSample& sample) {
    return {sample.hand.position, sample.hand.rotation, sample.age, sample.isFresh};
}

}  // namespace

Hands::Hand::Hand(HapticDevice& held, const std::optional<Seat>& turbineSeat, const Seat& mirrorSeat)
    : device(&held),
      pipeline(held.info().limits, held.info().poseLimits),
      frames{HandFrame(turbineSeat), HandFrame(mirrorSeat)} {}

Hands::Hands(HapticDevice& first, HapticDevice* second, const std::optional<Seat>& seat) {
    // The mirror moves the way that the hand does, from where it is parked.
    const Seat mirrorSeat{Pose(), seat ? seat->turn : Quat::Identity()};
    first_.emplace(first, seat, mirrorSeat);
    // What a second hand takes over is never where that hand is, so it needs a seat that turns it alike.
    if (second != nullptr) second_.emplace(*second, mirrorSeat, mirrorSeat);
    hands_ = {&*first_, second_ ? &*second_ : nullptr};
    holders_ = {0, second_ ? 1 : kNobody};
}

bool Hands::swapped() const { return first_->buttons.swapToggled() != (second_ && second_->buttons.swapToggled()); }

int Hands::holderOf(std::size_t instrument) const {
    const int hand = (instrument == kMirror) != swapped() ? 1 : 0;
    return hand == 1 && !second_ ? kNobody : hand;
}

bool Hands::cutToggled() const { return first_->buttons.cutToggled() != (second_ && second_->buttons.cutToggled()); }

double Hands::pedal() const {
    double pedal = 0;
    for (const Hand* const hand : hands_) {
        if (hand != nullptr && hand->trusted) pedal = std::max(pedal, hand->sample.pedal);
    }
    return pedal;
}

double Hands::age() const {
    const int holder = holders_[kTurbine];
    return holder == kNobody ? 0 : hands_[static_cast<std::size_t>(holder)]->sample.age;
}

double Hands::stiffest() const {
    const int holder = holders_[kTurbine];
    return holder == kNobody ? std::numeric_limits<double>::infinity()
                             : hands_[static_cast<std::size_t>(holder)]->device->info().stiffness;
}

/// A bur that was pressed deeper than the tooth let it stays at the surface.
void Hands::rest(std::size_t instrument) {
    if (instrument == kTurbine && proxy_) instruments_[kTurbine] = *proxy_;
}

/// An instrument that nobody holds, or whose hand has lost its device, stays where it is.
void Hands::move(std::size_t instrument, const HandControls& controls) {
    const int holder = holderOf(instrument);
    const bool isNew = holder != holders_[instrument];
    holders_[instrument] = holder;
    if (holder == kNobody) return;
    Hand& hand = *hands_[static_cast<std::size_t>(holder)];
    HandFrame& frame = hand.frames[instrument];
    if (isNew && instruments_[instrument].position.allFinite()) frame.takeOver(instruments_[instrument]);
    if (!hand.trusted) return rest(instrument);
    frame.setFineness(controls.fineness);
    frame.setClutch(controls.clutch || hand.buttons.clutchHeld());
    instruments_[instrument] = frame.toolFor(hand.sample.hand);
}

void Hands::read(double elapsed, const HandControls& controls) {
    for (Hand* const hand : hands_) {
        if (hand == nullptr) continue;
        const DeviceSample& sample = hand->sample = hand->device->read(elapsed);
        hand->trusted = sample.connected && hand->pipeline.judge(readingOf(sample), elapsed) == HandFault::None;
        if (!hand->trusted) continue;
        hand->buttons.press(hand->sample.buttons, controls.buttons);
        hand->atEnd = !controls.clutch && !hand->buttons.clutchHeld() &&
                      isAtEndOfRoom(hand->device->info(), hand->sample.hand.position, hand->atEnd ? kBackIn : kAtEnd);
    }
    move(kTurbine, controls);
    move(kMirror, controls);
}

WantedForce Hands::wantedFor(const Hand& hand, const Tick& tick, bool enabled) const {
    const int holder = holders_[kTurbine];
    const bool holds = holder != kNobody && hands_[static_cast<std::size_t>(holder)] == &hand;
    WantedForce wanted = wantedFrom(tick);
    if (!holds) wanted = WantedForce{};
    const HandFrame& frame = hand.frames[kTurbine];
    wanted.wrench = frame.toDevice(wanted.wrench);
    wanted.drivePull = frame.toDevice(Wrench{wanted.drivePull, Vec3::Zero()}).force;
    wanted.hand = hand.sample.hand.position;
    wanted.turn = hand.sample.hand.rotation;
    wanted.age = hand.sample.age;
    wanted.isFresh = hand.sample.isFresh;
    wanted.stretch *= frame.fineness();
    wanted.stiffness /= frame.fineness();
    wanted.allowed &= enabled && holds && !frame.isHeld();
    wanted.connected = hand.sample.connected;
    wanted.motorHeat = hand.sample.motorHeat;
    return wanted;
}

void Hands::write(const Tick& tick, bool enabled, double elapsed) {
    if (tick.placed) proxy_ = tick.proxy;
    silent_ = true;
    for (Hand* const hand : hands_) {
        if (hand == nullptr) continue;
        const SafeWrench safe = hand->pipeline.pass(wantedFor(*hand, tick, enabled), elapsed);
        hand->device->write(safe);
        hand->device->judge(hand->pipeline.fault(), elapsed);
        silent_ &= safe.force().isZero(0) && safe.torque().isZero(0);
    }
}

bool Hands::isAtEnd() const { return first_->atEnd || (second_ && second_->atEnd); }

ForceState Hands::forceState() const {
    const int holder = holders_[kTurbine];
    return hands_[static_cast<std::size_t>(std::max(0, holder))]->pipeline.state();
}

}  // namespace tactooth
