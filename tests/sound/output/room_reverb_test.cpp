// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/output/room_reverb.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sound/files/sound_format.h"
#include "sound/material_sounds.h"
#include "sound/output/offline_render.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

constexpr double kCut = 2;        // s
constexpr double kWindow = 0.01;  // s

/// A cut in soft decay, whose noise lies at middle frequencies; it ends after kCut.
StereoSamples cutThatEnds(bool room, bool headphones = false) {
    const DrillSoundState cut = cutting("caries", 3.0), still;
    const std::vector<TimedSoundState> track = {{0, cut, {}}, {kCut, cut, {}}, {kCut, still, {}}};
    OfflineSettings settings;
    settings.room = room;
    settings.headphones = headphones;
    return renderOffline(track, kCut + 1.5, settings).value();
}

/// Mean energy from one time to another.
double energy(const StereoSamples& stereo, double from, double to) {
    const auto begin = static_cast<std::size_t>(from * kSoundRate), end = static_cast<std::size_t>(to * kSoundRate);
    double sum = 0;
    for (std::size_t i = 2 * begin; i < 2 * end; ++i) sum += stereo[i] * stereo[i];
    return sum / static_cast<double>(2 * (end - begin));
}

double decibels(double ratio) { return 10 * std::log10(ratio); }

struct Decay {
    double time = 0;   ///< s for 60 dB
    double level = 0;  ///< energy at the end of the cut, as if the decay began there
};

/// Fits a line to the logarithm of the energy, from 5 to 35 dB below the first window as ISO 3382 does (T30).
Decay decayOf(const StereoSamples& stereo) {
    constexpr double kFrom = kCut + 0.03;  // the direct sound has ended
    const double first = decibels(energy(stereo, kFrom, kFrom + kWindow));
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (double t = kFrom; t < kCut + 1.4; t += kWindow) {
        const double level = decibels(energy(stereo, t, t + kWindow));
        if (level > first - 5 || level < first - 35) continue;
        const double x = t + kWindow / 2 - kCut;
        n += 1, sx += x, sy += level, sxx += x * x, sxy += x * level;
    }
    const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    return {-60 / slope, std::pow(10, (sy - slope * sx) / n / 10)};
}

TEST(RoomReverb, WithoutARoomTheSoundEndsWithTheCut) {
    const StereoSamples dry = cutThatEnds(false);
    EXPECT_LT(decibels(energy(dry, kCut + 0.1, kCut + 0.2) / energy(dry, 1, kCut)), -55);
}

TEST(RoomReverb, TheRoomDecaysInItsTime) {
    for (const bool headphones : {false, true}) {
        EXPECT_NEAR(decayOf(cutThatEnds(true, headphones)).time, RoomReverb::kReverberationTime, 0.05) << headphones;
    }
}

TEST(RoomReverb, ItsLevelIsThatOfTheDiffuseField) {
    const double direct = energy(cutThatEnds(false), 1, kCut) * RoomReverb::kSourceGain * RoomReverb::kSourceGain;
    const double both = energy(cutThatEnds(true), 1, kCut);
    EXPECT_NEAR(decibels((both - direct) / direct), RoomReverb::kLevel, 0.7);
}

TEST(RoomReverb, TheWholeIsAsLoudAsWithoutIt) {
    EXPECT_NEAR(decibels(energy(cutThatEnds(true), 1, kCut) / energy(cutThatEnds(false), 1, kCut)), 0, 0.3);
}

TEST(RoomReverb, ItEndsInSilenceAndNeverClips) {
    const StereoSamples sound = cutThatEnds(true);
    EXPECT_LT(peak(sound), 1.0f);
    EXPECT_EQ(energy(sound, kCut + 1.3, kCut + 1.5), 0);
    EXPECT_GT(energy(sound, kCut + 0.05, kCut + 0.1), 0);
}

}  // namespace
}  // namespace tactooth
