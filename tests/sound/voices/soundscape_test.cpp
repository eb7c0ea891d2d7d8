// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/soundscape.h"

#include <gtest/gtest.h>

#include <limits>

#include "spectrum.h"
#include "voices/rendered_sound.h"

namespace tactooth {
namespace {

using namespace test;

TEST(Soundscape, TheDrillAloneIsTheDrillSynthesisersSound) {
    Soundscape soundscape(4);
    DrillSynthesiser alone(4);
    const auto sounds = rendered(soundscape, cutting("dentin", 3.0), 1.0);
    EXPECT_EQ(sounds[0], renderDrill(alone, 1.0, [](double) { return cutting("dentin", 3.0); }));
    EXPECT_EQ(peak(sounds[1]), 0.0f);
    EXPECT_EQ(peak(sounds[2]), 0.0f);
}

TEST(Soundscape, AllTogetherNeverReachFullScale) {
    Soundscape soundscape;
    const auto sounds = rendered(soundscape, everythingOn(), 5.0);
    EXPECT_LT(peak(sounds[0]) + peak(sounds[1]) + peak(sounds[2]), 1.0f);
    EXPECT_GT(rms(sounds[1]), 0.004);
    EXPECT_GT(rms(sounds[2]), 0.006);
}

TEST(Soundscape, EnvironmentVolumeActsOnSprayAndSuctionAlone) {
    Soundscape soundscape;
    soundscape.setMixer({.environment = 0.0});
    const auto sounds = rendered(soundscape, everythingOn(), 1.0);
    EXPECT_GT(rms(sounds[0]), 0.1);
    EXPECT_EQ(peak(sounds[1]), 0.0f);
    EXPECT_EQ(peak(sounds[2]), 0.0f);
}

TEST(Soundscape, MutedIsDigitalSilence) {
    Soundscape soundscape;
    soundscape.setMixer({.muted = true});
    for (const auto& sound : rendered(soundscape, everythingOn(), 0.5)) EXPECT_EQ(peak(sound), 0.0f);
}

TEST(Soundscape, NonsenseStaysFinite) {
    Soundscape soundscape;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    soundscape.setMixer({.motor = nan, .environment = nan});
    DrillSoundState state;
    state.water = nan;
    state.suction = -std::numeric_limits<double>::infinity();
    state.removalPower = nan;
    for (const auto& sound : rendered(soundscape, state, 0.5)) EXPECT_LE(peak(sound), 1.0f);
}

}  // namespace
}  // namespace tactooth
