// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/files/spectrogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "sound/files/sound_format.h"

namespace tactooth {
namespace {

// `frequencyAt` in Hz for a time in s, amplitude 0.5 on both sides.
template <class Function>
std::vector<float> tone(double seconds, Function frequencyAt) {
    std::vector<float> stereo;
    double turns = 0.0;
    for (int i = 0; i < static_cast<int>(seconds * kSoundRate); ++i) {
        turns += frequencyAt(static_cast<double>(i) / kSoundRate) / kSoundRate;
        const auto sample = static_cast<float>(0.5 * std::sin(2.0 * std::numbers::pi * turns));
        stereo.insert(stereo.end(), {sample, sample});
    }
    return stereo;
}

std::size_t loudestBin(const Spectrogram& spectrogram, std::size_t time) {
    std::size_t best = 0;
    for (std::size_t bin = 1; bin < spectrogram.bins; ++bin)
        if (spectrogram.at(time, bin) > spectrogram.at(time, best)) best = bin;
    return best;
}

double hzOf(const Spectrogram& spectrogram, std::size_t bin) {
    return 0.5 * kSoundRate * static_cast<double>(bin) / static_cast<double>(spectrogram.bins);
}

TEST(Spectrogram, ASineOfHalfOfFullScaleHasMinusSixDecibelsAtItsFrequency) {
    const Spectrogram spectrogram = spectrogramOf(tone(1.0, [](double) { return 6000.0; }), 20);
    EXPECT_EQ(hzOf(spectrogram, loudestBin(spectrogram, 10)), 6000.0);
    EXPECT_NEAR(spectrogram.at(10, loudestBin(spectrogram, 10)), -6.02, 0.05);
    EXPECT_LT(spectrogram.at(10, loudestBin(spectrogram, 10) + 20), -80.0f);
}

TEST(Spectrogram, ARisingToneRises) {
    const Spectrogram spectrogram = spectrogramOf(tone(2.0, [](double t) { return 1000.0 + 5000.0 * t; }), 40);
    for (std::size_t time = 2; time < 38; ++time) {
        const double middle = 2.0 * (static_cast<double>(time) + 0.5) / 40.0;
        EXPECT_NEAR(hzOf(spectrogram, loudestBin(spectrogram, time)), 1000.0 + 5000.0 * middle, 200.0) << time;
    }
}

TEST(Spectrogram, ASingleSampleIsSeenInItsPieceHoweverLongThePiecesAre) {
    std::vector<float> stereo(2 * kSoundRate * 2, 0.0f);
    stereo[2 * 70000] = stereo[2 * 70000 + 1] = 1.0f;  // at 1.458 s
    const Spectrogram spectrogram = spectrogramOf(stereo, 4);
    EXPECT_GT(spectrogram.at(2, 300), -65.0f);
    EXPECT_EQ(spectrogram.at(0, 300), Spectrogram::kSilence);
}

TEST(Spectrogram, ShorterThanAWindowStillHasAllItsColumns) {
    const Spectrogram spectrogram = spectrogramOf(tone(0.005, [](double) { return 5000.0; }), 8);
    EXPECT_EQ(spectrogram.level.size(), 8 * spectrogram.bins);
    EXPECT_NEAR(hzOf(spectrogram, loudestBin(spectrogram, 4)), 5000.0, 200.0);
}

TEST(Spectrogram, IsTheSameOfASoundThatComesInPieces) {
    std::mt19937 random(20261125);
    std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
    for (const std::size_t frames : {1U, 300U, 5000U, 100'000U}) {
        std::vector<float> stereo(2 * frames);
        for (float& sample : stereo) sample = anywhere(random);
        for (const std::size_t times : {1U, 7U, 1100U}) {
            SpectrogramBuilder maker(frames, times);
            for (std::size_t at = 0; at < stereo.size();) {
                const std::size_t count = std::min<std::size_t>(2 * (1 + random() % 400), stereo.size() - at);
                maker.add(std::span<const float>(stereo).subspan(at, count));
                at += count;
            }
            EXPECT_EQ(maker.finish().level, spectrogramOf(stereo, times).level) << frames << ' ' << times;
        }
    }
}

}  // namespace
}  // namespace tactooth
