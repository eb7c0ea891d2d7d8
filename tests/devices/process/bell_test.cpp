// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/process/bell.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

#include "devices/base/monotonic_clock.h"

namespace tactooth {
namespace {

constexpr double kLong = 60;  // s: only a broken program waits so long

TEST(Bell, ARingBeforeTheWaitIsNotMissed) {
    Bell bell;
    const std::uint32_t seen = bell.rings();
    bell.ring();
    const double before = monotonicSeconds();
    bell.wait(seen, before + kLong);
    EXPECT_LT(monotonicSeconds(), before + kLong / 2);
    EXPECT_EQ(bell.rings(), seen + 1);
}

TEST(Bell, WakesAThreadThatSleeps) {
    Bell bell, answer;
    std::jthread other([&] {
        for (std::uint32_t i = 0; i < 1000; ++i) {
            while (bell.rings() == i) bell.wait(i, monotonicSeconds() + kLong);
            answer.ring();
        }
    });
    const double before = monotonicSeconds();
    for (std::uint32_t i = 0; i < 1000; ++i) {
        bell.ring();
        while (answer.rings() == i) answer.wait(i, monotonicSeconds() + kLong);
    }
    EXPECT_LT(monotonicSeconds(), before + kLong);
}

TEST(Bell, WaitsUntilATimeAtMost) {
    const Bell bell;
    const double until = monotonicSeconds() + 0.02;
    while (monotonicSeconds() < until) bell.wait(0, until);
    EXPECT_GE(monotonicSeconds(), until);
    for (const double past : {0.0, -1.0, std::nan("")}) bell.wait(0, past);  // return at once
}

TEST(Bell, CountsOnAfterItsLastNumber) {
    Bell bell;
    reinterpret_cast<std::atomic<std::uint32_t>&>(bell).store(0xFFFFFFFF);
    const std::uint32_t seen = bell.rings();
    bell.ring();
    EXPECT_EQ(bell.rings(), 0U);
    bell.wait(seen, monotonicSeconds() + kLong);
}

}  // namespace
}  // namespace tactooth
