// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/hand_servo.h"

#include <algorithm>

#include "devices/base/monotonic_clock.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kRepeatAfter = 1.5;  // periods without a new force: the device gets the last one again, so that it
                                      // does not take this process for hanging before the watchdog has judged
constexpr double kFadeStep = 0.0005;  // s between two steps of a fade-out
constexpr double kHoldAtEnd = 0.005;  // s of zero force before the end: any device has taken it by then
constexpr std::uint32_t kRuns = 0xFFFFFFFF;  // no cause: the loop is not to end

}  // namespace

void SampleSignal::onSample(void* signal) {
    auto& self = *static_cast<SampleSignal*>(signal);
    self.arrivedAt_.store(monotonicSeconds(), std::memory_order_relaxed);
    self.samples_.fetch_add(1, std::memory_order_release);
    self.bell_.ring();
}

HandServo::HandServo(HapticDevice& device, HandLink& link, const SampleSignal& signal, double rateHz)
    : device_(device),
      link_(link),
      signal_(signal),
      isDriving_(device.drivesServoRate()),
      period_(1 / rateHz),
      poses_(link.poses),
      forces_(link.forces),
      watchdog_(device.info().limits),
      validator_(device.info().poseLimits),
      endCause_(kRuns) {
    TACTOOTH_ASSERT(rateHz > 0);
}

void HandServo::end(HandFault cause) {
    std::uint32_t runs = kRuns;
    endCause_.compare_exchange_strong(runs, static_cast<std::uint32_t>(cause));
    link_.handBell.ring();
}

void HandServo::endIfAsked(double now) {
    if (link_.endRequested.load(std::memory_order_relaxed) != 0) {
        std::uint32_t runs = kRuns;
        endCause_.compare_exchange_strong(runs, static_cast<std::uint32_t>(HandFault::None));
    }
    const std::uint32_t cause = endCause_.load(std::memory_order_acquire);
    if (cause == kRuns || isEnding_) return;
    isEnding_ = true;
    silentSince_ = now;
    watchdog_.end(static_cast<HandFault>(cause), now);
}

void HandServo::turn(double now) {
    moment_.now = now;
    endIfAsked(now);
    const std::uint32_t suspended = link_.inputSuspended.load(std::memory_order_relaxed);
    if (suspended != suspended_) device_.suspendInput((suspended_ = suspended) != 0);
    const std::uint32_t samples = signal_.samples();
    const bool isNew = forces_.refresh();
    const bool isDue = isNew || now >= nextTurn_;
    if (isDue) write(now, isNew);
    if (isDue || samples != samples_) read(now);
    samples_ = samples;
    plan(now);
    turns_.fetch_add(1, std::memory_order_relaxed);
}

void HandServo::write(double now, bool isNew) {
    const SafeWrench wrench = isNew ? watchdog_.take(forces_.value(), moment_) : watchdog_.turn(now);
    device_.write(wrench);
    writtenAt_ = now;
    if (isNew) noteApplied(forces_.value(), now);
    if (const std::optional<ForceCut> record = watchdog_.fetchCut()) cuts_.push(*record);
    if (!watchdog_.isSilent()) silentSince_ = now;
    if (isEnding_ && now - silentSince_ >= kHoldAtEnd) hasEnded_.store(true, std::memory_order_release);
}

/// What the program measures the link by.
void HandServo::noteApplied(const ForceMessage& message, double now) {
    published_.applied = watchdog_.applied();
    published_.forceDelay = now - message.sentAt;
    published_.roundTrip = now - arrivals_[message.answers % kRemembered];
}

void HandServo::read(double now) {
    const double elapsed = hasRead_ ? std::max(0.0, now - readAt_) : 0;
    hasRead_ = true;
    readAt_ = now;
    const DeviceSample sample = device_.read(elapsed);
    if (sample.connected) {
        const PoseReading reading{sample.hand.position, sample.hand.rotation, sample.age, sample.isFresh};
        // Where a force pushes the hand the tool touches something, and the narrow limits apply. Without a force a late
        // fault harms nobody; the program knows about the contact and applies its own limits.
        moment_.isPoseValid = validator_.take(reading, elapsed, !watchdog_.isSilent()) == PoseFault::None;
    } else {
        validator_.forget();
        moment_.isPoseValid = false;
    }
    moment_.speed = validator_.speed();
    publish(sample, now);
    if (!moment_.isPoseValid && !watchdog_.isSilent()) device_.write(watchdog_.stop());
}

void HandServo::publish(const DeviceSample& sample, double now) {
    PoseMessage message = poseMessageOf(sample);
    message.sequence = message.endSequence = published_.sequence + 1;
    message.freshness = published_.freshness + (sample.isFresh ? 1 : 0);
    message.publishedAt = now;
    message.measuredAt = now - sample.age;
    message.fault = watchdog_.fault();
    message.applied = published_.applied;
    message.forceDelay = published_.forceDelay;
    message.roundTrip = published_.roundTrip;
    published_ = message;
    moment_.published = message.sequence;
    arrivals_[message.sequence % kRemembered] = signal_.samples() != 0 ? signal_.arrivedAt() : now;
    poses_.write(message);
    if (isDriving_ && sample.isFresh) link_.programBell.ring();
}

void HandServo::plan(double now) {
    nextTurn_ = std::min(writtenAt_ + kRepeatAfter * period_, watchdog_.silentFrom());
    if (watchdog_.isFading() || (isEnding_ && !hasEnded())) nextTurn_ = now + kFadeStep;
}

}  // namespace tactooth
