// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/monotonic_clock.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

using namespace std::chrono_literals;

double systemSeconds() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

TEST(MonotonicClock, IsTheSystemsOne) {
    const double before = systemSeconds();
    const double seen = monotonicSeconds();
    const double after = systemSeconds();
    EXPECT_GE(seen, before - 1e-6);
    EXPECT_LE(seen, after + 1e-6);
}

TEST(MonotonicClock, AMomentIsAsLongFromNowAsAskedFor) {
    const auto before = MonotonicClock::now();
    const auto moment = secondsFromNow(0.25);
    const auto after = MonotonicClock::now();
    EXPECT_GE(moment, before + 250ms);
    EXPECT_LE(moment, after + 250ms);
}

TEST(MonotonicClock, AMomentIsGivenInWholeSecondsAndNanoseconds) {
    const timespec within = timespecOf(MonotonicClock::time_point(7s + 5ns));
    EXPECT_EQ(within.tv_sec, 7);
    EXPECT_EQ(within.tv_nsec, 5);
    const timespec last = timespecOf(MonotonicClock::time_point(7s + 999'999'999ns));
    EXPECT_EQ(last.tv_sec, 7);
    EXPECT_EQ(last.tv_nsec, 999'999'999);
    const timespec carried = timespecOf(MonotonicClock::time_point(7s + 999'999'999ns) + 1ns);
    EXPECT_EQ(carried.tv_sec, 8);
    EXPECT_EQ(carried.tv_nsec, 0);
}

}  // namespace
}  // namespace tactooth
