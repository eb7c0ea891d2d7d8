// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/soundscape.h"

#include <gtest/gtest.h>

#include <limits>

#include "sound/material_sounds.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

// The sound of each source.
std::array<std::vector<float>, kSoundSources> rendered(Soundscape& soundscape, const DrillSoundState& state,
                                                       double seconds) {
    std::array<std::vector<float>, kSoundSources> sounds;
    SoundBlock block;
    for (int i = 0; i < static_cast<int>(seconds * kSoundRate) / kSoundBlock; ++i) {
        soundscape.render(state, block);
        for (std::size_t place = 0; place < kSoundSources; ++place)
            sounds[place].insert(sounds[place].end(), block[place].begin(), block[place].end());
    }
    return sounds;
}

DrillSoundState everythingOn() {
    DrillSoundState state = cutting("enamel", 1000.0, 500000.0);
    state.load = state.water = state.suction = 1.0;
    return state;
}

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

TEST(Soundscape, FullPowerForMinutesIsTurnedDown) {
    Soundscape soundscape;
    const double atFirst = rms(rendered(soundscape, everythingOn(), 2.0)[0]);
    for (int i = 0; i < 10; ++i) (void)rendered(soundscape, everythingOn(), 20.0);
    EXPECT_LT(rms(rendered(soundscape, everythingOn(), 2.0)[0]), 0.8 * atFirst);
}

TEST(Soundscape, AnOrdinaryCutGoesOnForMinutesAsLoudAsItBegan) {
    for (const char* material : {"enamel", "dentin", "caries"}) {
        Soundscape soundscape;
        const DrillSoundState state = cutting(material, 4.0, 320000.0);
        (void)rendered(soundscape, state, 1.0);
        const double atFirst = rms(rendered(soundscape, state, 2.0)[0]);
        (void)rendered(soundscape, state, 180.0);
        EXPECT_NEAR(rms(rendered(soundscape, state, 2.0)[0]), atFirst, 0.02 * atFirst) << material;
    }
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
