// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The fuzz targets as ordinary tests: over their corpora and over seeded damage to them.
#include <gtest/gtest.h>

#include <algorithm>

#include "fuzz/damaged_seeds.h"

namespace tactooth::test {
namespace {

class Fuzz : public testing::TestWithParam<FuzzTarget> {};

INSTANTIATE_TEST_SUITE_P(Readers, Fuzz, testing::ValuesIn(fuzzTargets()), nameOfFuzzTarget);

TEST_P(Fuzz, TheCorpusHoldsGoodAndBadFiles) {
    const std::vector<std::string> seeds = seedsOf(GetParam());
    const auto accepted =
        std::count_if(seeds.begin(), seeds.end(), [](const std::string& seed) { return tryTarget(GetParam(), seed); });
    EXPECT_GE(accepted, 2);
    EXPECT_GE(static_cast<std::ptrdiff_t>(seeds.size()) - accepted, 1);
}

TEST_P(Fuzz, EveryBeginningOfASeedKeepsThePromises) {
    constexpr std::size_t kBeginnings = 200;
    for (const std::string& seed : seedsOf(GetParam())) {
        for (std::size_t length = 0; length < seed.size(); length += 1 + seed.size() / kBeginnings) {
            (void)tryTarget(GetParam(), seed.substr(0, length));
        }
    }
}

TEST_P(Fuzz, DamagedSeedsKeepThePromises) {
    constexpr int kRounds = 2000;
    EXPECT_EQ(tryDamagedSeeds(GetParam(), kRounds, std::chrono::minutes(4), kRounds), kRounds);
}

}  // namespace
}  // namespace tactooth::test
