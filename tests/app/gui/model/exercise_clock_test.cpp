// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/exercise_clock.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(ExerciseClock, CountsWhatTheSessionCounts) {
    const ExerciseClock clock;
    EXPECT_DOUBLE_EQ(clock.seconds(7), 7);
    EXPECT_FALSE(clock.isStopped());
}

TEST(ExerciseClock, StandsStillUntilItGoesOn) {
    ExerciseClock clock;
    clock.stop(10);
    EXPECT_TRUE(clock.isStopped());
    EXPECT_DOUBLE_EQ(clock.seconds(25), 10);
    clock.goOn(25);
    EXPECT_FALSE(clock.isStopped());
    EXPECT_DOUBLE_EQ(clock.seconds(25), 10);
    EXPECT_DOUBLE_EQ(clock.seconds(28), 13);
}

TEST(ExerciseClock, AddsUpWhatDoesNotCount) {
    ExerciseClock clock;
    clock.stop(10);
    clock.goOn(25);
    clock.stop(28);
    clock.goOn(100);
    EXPECT_DOUBLE_EQ(clock.seconds(101), 14);
}

TEST(ExerciseClock, GoesOnOnlyFromAStop) {
    ExerciseClock clock;
    clock.goOn(25);
    EXPECT_DOUBLE_EQ(clock.seconds(26), 26);
}

TEST(ExerciseClock, CountsAnewForAnotherTooth) {
    ExerciseClock clock;
    clock.stop(10);
    clock.goOn(25);
    clock.stop(26);
    clock.restart();
    EXPECT_FALSE(clock.isStopped());
    EXPECT_DOUBLE_EQ(clock.seconds(3), 3);
}

}  // namespace
}  // namespace tactooth
