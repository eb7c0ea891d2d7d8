// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/lockfree/spsc_queue.hpp>

#include <array>
#include <atomic>
#include <cstdint>

#include "devices/base/haptic_device.h"
#include "devices/process/force_watchdog.h"
#include "devices/process/hand_link.h"
#include "haptics/pose_validator.h"

namespace tactooth {

/// Notifies the hand process of a device's samples: the device calls its listener, and the bell rings.
class SampleSignal {
public:
    explicit SampleSignal(Bell& bell) : bell_(bell) {}

    /// The object must outlive the device that has it.
    [[nodiscard]] SampleListener listener() { return {&SampleSignal::onSample, this}; }
    [[nodiscard]] std::uint32_t samples() const { return samples_.load(std::memory_order_acquire); }
    /// s of the monotonic clock; of the newest sample.
    [[nodiscard]] double arrivedAt() const { return arrivedAt_.load(std::memory_order_relaxed); }

private:
    static void onSample(void* signal);

    Bell& bell_;
    std::atomic<std::uint32_t> samples_{0};
    std::atomic<double> arrivedAt_{0};
};

/// The loop of the hand process, turn by turn: samples of the device go out, forces come in through the watchdog. Its
/// thread makes a turn when the bell of the link rings, and at nextTurn(). A turn reads no clock, and allocates, locks
/// and logs nothing.
class HandServo {
public:
    /// `device` is open. All arguments outlive the object. `rateHz`: of the program's servo.
    HandServo(HapticDevice& device, HandLink& link, const SampleSignal& signal, double rateHz);

    /// `now`: s of the monotonic clock, never before that of the last turn.
    void turn(double now);
    /// When the next turn is due, s of the monotonic clock, if the bell does not ring before.
    [[nodiscard]] double nextTurn() const { return nextTurn_; }

    /// Any thread: fades the force out and ends. HandFault::None: the program has asked for it.
    void end(HandFault cause);
    /// Any thread: whether the force has been zero for some ticks since end().
    [[nodiscard]] bool hasEnded() const { return hasEnded_.load(std::memory_order_acquire); }

    /// One other thread: the oldest cut that was not fetched yet.
    [[nodiscard]] bool fetchCut(ForceCut& record) { return cuts_.pop(record); }
    /// Any thread: counts the turns, so that another thread sees that the loop runs.
    [[nodiscard]] std::uint32_t turns() const { return turns_.load(std::memory_order_relaxed); }

private:
    void write(double now, bool isNew);
    void read(double now);
    void publish(const DeviceSample& sample, double now);
    void noteApplied(const ForceMessage& message, double now);
    void endIfAsked(double now);
    void plan(double now);

    HapticDevice& device_;
    HandLink& link_;
    const SampleSignal& signal_;
    bool isDriving_;  // the device sets the program's rate
    double period_;   // s
    SlotWriter<PoseMessage> poses_;
    SlotReader<ForceMessage> forces_;
    ForceWatchdog watchdog_;
    PoseValidator validator_;
    HandMoment moment_;
    PoseMessage published_;
    std::uint32_t samples_ = 0;  // that were read
    std::uint32_t suspended_ = 0;
    bool hasRead_ = false;
    double readAt_ = 0;     // s
    double writtenAt_ = 0;  // s
    double nextTurn_ = 0;   // s
    static constexpr std::size_t kRemembered = 16;
    std::array<double, kRemembered> arrivals_{};  // s, of the samples behind the newest poses, by their sequence
    std::atomic<std::uint32_t> endCause_;
    bool isEnding_ = false;
    double silentSince_ = 0;  // s, while it ends
    std::atomic<bool> hasEnded_{false};
    std::atomic<std::uint32_t> turns_{0};
    boost::lockfree::spsc_queue<ForceCut, boost::lockfree::capacity<64>> cuts_;
};

}  // namespace tactooth
