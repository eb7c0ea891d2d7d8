// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/files/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "sound/files/sound_format.h"
#include "sound/voices/loop_player.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

std::vector<float> sine(double hz, double seconds, double rate = kSoundRate) {
    std::vector<float> samples(static_cast<std::size_t>(seconds * rate));
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = static_cast<float>(0.3 * std::sin(2.0 * std::numbers::pi * hz * static_cast<double>(i) / rate));
    return samples;
}

std::vector<float> noise(double seconds) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(-0.4f, 0.4f);
    std::vector<float> samples(static_cast<std::size_t>(seconds * kSoundRate));
    for (float& sample : samples) sample = value(random);
    return samples;
}

Recording recorded(const std::vector<float>& samples, double rate = kSoundRate) {
    auto recording = Recording::make(samples, rate, "test");
    EXPECT_TRUE(recording) << recording.error().message();
    return std::move(*recording);
}

std::vector<float> played(const Recording& recording, double seconds, double pitch) {
    LoopPlayer player;
    std::vector<float> samples(static_cast<std::size_t>(seconds * kSoundRate));
    for (float& sample : samples) sample = player.next(recording, pitch);
    return samples;
}

std::string refusal(const std::vector<float>& samples, double rate = kSoundRate) {
    const auto recording = Recording::make(samples, rate, "mine.wav");
    return recording ? "accepted" : recording.error().message();
}

TEST(Recording, ToneGoesOnInPhaseWhereTheLoopCloses) {
    for (const double hz : {431.7, 1234.5, 6789.0}) {
        const Recording recording = recorded(sine(hz, 0.7));
        const auto samples = played(recording, 5.0, 1.0);
        const double amplitude = std::numbers::sqrt2;
        const double steepest = amplitude * 2.0 * std::numbers::pi * hz / kSoundRate;
        EXPECT_LT(largestJump(samples), 1.05 * steepest) << hz;
        const Spectrum spectrum = averageSpectrum(samples, 4096);
        EXPECT_NEAR(spectrum.peakHz(0.9 * hz, 1.1 * hz), hz, 2.0);
        EXPECT_LT(decibel(spectrum.bandPower(hz + 400.0, 24000.0) / spectrum.peakPower(0.9 * hz, 1.1 * hz)), -70.0)
            << hz;
    }
}

TEST(Recording, NoiseIsAsLoudAtTheSeamAsElsewhere) {
    const Recording recording = recorded(noise(1.0));
    const auto samples = played(recording, 2.0, 1.0);
    for (std::size_t start = 0; start + 2400 <= samples.size(); start += 2400)
        EXPECT_NEAR(rms(std::span(samples).subspan(start, 2400)), 1.0, 0.12) << start;
}

TEST(Recording, PitchFollowsWhateverTheRateOfTheFile) {
    for (const double rate : {8000.0, 44100.0, 96000.0}) {
        const Recording recording = recorded(sine(1000.0, 1.0, rate), rate);
        for (const double pitch : {0.25, 1.0, 1.7, 3.0})
            EXPECT_NEAR(averageSpectrum(played(recording, 1.0, pitch), 16384).peakHz(100.0, 20000.0), 1000.0 * pitch,
                        2.0)
                << rate << " Hz, " << pitch << " times";
    }
}

TEST(Recording, NothingFoldsBackAndNothingMirrorsAtAnyPitch) {
    const Recording recording = recorded(sine(9000.0, 1.0));
    for (const double pitch : {0.2, 0.37, 0.9, 1.1, 1.9, 2.3, 2.6}) {
        Spectrum spectrum = averageSpectrum(played(recording, 1.0, pitch), 8192);
        for (std::size_t i = 0; i < spectrum.power.size(); ++i)
            if (std::abs(spectrum.hz(i) - 9000.0 * pitch) < 500.0) spectrum.power[i] = 0.0;
        constexpr double kOriginal = 2.0;  // power of a sine with the root mean square 1
        EXPECT_LT(decibel(spectrum.peakPower(0.0, 24000.0) / kOriginal), -75.0) << pitch;
    }
}

TEST(Recording, WhatWouldBeTooHighToHearIsGoneInsteadOfFolded) {
    const Recording recording = recorded(sine(9000.0, 1.0));
    EXPECT_LT(rms(played(recording, 0.5, 4.0)), 1e-3);
}

TEST(Recording, AChangeOfPitchThroughAllLevelsDoesNotClick) {
    const Recording recording = recorded(sine(700.0, 1.0));
    LoopPlayer player;
    std::vector<float> samples(2 * kSoundRate);
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = player.next(recording, 8.0 * static_cast<double>(i) / static_cast<double>(samples.size()));
    EXPECT_LT(largestJump(samples), 1.05 * std::numbers::sqrt2 * 2.0 * std::numbers::pi * 5600.0 / kSoundRate);
}

TEST(Recording, LevelAndOffsetOfTheFileDoNotMatter) {
    std::vector<float> samples = sine(1000.0, 0.5);
    for (float& sample : samples) sample = 0.01f * sample + 0.5f;
    EXPECT_NEAR(rms(played(recorded(samples), 1.0, 1.0)), 1.0, 0.01);
}

TEST(Recording, RefusesWhatCannotBeALoop) {
    EXPECT_EQ(refusal(sine(1000.0, 0.02)),
              "mine.wav: the recording lasts 0.02 s, but a loop needs 0.05 to 30 s; cut out a steady piece.");
    EXPECT_NE(refusal(sine(1000.0, 31.0)).find("lasts 31.00 s"), std::string::npos);
    EXPECT_NE(refusal(sine(1000.0, 1.0), 0.0).find("has 0 samples a second"), std::string::npos);
    EXPECT_NE(refusal(sine(1000.0, 1.0), 1e9).find("samples a second, but 4000 to 192000"), std::string::npos);
    EXPECT_NE(refusal(std::vector<float>(48000, 0.25f)).find("is silent"), std::string::npos);
    std::vector<float> broken = sine(1000.0, 1.0);
    broken[99] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(refusal(broken).find("sample 100 is not a finite number"), std::string::npos);
    EXPECT_NE(refusal(std::vector<float>(48000, 3e38f)).find("mine.wav"), std::string::npos);
}

}  // namespace
}  // namespace tactooth
