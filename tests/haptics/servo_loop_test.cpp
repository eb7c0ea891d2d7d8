// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/servo_loop.h"

#include <gtest/gtest.h>

#include <chrono>

// Upper bounds are loose: the test machine may be busy.

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

template <class Condition>
bool within(std::chrono::milliseconds limit, const Condition& condition) {
    const auto end = Clock::now() + limit;
    while (!condition()) {
        if (Clock::now() > end) return false;
        std::this_thread::sleep_for(1ms);
    }
    return true;
}

TEST(ServoLoop, TicksAtItsRateAndNoFaster) {
    const auto start = Clock::now();
    double simulated = 0;
    std::uint64_t ticks = 0;
    {
        ServoLoop loop(1000, [&](double elapsed) { simulated += elapsed; });
        ASSERT_TRUE(within(60s, [&] { return loop.timing().ticks >= 200; }));
        ticks = loop.timing().ticks;
        EXPECT_EQ(loop.rateHz(), 1000);
    }
    const double passed = std::chrono::duration<double>(Clock::now() - start).count();
    EXPECT_LE(static_cast<double>(ticks), 1000 * passed + 1);
    EXPECT_LE(simulated, passed);
    EXPECT_GT(simulated, 0.19);
}

TEST(ServoLoop, MeasuresEachTick) {
    ServoLoop loop(1000, [](double) { std::this_thread::sleep_for(200us); });
    ASSERT_TRUE(within(60s, [&] { return loop.timing().ticks >= 50; }));
    EXPECT_GE(loop.timing().tick.total(), 50U);
    EXPECT_GE(loop.timing().lateness.total(), 50U);
    EXPECT_GE(loop.timing().tick.quantile(0.0), 190);
}

TEST(ServoLoop, ALateTickIsSkippedAndNotRepeated) {
    const auto start = Clock::now();
    std::atomic<std::uint64_t> ticks{0};
    std::uint64_t missed = 0;
    double longest = 0;
    {
        ServoLoop loop(1000, [&](double elapsed) {
            longest = std::max(longest, elapsed);
            if (++ticks == 5) std::this_thread::sleep_for(30ms);
        });
        ASSERT_TRUE(within(60s, [&] { return ticks >= 40; }));
        missed = loop.timing().missed;
    }
    const double passed = std::chrono::duration<double>(Clock::now() - start).count();
    EXPECT_GT(longest, 0.03);
    EXPECT_GE(missed, 28U);
    EXPECT_LE(static_cast<double>(ticks + missed), 1000 * passed + 1);
}

TEST(ServoLoop, StopsWithinATickOfItsEnd) {
    auto loop = std::make_unique<ServoLoop>(1000, [](double) {});
    ASSERT_TRUE(within(60s, [&] { return loop->timing().ticks >= 3; }));
    const auto start = Clock::now();
    loop.reset();
    EXPECT_LT(Clock::now() - start, 2s);
}

TEST(ServoLoop, EndsCleanlyAtAnyMoment) {
    for (int i = 0; i < 50; ++i) {
        bool running = false;
        bool overlapped = false;
        {
            const ServoLoop loop(4000, [&](double) {
                overlapped |= running;
                running = true;
                std::this_thread::sleep_for(50us);
                running = false;
            });
            std::this_thread::sleep_for(i * 20us);
        }
        EXPECT_FALSE(running) << "the loop ended in the middle of a tick";
        EXPECT_FALSE(overlapped);
    }
}

}  // namespace
}  // namespace tactooth
