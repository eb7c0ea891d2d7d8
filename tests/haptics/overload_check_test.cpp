// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/overload_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

namespace tactooth {
namespace {

using Clock = std::chrono::steady_clock;

/// Timing of `count` ticks of `microseconds`, of which each `every`-th took `slow`.
void fill(ServoTiming& timing, int count, double microseconds, int every, double slow) {
    for (int i = 1; i <= count; ++i) timing.tick.add(i % every == 0 ? slow : microseconds);
    timing.ticks = static_cast<std::uint64_t>(count);
}

TEST(SceneLoad, AFastSceneGivesNoAdvice) {
    ServoTiming timing;
    fill(timing, 5000, 60, 500, 900);  // one in five hundred belongs to the system
    EXPECT_FALSE(isOverloaded(timing, 1000));
    EXPECT_EQ(overloadAdvice(timing, 1000), "");
}

TEST(SceneLoad, ASlowSceneGivesAdvice) {
    ServoTiming timing;
    fill(timing, 5000, 300, 50, 640);
    EXPECT_TRUE(isOverloaded(timing, 1000));
    EXPECT_THAT(overloadAdvice(timing, 1000), ::testing::AllOf(::testing::HasSubstr("of the 1000 us that there are"),
                                                               ::testing::HasSubstr("'tactooth simplify'")));
}

TEST(SceneLoad, TheSameTicksOverloadAHigherRate) {
    ServoTiming timing;
    fill(timing, 5000, 200, 50, 300);
    EXPECT_FALSE(isOverloaded(timing, 1000));
    EXPECT_TRUE(isOverloaded(timing, 4000));
}

TEST(SceneLoad, FewTicksGiveNoAdvice) {
    ServoTiming timing;
    fill(timing, 900, 900, 2, 900);
    EXPECT_FALSE(isOverloaded(timing, 1000));
}

TEST(SceneLoad, FindsALoopWithSlowTicks) {
    constexpr double kRate = 4000;
    const ServoLoop loop(kRate, [](double) {
        const auto end = Clock::now() + std::chrono::microseconds(200);
        while (Clock::now() < end) {
        }
    });
    const auto limit = Clock::now() + std::chrono::seconds(60);
    while (loop.timing().ticks < 1000 && Clock::now() < limit) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_THAT(overloadAdvice(loop.timing(), kRate), ::testing::HasSubstr("The scene is heavy"));
}

}  // namespace
}  // namespace tactooth
