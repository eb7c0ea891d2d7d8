// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Half a minute of damage for each fuzz target, in the time that other tests leave.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <limits>

#include "fuzz/damaged_seeds.h"

namespace tactooth::test {
namespace {

class LongFuzz : public testing::TestWithParam<FuzzTarget> {};

INSTANTIATE_TEST_SUITE_P(Readers, LongFuzz, testing::ValuesIn(fuzzTargets()), nameOfFuzzTarget);

TEST_P(LongFuzz, HalfAMinuteOfDamageKeepsThePromises) {
    constexpr int kPolite = 10;
    (void)setpriority(PRIO_PROCESS, 0, kPolite);
    constexpr int kLeast = 2001;  // more than the ordinary tests try, however little time the other tests leave
    const int rounds = tryDamagedSeeds(GetParam(), std::numeric_limits<int>::max(), std::chrono::seconds(30), kLeast);
    RecordProperty("rounds", rounds);
    EXPECT_GE(rounds, kLeast);
}

}  // namespace
}  // namespace tactooth::test
