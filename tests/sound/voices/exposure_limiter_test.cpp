// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/exposure_limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

std::vector<float> sine(double hz, double amplitude, double seconds) {
    std::vector<float> samples(static_cast<std::size_t>(seconds * kSoundRate));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double turns = hz * static_cast<double>(i) / kSoundRate;
        samples[i] = static_cast<float>(amplitude * std::sin(2.0 * std::numbers::pi * turns));
    }
    return samples;
}

// The curve at a frequency, dB.
double weightAt(double hz) {
    AWeighting weighting;
    std::vector<float> samples = sine(hz, 1.0, 1.0);
    for (float& sample : samples) sample = weighting.process(sample);
    return 20.0 * std::log10(rms(std::span(samples).last(kSoundRate / 2)) * std::numbers::sqrt2);
}

TEST(AWeighting, IsTheCurveOfTheStandard) {
    EXPECT_NEAR(weightAt(100.0), -19.1, 0.3);
    EXPECT_NEAR(weightAt(500.0), -3.2, 0.3);
    EXPECT_NEAR(weightAt(1000.0), 0.0, 0.1);
    EXPECT_NEAR(weightAt(2500.0), 1.3, 0.3);
    EXPECT_NEAR(weightAt(5000.0), 0.5, 0.4);
    EXPECT_NEAR(weightAt(10000.0), -2.5, 0.1);
}

// Mean level of each second of the output, dB of full scale.
std::vector<double> levelsUnderTheLimit(const std::vector<float>& second, int seconds) {
    ExposureLimiter cap;
    std::vector<double> levels;
    for (int i = 0; i < seconds; ++i) {
        std::vector<float> heard = second;
        for (std::size_t start = 0; start < heard.size(); start += kSoundBlock) {
            const auto block = std::span(heard).subspan(start, kSoundBlock);
            Ramp gain = cap.gainFor(block);
            for (float& sample : block) sample *= gain.next();
        }
        levels.push_back(20.0 * std::log10(rms(heard) * std::numbers::sqrt2));
    }
    return levels;
}

TEST(ExposureLimiter, LeavesAlonePreciselyWhatIsBelowIt) {
    ExposureLimiter cap;
    const std::vector<float> quiet = sine(1000.0, 0.16, 1.0);  // -15.9 dB
    for (int second = 0; second < 200; ++second) {
        for (std::size_t start = 0; start < quiet.size(); start += kSoundBlock)
            ASSERT_TRUE(cap.gainFor(std::span(quiet).subspan(start, kSoundBlock)).isOne());
    }
}

TEST(ExposureLimiter, LetsLoudSecondsPassButNotLoudMinutes) {
    const std::vector<double> levels = levelsUnderTheLimit(sine(1000.0, 0.5, 1.0), 300);  // -6 dB
    EXPECT_NEAR(levels.front(), -6.02, 0.01);
    EXPECT_NEAR(levels.back(), ExposureLimiter::kLimitDecibel, 0.1);
    for (std::size_t i = 1; i < levels.size(); ++i) EXPECT_LE(levels[i], levels[i - 1] + 1e-6);
}

TEST(ExposureLimiter, ComesDownSlowerThanAnyoneHears) {
    const std::vector<double> levels = levelsUnderTheLimit(sine(3000.0, 0.9, 1.0), 60);
    for (std::size_t i = 1; i < levels.size(); ++i) EXPECT_GT(levels[i], levels[i - 1] - 1.1);
}

}  // namespace
}  // namespace tactooth
