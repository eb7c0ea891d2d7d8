// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/movement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tactooth {
namespace {

constexpr double kRate = 100;

std::vector<double> sampled(double begin, double end, double rate, double (*function)(double)) {
    std::vector<double> samples;
    for (int i = 0; begin + i / rate < end - 1e-9; ++i) samples.push_back(function(begin + i / rate));
    return samples;
}

double wave(double frequency, double time) { return std::sin(2 * std::numbers::pi * frequency * time); }

/// The bell-shaped speed for which the authors of both measures give the values.
const std::vector<double> kBell = sampled(-1, 1, kRate, [](double t) { return std::exp(-5 * t * t); });

TEST(Movement, SmoothnessOfABellIsThePublishedOne) {
    EXPECT_NEAR(spectralArcLength(kBell, kRate).value(), -1.41403, 5e-6);
    EXPECT_NEAR(logDimensionlessJerk(kBell, kRate).value(), -5.81636, 5e-6);
}

TEST(Movement, SmoothnessDoesNotDependOnTheUnit) {
    std::vector<double> larger = kBell;
    for (double& each : larger) each *= 1000;
    EXPECT_NEAR(*spectralArcLength(larger, kRate), *spectralArcLength(kBell, kRate), 1e-9);
    EXPECT_NEAR(*logDimensionlessJerk(larger, kRate), *logDimensionlessJerk(kBell, kRate), 1e-9);
}

TEST(Movement, ATremblingOrBrokenMovementIsLessSmooth) {
    std::vector<double> trembling = kBell, broken = kBell;
    for (std::size_t i = 0; i < trembling.size(); ++i) {
        trembling[i] += 0.1 * wave(8, static_cast<double>(i) / kRate);
        broken[i] *= std::abs(wave(1.5, static_cast<double>(i) / kRate));
    }
    for (const auto& worse : {trembling, broken}) {
        EXPECT_LT(*spectralArcLength(worse, kRate), *spectralArcLength(kBell, kRate) - 0.1);
        EXPECT_LT(*logDimensionlessJerk(worse, kRate), *logDimensionlessJerk(kBell, kRate) - 0.5);
    }
}

TEST(Movement, WithoutMovementThereIsNoSmoothness) {
    for (const std::vector<double>& still : {std::vector<double>(), {1, 2, 1}, std::vector<double>(100, 0.0)}) {
        EXPECT_FALSE(spectralArcLength(still, kRate));
        EXPECT_FALSE(logDimensionlessJerk(still, kRate));
        EXPECT_FALSE(frequency95(still, kRate));
    }
}

TEST(Movement, TheFrequencyBelowWhichThePowerLiesIsThatOfAWave) {
    const auto slow = sampled(0, 8, kRate, [](double t) { return 5 + wave(3, t); });
    EXPECT_NEAR(*frequency95(slow, kRate), 3, 0.2);
    // 90 % of the power at 2 Hz and 10 % at 12 Hz: the second one is needed.
    const auto both = sampled(0, 8, kRate, [](double t) { return 3 * wave(2, t) + wave(12, t); });
    EXPECT_NEAR(*frequency95(both, kRate), 12, 0.2);
    // 97 % at 2 Hz.
    const auto mostly = sampled(0, 8, kRate, [](double t) { return 6 * wave(2, t) + wave(12, t); });
    EXPECT_LT(*frequency95(mostly, kRate), 4);
}

TEST(Movement, TheFilterKeepsWhatAHandMakesWithoutDelay) {
    const auto hand = sampled(0, 3, 1000, [](double t) { return wave(2, t); });
    const std::vector<double> kept = lowPassed(hand, 1000, 20);
    for (std::size_t i = 0; i < hand.size(); ++i) EXPECT_NEAR(kept[i], hand[i], 0.01) << i;
    const auto noise = sampled(0, 3, 1000, [](double t) { return wave(200, t); });
    const std::vector<double> blocked = lowPassed(noise, 1000, 20);
    for (std::size_t i = 200; i < noise.size() - 200; ++i) EXPECT_NEAR(blocked[i], 0, 0.001) << i;
    // Forwards and backwards: half of the amplitude at the cutoff.
    const auto edge = sampled(0, 3, 1000, [](double t) { return wave(20, t); });
    const std::vector<double> halved = lowPassed(edge, 1000, 20);
    for (std::size_t i = 500; i < edge.size() - 500; ++i) EXPECT_NEAR(halved[i], edge[i] / 2, 0.01) << i;
}

TEST(Movement, TheFilterKeepsALineAndFewSamples) {
    const auto line = sampled(0, 1, 1000, [](double t) { return 4 - 7 * t; });
    const std::vector<double> kept = lowPassed(line, 1000, 20);
    for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(kept[i], line[i], 0.01) << i;
    EXPECT_TRUE(lowPassed({}, 1000, 20).empty());
    EXPECT_EQ(lowPassed(std::vector<double>{3}, 1000, 20), std::vector<double>{3});
    EXPECT_EQ(lowPassed(std::vector<double>{3, 3}, 1000, 20).size(), 2U);
}

}  // namespace
}  // namespace tactooth
