// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/servo_loop.h"

#include <pthread.h>
#include <sched.h>

#include <chrono>
#include <ctime>

namespace tactooth {
namespace {

constexpr long kNanosPerSecond = 1'000'000'000L;
constexpr int kPriority = 60;  // above everything ordinary, below the kernel's own interrupt threads

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
    time.tv_nsec += nanos;
    time.tv_sec += time.tv_nsec / kNanosPerSecond;
    time.tv_nsec %= kNanosPerSecond;
}

bool askForRealTime() {
    sched_param parameters{};
    parameters.sched_priority = kPriority;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

}  // namespace

ServoLoop::ServoLoop(double rateHz, std::function<void(double)> tick) : rateHz_(rateHz), tick_(std::move(tick)) {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

ServoLoop::~ServoLoop() = default;

void ServoLoop::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "servo");  // for debuggers and profilers
    realTime_.store(askForRealTime(), std::memory_order_relaxed);
    const long period = static_cast<long>(static_cast<double>(kNanosPerSecond) / rateHz_);
    timespec due = now();
    timespec last = due;
    while (!stop.stop_requested()) {
        advance(due, period);
        while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) != 0 && !stop.stop_requested()) {
        }
        const timespec started = now();
        timing_.lateness.add(1e6 * seconds(started, due));
        tick_(seconds(started, last));
        last = started;
        const timespec done = now();
        timing_.tick.add(1e6 * seconds(done, started));
        timing_.ticks.fetch_add(1, std::memory_order_relaxed);
        while (seconds(done, due) * rateHz_ > 1) {
            advance(due, period);
            timing_.missed.fetch_add(1, std::memory_order_relaxed);
        }
    }
}

}  // namespace tactooth
