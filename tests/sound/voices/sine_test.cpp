// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/sine.h"

#include <gtest/gtest.h>

#include <numbers>

namespace tactooth {
namespace {

TEST(Sine, MatchesTheLibraryOverTheWholeTurn) {
    for (int i = 0; i < 100000; ++i) {
        const double turns = i / 100000.0;
        ASSERT_NEAR(sineOfTurns(turns), std::sin(2.0 * std::numbers::pi * turns), 1.2e-7) << turns;
    }
}

TEST(Phase, StaysWithinATurn) {
    Phase phase;
    for (int i = 0; i < 1000; ++i) {
        const double turns = phase.advance(0.377);
        ASSERT_GE(turns, 0.0);
        ASSERT_LT(turns, 1.0);
    }
}

}  // namespace
}  // namespace tactooth
