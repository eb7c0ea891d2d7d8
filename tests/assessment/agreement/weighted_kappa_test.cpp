// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/weighted_kappa.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assessment/agreement/seeded_random.h"

namespace tactooth {
namespace {

std::vector<LevelPair> somePairs(std::uint64_t seed, std::size_t count, std::size_t levels, std::uint64_t noise) {
    SeededRandom random(seed);
    std::vector<LevelPair> pairs;
    for (std::size_t i = 0; i < count; ++i) {
        const auto first = static_cast<std::size_t>(random.below(levels));
        const auto second = std::min<std::size_t>(levels - 1, first + random.below(noise));
        pairs.push_back({first, second});
    }
    return pairs;
}

TEST(WeightedKappa, IsThatOfATableComputedByHand) {
    // Two levels, 20 5 / 10 15: seen 0.7, by chance 0.5.
    ConfusionMatrix two(2);
    for (int i = 0; i < 20; ++i) two.add({0, 0});
    for (int i = 0; i < 5; ++i) two.add({0, 1});
    for (int i = 0; i < 10; ++i) two.add({1, 0});
    for (int i = 0; i < 15; ++i) two.add({1, 1});
    EXPECT_EQ(two.total(), 50U);
    EXPECT_NEAR(*weightedKappa(two, KappaWeights::Linear), 0.4, 1e-12);
    EXPECT_NEAR(*weightedKappa(two, KappaWeights::Quadratic), 0.4, 1e-12);
    // Three levels, 2 1 0 / 0 2 1 / 1 0 3: distances seen 4, squared 6; expected sums of distance times
    // frequencies: (3 * 3 + 2 * 3 * 4) + (3 * 3 + 3 * 4) + (2 * 4 * 3 + 4 * 3) = 90, squared 138.
    ConfusionMatrix three(3);
    for (const auto& [first, second] :
         {std::pair(0, 0), {0, 0}, {0, 1}, {1, 1}, {1, 1}, {1, 2}, {2, 0}, {2, 2}, {2, 2}, {2, 2}}) {
        three.add({static_cast<std::size_t>(first), static_cast<std::size_t>(second)});
    }
    EXPECT_NEAR(*weightedKappa(three, KappaWeights::Linear), 1 - 10 * 4.0 / 90, 1e-12);
    EXPECT_NEAR(*weightedKappa(three, KappaWeights::Quadratic), 1 - 10 * 6.0 / 138, 1e-12);
}

TEST(WeightedKappa, WithSquaresIsOneLessMeanSquareOverVariances) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const auto pairs = somePairs(seed, 40, 4, 3);
        const auto n = static_cast<double>(pairs.size());
        double first = 0, second = 0, square = 0, spread = 0;
        for (const auto& each : pairs) {
            first += static_cast<double>(each.first) / n;
            second += static_cast<double>(each.second) / n;
        }
        for (const auto& each : pairs) {
            const auto a = static_cast<double>(each.first), b = static_cast<double>(each.second);
            square += (a - b) * (a - b) / n;
            spread += ((a - first) * (a - first) + (b - second) * (b - second)) / n;
        }
        const auto kappa = kappaOf(pairs, 4, KappaWeights::Quadratic);
        ASSERT_TRUE(kappa);
        EXPECT_NEAR(kappa->value, 1 - square / (spread + (first - second) * (first - second)), 1e-12);
        ASSERT_TRUE(kappa->interval);
        EXPECT_LT(kappa->interval->low, kappa->value);
        EXPECT_GT(kappa->interval->high, kappa->value);
    }
}

TEST(WeightedKappa, HasTheSameIntervalEachTimeAndANarrowerOneForMoreWorks) {
    const auto few = kappaOf(somePairs(7, 20, 4, 3), 4, KappaWeights::Linear);
    const auto again = kappaOf(somePairs(7, 20, 4, 3), 4, KappaWeights::Linear);
    const auto many = kappaOf(somePairs(7, 500, 4, 3), 4, KappaWeights::Linear);
    ASSERT_TRUE(few && again && many && few->interval && many->interval);
    EXPECT_EQ(few->interval, again->interval);
    EXPECT_LT(many->interval->high - many->interval->low, (few->interval->high - few->interval->low) / 3);
}

TEST(WeightedKappa, IsOneForRatersWhoAgreeAndNothingForOneLevel) {
    EXPECT_EQ(kappaOf(somePairs(1, 30, 4, 1), 4, KappaWeights::Quadratic)->value, 1);
    EXPECT_FALSE(kappaOf(std::vector<LevelPair>(10, {2, 2}), 4, KappaWeights::Quadratic));
    EXPECT_FALSE(kappaOf({}, 4, KappaWeights::Quadratic));
    EXPECT_FALSE(kappaOf(somePairs(1, 30, 1, 1), 1, KappaWeights::Linear));
    // One work alone cannot be drawn in two ways; two that differ mostly can.
    EXPECT_FALSE(kappaOf(std::vector<LevelPair>{{0, 1}}, 2, KappaWeights::Linear)->interval);
}

}  // namespace
}  // namespace tactooth
