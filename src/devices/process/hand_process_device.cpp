// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/hand_process_device.h"

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <limits>
#include <thread>
#include <utility>

#include "devices/base/kept_message.h"
#include "devices/base/monotonic_clock.h"
#include "devices/process/messages.h"
#include "devices/process/processor.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kDelay = 0.0025;          // s by which a pose may be late: two ticks are missing at 1 kHz
constexpr double kLongestPeriods = 1.5;    // between two poses of a process that gets no force
constexpr double kSilenceShown = 0.05;     // s: a shorter silence is not worth a sentence
constexpr double kShownFor = 3;            // s for which a refused force is shown: long enough to be read
constexpr double kClockTolerance = 0.001;  // s by which a message may come from the future
constexpr std::uint32_t kMostMissed = std::numeric_limits<std::uint32_t>::max() / 2;
const Message kSilent(msg::kHandIsSilent);
const Message kOther(msg::kHandOtherDevice);

/// A force limiter and a pose validator here were made for the limits of the first device.
bool haveSameLimits(const DeviceDescription& one, const DeviceDescription& other) {
    return std::memcmp(&one.limits, &other.limits, sizeof one.limits) == 0 &&
           std::memcmp(&one.poseLimits, &other.poseLimits, sizeof one.poseLimits) == 0 &&
           one.drivesServoRate == other.drivesServoRate;
}

}  // namespace

HandProcessDevice::HandProcessDevice(const HandRequest& request)
    : supervisor_(request), longestSilence_(kDelay + kLongestPeriods / request.rateHz) {
    TACTOOTH_ASSERT(request.rateHz > 0);
}

Expected<void> HandProcessDevice::open() {
    close();
    if (const auto started = supervisor_.start(); !started) return started;
    HandLink* const link = supervisor_.link();
    description_ = link != nullptr ? link->description : DeviceDescription{};
    const std::optional<DeviceInfo> info = link != nullptr ? infoFrom(description_) : std::nullopt;
    if (!info) {
        close();
        return unexpected(msg::kHandEndsAtStart, Message(textOf(HandFault::HandEnded)));
    }
    info_ = *info;
    attach(link);
    return {};
}

void HandProcessDevice::close() {
    attach(nullptr);
    {
        const std::lock_guard lock(textMutex_);
        textLink_ = nullptr;
        texts_.reset();
    }
    supervisor_.stop();
}

/// Begins to use a link; nullptr: none.
void HandProcessDevice::attach(HandLink* link) {
    link_ = link;
    poses_.reset();
    forces_.reset();
    hasPose_ = false;
    pose_ = {};
    sequence_ = freshness_ = 0;
    silence_ = 0;
    if (link == nullptr) return;
    isSameDevice_ = haveSameLimits(link->description, description_);
    isOther_.store(!isSameDevice_, std::memory_order_relaxed);
    link->inputSuspended.store(suspended_.load() ? 1 : 0, std::memory_order_relaxed);
    poses_.emplace(link->poses);
    forces_.emplace(link->forces);
    rings_ = link->programBell.rings();
}

/// Keeps the calling thread, a servo with real-time priority, on its processor, and asks the hand process to come
/// there. The two take turns, so neither loses by that. Once for each thread and link.
void HandProcessDevice::shareProcessor() {
    const auto thread = std::this_thread::get_id();
    const bool isKnown = thread == servoThread_ && link_->servoProcessor.load(std::memory_order_relaxed) >= 0;
    if (isKnown || link_->mayShareProcessor.load(std::memory_order_relaxed) == 0) return;
    if (sched_getscheduler(0) != SCHED_FIFO) return;
    const int processor = sched_getcpu();
    if (processor < 0 || !keepOnProcessor(processor)) return;
    servoThread_ = thread;
    link_->servoProcessor.store(processor, std::memory_order_relaxed);
}

/// Whether there is a process whose device is open; follows a new process.
bool HandProcessDevice::isAttached() {
    HandLink* const link = supervisor_.link();
    const bool isOpen = link != nullptr && link->status.load(std::memory_order_acquire) == HandStatus::Open;
    if (!isOpen) {
        if (link_ != nullptr) attach(nullptr);
        return false;
    }
    if (link != link_) attach(link);
    return isSameDevice_;
}

void HandProcessDevice::waitForTick(double longest) {
    if (link_ == nullptr) {  // the servo goes on, and finds the next process
        std::this_thread::sleep_for(std::chrono::duration<double>(longest));
        return;
    }
    shareProcessor();
    link_->programBell.wait(rings_, monotonicSeconds() + longest);
    rings_ = link_->programBell.rings();
}

void HandProcessDevice::take(const PoseMessage& message, double now) {
    const bool isWhole = message.sequence == message.endSequence;
    const bool isInOrder = !hasPose_ || follows(message.sequence, pose_.sequence, kMostMissed);
    const bool isOfNow = message.publishedAt <= now + kClockTolerance;  // false for NaN
    if (!isWhole || !isInOrder || !isOfNow) return;                     // the last one becomes too old
    readDelay_ = now - message.publishedAt;
    if (hasPose_ && message.applied != pose_.applied && drivesServoRate()) {
        addedLatency_.add(1e6 * (readDelays_[message.applied % kRemembered] + message.forceDelay));
        responseTime_.add(1e6 * message.roundTrip);
    }
    pose_ = message;
    hasPose_ = true;
}

void HandProcessDevice::noteFault(HandFault fault, double elapsed) {
    refusalLeft_ -= elapsed;
    if (fault != HandFault::None) {
        refusalLeft_ = kShownFor;
        refusal_.store(fault, std::memory_order_relaxed);
    } else if (refusalLeft_ <= 0) {
        refusal_.store(HandFault::None, std::memory_order_relaxed);
    }
}

DeviceSample HandProcessDevice::read(double elapsed) {
    DeviceSample sample;
    sample.connected = false;
    if (!isAttached()) {
        noteFault(HandFault::None, elapsed);
        isSilent_.store(false, std::memory_order_relaxed);  // the supervisor knows more
        return sample;
    }
    const double now = monotonicSeconds();
    if (poses_->refresh()) take(poses_->value(), now);
    silence_ = hasPose_ ? now - pose_.publishedAt : silence_ + elapsed;
    isSilent_.store(silence_ > kSilenceShown, std::memory_order_relaxed);
    noteFault(hasPose_ ? pose_.fault : HandFault::None, elapsed);
    if (!hasPose_) return sample;
    sample = sampleFrom(pose_);
    sample.age = now - pose_.measuredAt;
    sample.isFresh = pose_.freshness != freshness_;
    freshness_ = pose_.freshness;
    sample.connected = sample.connected && silence_ <= longestSilence_ && pose_.fault == HandFault::None;
    return sample;
}

void HandProcessDevice::write(const SafeWrench& wrench) {
    if (!forces_) return;
    TACTOOTH_ASSERT(link_ != nullptr);
    ForceMessage message = forceMessageOf(wrench);
    message.sequence = message.endSequence = ++sequence_;
    message.answers = pose_.sequence;
    message.sentAt = monotonicSeconds();
    readDelays_[message.sequence % kRemembered] = readDelay_;
    forces_->write(message);
    link_->handBell.ring();
}

void HandProcessDevice::suspendInput(bool rests) {
    suspended_.store(rests, std::memory_order_relaxed);
    if (HandLink* const link = supervisor_.link()) link->inputSuspended.store(rests ? 1 : 0, std::memory_order_relaxed);
}

/// What the device itself says, in its process.
const Message* HandProcessDevice::deviceMessage() const {
    HandLink* const link = supervisor_.link();
    if (link == nullptr) return nullptr;
    const std::lock_guard lock(textMutex_);
    if (link != std::exchange(textLink_, link)) texts_.emplace(link->faults);
    (void)texts_->refresh();
    const std::optional<Message> message = messageFrom(texts_->value());
    return message ? &keptMessage(*message) : nullptr;
}

const Message* HandProcessDevice::faultMessage() const {
    if (const Message* const gone = supervisor_.faultMessage()) return gone;
    if (isOther_.load(std::memory_order_relaxed)) return &kOther;
    if (const HandFault fault = refusal_.load(std::memory_order_relaxed); fault != HandFault::None) {
        return &keptMessage({msg::kHandRefusedForce, textOf(fault)});
    }
    if (const Message* const said = deviceMessage()) return said;
    return isSilent_.load(std::memory_order_relaxed) ? &kSilent : HapticDevice::faultMessage();
}

}  // namespace tactooth
