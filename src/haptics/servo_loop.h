// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include "haptics/latency_histogram.h"

namespace tactooth {

/// Timing of the servo thread. Any thread reads.
struct ServoTiming {
    LatencyHistogram tick;      ///< duration of the work of a tick, us
    LatencyHistogram lateness;  ///< wake-up latency, us; none where a device sets the rate
    LatencyHistogram jitter;    ///< difference between the period and the time between two ticks, us
    std::atomic<std::uint64_t> ticks{0};
    std::atomic<std::uint64_t> missed{0};  ///< periods that passed without a tick
};

/// Calls a function at a fixed rate, or at a device's own rate, from its own thread, at real-time priority where the
/// system allows it. A late tick is skipped and not repeated: simulated time stands still, so that the loop does not
/// fall behind.
class ServoLoop {
public:
    /// `tick(elapsed)` gets the time since the last tick, s; it must not block. `waitForDevice(longest)` returns when
    /// the device is ready for the next tick or when `longest` s have passed; without it the clock sets the rate. A
    /// device that is ready more often than 5000 times a second has to wait. `rateHz` is finite and positive.
    ServoLoop(double rateHz, std::function<void(double)> tick, std::function<void(double)> waitForDevice = {});
    ~ServoLoop();
    ServoLoop(const ServoLoop&) = delete;
    ServoLoop& operator=(const ServoLoop&) = delete;

    [[nodiscard]] const ServoTiming& timing() const { return timing_; }
    [[nodiscard]] double rateHz() const { return rateHz_; }
    /// Whether the thread runs at real-time priority. Without the right to it everything works, with more jitter.
    [[nodiscard]] bool isRealTime() const { return realTime_.load(std::memory_order_relaxed); }
    /// Whether the processors are kept out of deep idle states while the loop runs (CpuLatencyRequest).
    [[nodiscard]] bool limitsCpuLatency() const { return cpuLatency_.load(std::memory_order_relaxed); }

private:
    void run(const std::stop_token& stop);

    double rateHz_;
    std::function<void(double)> tick_;
    std::function<void(double)> waitForDevice_;
    ServoTiming timing_;
    std::atomic<bool> realTime_{false};
    std::atomic<bool> cpuLatency_{false};
    std::jthread thread_;  // last member: it uses all others
};

}  // namespace tactooth
