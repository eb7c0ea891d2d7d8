// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/peak_limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "spectrum.h"

namespace tactooth {
namespace {

TEST(PeakLimiter, BelowTheCeilingOnlyDelaysBitForBit) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> value(-0.88f, 0.88f);
    std::vector<float> input(5000);
    for (float& sample : input) sample = value(random);
    std::vector<float> output = input;
    PeakLimiter().process(output);
    for (std::size_t i = PeakLimiter::kDelay; i < input.size(); ++i)
        ASSERT_EQ(output[i], input[i - PeakLimiter::kDelay]);
}

TEST(PeakLimiter, NoPeakPassesHoweverSudden) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> value(-1.0f, 1.0f);
    std::vector<float> samples(200000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const float burst = (i / 777) % 3 == 0 ? 12.0f : 0.5f;
        samples[i] = burst * value(random);
    }
    samples[1000] = 1e6f;
    PeakLimiter().process(samples);
    EXPECT_LE(test::peak(samples), PeakLimiter::kCeiling * 1.00001f);
}

TEST(PeakLimiter, GainComesBackToOneAfterAPeak) {
    std::vector<float> samples(48000, 0.5f);
    samples[100] = 4.0f;
    PeakLimiter().process(samples);
    EXPECT_LT(samples[130], 0.45f);
    EXPECT_EQ(samples.back(), 0.5f);
}

}  // namespace
}  // namespace tactooth
