// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/servo_loop.h"

#include <pthread.h>

#include <cmath>
#include <ctime>

#include "geometry/util/assert.h"
#include "haptics/cpu_latency_request.h"
#include "haptics/real_time.h"

namespace tactooth {
namespace {

constexpr long kNanosPerSecond = 1'000'000'000L;
constexpr double kMaxWait = 0.004;  // s for the next tick of a device: the force of a lost device is zero within 5 ms

constexpr double kMinTickPeriod = 0.0002;  // s: 5 kHz, faster than any device; a device that calls more often is faulty

double seconds(const timespec& later, const timespec& earlier) {
    return static_cast<double>(later.tv_sec - earlier.tv_sec) +
           1e-9 * static_cast<double>(later.tv_nsec - earlier.tv_nsec);
}

timespec now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time;
}

void advance(timespec& time, long nanos) {
    TACTOOTH_ASSERT(nanos > 0);
    time.tv_nsec += nanos;
    time.tv_sec += time.tv_nsec / kNanosPerSecond;
    time.tv_nsec %= kNanosPerSecond;
    TACTOOTH_ASSERT(time.tv_nsec >= 0 && time.tv_nsec < kNanosPerSecond);
}

/// Waits until a tick may follow the one that began at `last`. At real-time priority, a device that calls without end
/// would block the machine.
void limitRate(timespec last, const std::stop_token& stop) {
    advance(last, static_cast<long>(kMinTickPeriod * static_cast<double>(kNanosPerSecond)));
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &last, nullptr) != 0 && !stop.stop_requested()) {
    }
}

}  // namespace

ServoLoop::ServoLoop(double rateHz, std::function<void(double)> tick, std::function<void(double)> waitForDevice)
    : rateHz_(rateHz), tick_(std::move(tick)), waitForDevice_(std::move(waitForDevice)) {
    TACTOOTH_ASSERT(std::isfinite(rateHz) && rateHz > 0);
    TACTOOTH_ASSERT(tick_ != nullptr);
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

ServoLoop::~ServoLoop() = default;

void ServoLoop::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "servo");  // for debuggers and profilers
    realTime_.store(acquireRealTimePriority(), std::memory_order_relaxed);
    const CpuLatencyRequest sleep;
    cpuLatency_.store(sleep.isGranted(), std::memory_order_relaxed);
    const long period = static_cast<long>(static_cast<double>(kNanosPerSecond) / rateHz_);
    timespec due = now();
    timespec last = due;
    while (!stop.stop_requested()) {
        advance(due, period);
        if (waitForDevice_) {
            waitForDevice_(kMaxWait);
            if (seconds(now(), last) < kMinTickPeriod) limitRate(last, stop);
        } else {
            while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) != 0 && !stop.stop_requested()) {
            }
        }
        const timespec started = now();
        TACTOOTH_ASSERT(seconds(started, last) >= 0);
        if (!waitForDevice_) timing_.lateness.add(1e6 * seconds(started, due));
        timing_.jitter.add(1e6 * std::abs(seconds(started, last) - 1 / rateHz_));
        tick_(seconds(started, last));
        last = started;
        const timespec done = now();
        timing_.tick.add(1e6 * seconds(done, started));
        timing_.ticks.fetch_add(1, std::memory_order_relaxed);
        if (waitForDevice_) due = done;  // the device sets the rate
        while (seconds(done, due) * rateHz_ > 1) {
            advance(due, period);
            timing_.missed.fetch_add(1, std::memory_order_relaxed);
        }
    }
}

}  // namespace tactooth
