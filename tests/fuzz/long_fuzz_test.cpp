// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A minute of damage for each fuzz target.
#include <gtest/gtest.h>

#include <limits>

#include "fuzz/damaged_seeds.h"

namespace tactooth::test {
namespace {

class LongFuzz : public testing::TestWithParam<FuzzTarget> {};

INSTANTIATE_TEST_SUITE_P(Readers, LongFuzz, testing::ValuesIn(fuzzTargets()), nameOfFuzzTarget);

TEST_P(LongFuzz, AMinuteOfDamageKeepsThePromises) {
    const int rounds = tryDamagedSeeds(GetParam(), std::numeric_limits<int>::max(), std::chrono::minutes(1));
    RecordProperty("rounds", rounds);
    EXPECT_GT(rounds, 5000);
}

}  // namespace
}  // namespace tactooth::test
