// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <ctime>

namespace tactooth {

/// A clock that is never adjusted; on Linux it is CLOCK_MONOTONIC of the system calls.
using MonotonicClock = std::chrono::steady_clock;

/// s since an arbitrary moment before the program started.
[[nodiscard]] inline double monotonicSeconds() {
    return std::chrono::duration<double>(MonotonicClock::now().time_since_epoch()).count();
}

[[nodiscard]] inline MonotonicClock::time_point secondsFromNow(double seconds) {
    return MonotonicClock::now() +
           std::chrono::duration_cast<MonotonicClock::duration>(std::chrono::duration<double>(seconds));
}

/// A time point of a clock as a POSIX timespec.
template <class Moment>
[[nodiscard]] timespec timespecOf(const Moment& moment) {
    const auto whole = std::chrono::floor<std::chrono::seconds>(moment);
    timespec time{};
    time.tv_sec = whole.time_since_epoch().count();
    time.tv_nsec = std::chrono::nanoseconds(moment - whole).count();
    return time;
}

}  // namespace tactooth
