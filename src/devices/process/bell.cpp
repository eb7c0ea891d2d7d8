// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/bell.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <ctime>

// Linux manual page futex(2). Not FUTEX_PRIVATE_FLAG: both processes map the page.

namespace tactooth {
namespace {

/// A time of the monotonic clock, s, as the kernel takes it; the past for a time that is not a number.
timespec timespecAt(double seconds) {
    constexpr double kLongest = 1e9;  // s: fits any time_t
    const double bounded = std::isfinite(seconds) ? std::clamp(seconds, 0.0, kLongest) : 0;
    timespec time{};
    time.tv_sec = static_cast<time_t>(bounded);
    time.tv_nsec = static_cast<long>(1e9 * (bounded - static_cast<double>(time.tv_sec)));
    return time;
}

}  // namespace

void Bell::ring() {
    rings_.fetch_add(1, std::memory_order_acq_rel);
    syscall(SYS_futex, &rings_, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

void Bell::wait(std::uint32_t seen, double until) const {
    if (rings() != seen) return;
    const timespec end = timespecAt(until);
    syscall(SYS_futex, &rings_, FUTEX_WAIT_BITSET, seen, &end, nullptr, FUTEX_BITSET_MATCH_ANY);
}

}  // namespace tactooth
