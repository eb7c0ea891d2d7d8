// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Recordings that replace synthesised sounds.
#include "sound/voices/sound_kit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sound/material_sounds.h"
#include "sound/voices/soundscape.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

RecordedPart tone(double hz, double speedRpm = 0.0) {
    std::vector<float> samples(kSoundRate);
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] =
            static_cast<float>(0.3 * std::sin(2.0 * std::numbers::pi * hz * static_cast<double>(i) / kSoundRate));
    return {std::make_shared<const Recording>(*Recording::make(samples, kSoundRate, "tone")), speedRpm, 1.0};
}

std::vector<float> rendered(Soundscape& soundscape, const DrillSoundState& state, double seconds,
                            std::size_t place = 0) {
    std::vector<float> samples;
    SoundBlock block;
    for (int i = 0; i < static_cast<int>(seconds * kSoundRate) / kSoundBlock; ++i) {
        soundscape.render(state, block);
        samples.insert(samples.end(), block[place].begin(), block[place].end());
    }
    return samples;
}

TEST(SoundKit, TheRecordedDriveFollowsTheSpeed) {
    SoundKit kit;
    kit.motor = tone(6000.0, 360000.0);
    Soundscape soundscape(1, &kit);
    for (const double rpm : {60000.0, 180000.0, 400000.0}) {
        (void)rendered(soundscape, spinning(rpm), 0.2);
        const Spectrum spectrum = averageSpectrum(rendered(soundscape, spinning(rpm), 1.0), 8192);
        EXPECT_NEAR(spectrum.peakHz(100.0, 20000.0), rpm / 60.0, 0.005 * rpm / 60.0) << rpm;
    }
}

TEST(SoundKit, TheRecordedDriveIsSilentAtRestAndQuieterWhenSlower) {
    SoundKit kit;
    kit.motor = tone(6000.0, 360000.0);
    Soundscape soundscape(1, &kit);
    EXPECT_EQ(peak(rendered(soundscape, DrillSoundState{}, 0.2)), 0.0f);
    const double slow = rms(rendered(soundscape, spinning(200000.0), 1.0));
    EXPECT_GT(rms(rendered(soundscape, spinning(400000.0), 1.0)), 1.5 * slow);
}

TEST(SoundKit, ARecordedMaterialReplacesItsOwnNoiseAlone) {
    SoundKit kit;
    kit.cutting.push_back({characterOf("dentin").kind, tone(3000.0)});
    Soundscape soundscape(1, &kit);
    soundscape.setMixer({.motor = 0.0});
    (void)rendered(soundscape, cutting("dentin", 4.0), 0.2);
    const Spectrum dentin = averageSpectrum(rendered(soundscape, cutting("dentin", 4.0), 1.0), 4096);
    EXPECT_GT(dentin.bandPower(2900.0, 3100.0), 1000.0 * dentin.bandPower(3500.0, 20000.0));
    (void)rendered(soundscape, cutting("enamel", 4.0), 0.2);
    const Spectrum enamel = averageSpectrum(rendered(soundscape, cutting("enamel", 4.0), 1.0), 4096);
    EXPECT_LT(enamel.bandPower(2900.0, 3100.0), 0.1 * enamel.bandPower(6000.0, 10000.0));
}

TEST(SoundKit, AMaterialHasItsOwnRecordingElseThatOfItsStandIn) {
    SoundKit kit;
    kit.cutting.push_back({7, tone(3000.0)});
    kit.cutting.push_back({9, tone(2000.0)});
    EXPECT_EQ(kit.cuttingOf({.kind = 9, .standIn = 7}), 1U);
    EXPECT_EQ(kit.cuttingOf({.kind = 8, .standIn = 7}), 0U);
    EXPECT_EQ(kit.cuttingOf({.kind = 8, .standIn = 8}), 2U) << "none";
}

TEST(SoundKit, TheRecordingOfAStandInIsHeard) {
    SoundKit kit;
    kit.cutting.push_back({characterOf("enamel").kind, tone(2000.0)});
    kit.cutting.push_back({characterOf("other").kind, tone(3000.0)});
    Soundscape soundscape(1, &kit);
    soundscape.setMixer({.motor = 0.0});
    DrillSoundState state = cutting("dentin", 4.0);
    state.material.standIn = characterOf("other").kind;
    (void)rendered(soundscape, state, 0.2);
    EXPECT_NEAR(averageSpectrum(rendered(soundscape, state, 1.0), 8192).peakHz(100.0, 20000.0), 3000.0, 10.0);
}

TEST(SoundKit, HasRoomForTheRecordingsOfAllMaterials) {
    SoundKit kit;
    const RecordedPart part = tone(3000.0);
    for (std::size_t i = 0; i < kMaxRecordedMaterials; ++i) kit.cutting.push_back({100 + i, part});
    Soundscape soundscape(1, &kit);
    soundscape.setMixer({.motor = 0.0});
    DrillSoundState state = cutting("dentin", 4.0);
    state.material.kind = kit.cutting.back().kind;
    (void)rendered(soundscape, state, 0.2);
    EXPECT_NEAR(averageSpectrum(rendered(soundscape, state, 1.0), 8192).peakHz(100.0, 20000.0), 3000.0, 10.0);
}

TEST(SoundKit, ARecordedCutGetsLouderWithThePower) {
    SoundKit kit;
    kit.cutting.push_back({characterOf("enamel").kind, tone(3000.0, 300000.0)});
    Soundscape soundscape(1, &kit);
    soundscape.setMixer({.motor = 0.0});
    double last = 0.0;
    for (const double watt : {0.5, 2.0, 8.0}) {
        (void)rendered(soundscape, cutting("enamel", watt), 0.2);
        const double level = rms(rendered(soundscape, cutting("enamel", watt), 0.5));
        EXPECT_GT(level, 1.1 * last) << watt;
        last = level;
    }
}

TEST(SoundKit, WaterAndSuctionAreRecordingsToo) {
    SoundKit kit;
    kit.water = tone(2000.0);
    kit.suction = tone(500.0);
    Soundscape soundscape(1, &kit);
    DrillSoundState state;
    state.water = state.suction = 1.0;
    const auto water = rendered(soundscape, state, 1.0, static_cast<std::size_t>(SoundSource::Mouth));
    const auto suction = rendered(soundscape, state, 1.0, static_cast<std::size_t>(SoundSource::Suction));
    EXPECT_NEAR(averageSpectrum(water, 8192).peakHz(50.0, 20000.0), 2000.0, 5.0);
    EXPECT_NEAR(averageSpectrum(suction, 8192).peakHz(50.0, 20000.0), 500.0, 5.0);
}

TEST(SoundKit, ChangingRecordingsWhileDrillingDoesNotClick) {
    SoundKit kit;
    kit.motor = tone(6000.0, 400000.0);
    Soundscape soundscape;
    const DrillSoundState state = spinning(300000.0);
    const float steady = largestJump(rendered(soundscape, state, 0.5));
    std::vector<float> samples;
    for (const SoundKit* next : {static_cast<const SoundKit*>(&kit), static_cast<const SoundKit*>(nullptr)}) {
        soundscape.setKit(next);
        const auto piece = rendered(soundscape, state, 0.4);
        samples.insert(samples.end(), piece.begin(), piece.end());
        EXPECT_EQ(soundscape.kit(), next);
    }
    const float other = largestJump(std::span(samples).subspan(9600, 4800));
    EXPECT_LT(largestJump(samples), 1.1f * std::max(steady, other));
}

}  // namespace
}  // namespace tactooth
