// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/impact_voice.h"

#include <gtest/gtest.h>

#include <limits>

#include "sound/files/sound_format.h"
#include "sound/material_sounds.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

// The sound of one impact on a material with an instrument at rest.
std::vector<float> tapOn(const char* material, double speed) {
    DrillSynthesiser synthesiser;
    DrillSoundState state;
    state.material = characterOf(material);
    state.contactSpeed = speed;
    (void)renderDrill(synthesiser, 0.2, [&](double) { return state; });
    state.contactCount = 1;
    return renderDrill(synthesiser, 0.5, [&](double) { return state; });
}

// The sound of an explorer's tip that comes free of decay.
std::vector<float> pullOutWith(double force) {
    DrillSynthesiser synthesiser;
    DrillSoundState state;
    state.material = characterOf("caries");
    state.pullOutForce = force;
    (void)renderDrill(synthesiser, 0.2, [&](double) { return state; });
    state.pullOutCount = 1;
    return renderDrill(synthesiser, 0.5, [&](double) { return state; });
}

// What the voice alone makes of `after` when it has known `before`.
std::vector<float> soundOf(const DrillSoundState& before, const DrillSoundState& after) {
    ImpactVoice voice;
    std::vector<float> block(kSoundRate / 10, 0.0f);
    voice.addTo(block, before, 1.0);
    EXPECT_EQ(peak(block), 0.0f);
    voice.addTo(block, after, 1.0);
    return block;
}

TEST(ImpactVoice, EnamelTicksCariesThuds) {
    const double enamel = spectrumOf(tapOn("enamel", 20.0)).centroidHz();
    const double dentin = spectrumOf(tapOn("dentin", 20.0)).centroidHz();
    const double caries = spectrumOf(tapOn("caries", 20.0)).centroidHz();
    EXPECT_GT(enamel, 1.5 * dentin);
    EXPECT_GT(dentin, 1.5 * caries);
}

TEST(ImpactVoice, FasterLandingIsLouder) {
    float last = 0.0f;
    for (const double speed : {1.0, 5.0, 20.0, 50.0, 200.0}) {
        const float loudness = peak(tapOn("enamel", speed));
        EXPECT_GT(loudness, 1.3f * last) << speed << " mm/s";
        last = loudness;
    }
    EXPECT_LT(last, 0.5f);
}

TEST(ImpactVoice, AudibleThenGoneWithinATenthOfASecond) {
    for (const char* material : {"enamel", "dentin", "caries", "pulp"}) {
        const auto sound = tapOn(material, 30.0);
        EXPECT_GT(peak(sound), 0.03f) << material;
        EXPECT_EQ(peak(std::span(sound).last(sound.size() - kSoundRate / 5)), 0.0f) << material;
    }
}

/// Of the sound of a state that stays as it is.
float steadyPeak(const DrillSoundState& state) {
    DrillSynthesiser synthesiser;
    return peak(renderDrill(synthesiser, 0.2, [&](double) { return state; }));
}

TEST(ImpactVoice, CountThatWasAlreadyThereDoesNotKnock) {
    DrillSoundState state;
    state.contactCount = 41;
    state.contactSpeed = 100.0;
    EXPECT_EQ(steadyPeak(state), 0.0f);
}

TEST(ImpactVoice, EachNewCountKnocksOnce) {
    ImpactVoice voice;
    DrillSoundState state;
    state.contactSpeed = 30.0;
    const auto blockPeak = [&] {
        std::vector<float> block(kSoundRate / 10, 0.0f);
        voice.addTo(block, state, 1.0);
        return peak(block);
    };
    EXPECT_EQ(blockPeak(), 0.0f);
    ++state.contactCount;
    const float first = blockPeak();
    EXPECT_GT(first, 0.01f);
    EXPECT_EQ(blockPeak(), 0.0f);
    ++state.contactCount;
    EXPECT_FLOAT_EQ(blockPeak(), first);
}

TEST(ImpactVoice, APullOutOfAStrongerHoldIsLouder) {
    float last = 0.0f;
    for (const double force : {0.05, 0.2, 0.5, 1.0}) {
        const float loudness = peak(pullOutWith(force));
        EXPECT_GT(loudness, 1.2f * last) << force << " N";
        last = loudness;
    }
    EXPECT_GT(peak(pullOutWith(0.2)), 0.01f) << "audible";
    EXPECT_LT(last, 0.6f * peak(tapOn("enamel", 50.0)));
}

TEST(ImpactVoice, APullOutRingsBrightAndShort) {
    const auto sound = pullOutWith(0.3);
    EXPECT_NEAR(spectrumOf(sound).peakHz(1000.0, 20000.0), 5200.0, 50.0);
    EXPECT_GT(spectrumOf(sound).centroidHz(), spectrumOf(tapOn("enamel", 20.0)).centroidHz());
    EXPECT_EQ(peak(std::span(sound).last(sound.size() - kSoundRate / 10)), 0.0f);
}

TEST(ImpactVoice, APullOutThatWasAlreadyCountedDoesNotTick) {
    DrillSoundState state;
    state.pullOutCount = 41;
    state.pullOutForce = 1.0;
    EXPECT_EQ(steadyPeak(state), 0.0f);
}

TEST(ImpactVoice, AForceThatIsNoForceDoesNotTick) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const double force : {nan, infinity, -infinity, -0.5, 0.0}) EXPECT_EQ(peak(pullOutWith(force)), 0.0f) << force;
}

TEST(ImpactVoice, AnImpactSoundsTheSameWhateverWasPulledOutBefore) {
    DrillSoundState before;
    before.material = characterOf("enamel");
    before.contactSpeed = 30.0;
    DrillSoundState after = before;
    ++after.contactCount;
    const std::vector<float> impact = soundOf(before, after);
    EXPECT_GT(peak(impact), 0.01f);
    before.pullOutCount = after.pullOutCount = 7;
    before.pullOutForce = after.pullOutForce = 1.0;
    EXPECT_EQ(soundOf(before, after), impact);
}

TEST(ImpactVoice, AnImpactAndAPullOutAtOnceAreTheSumOfBoth) {
    DrillSoundState before;
    before.material = characterOf("enamel");
    before.contactSpeed = 30.0;
    before.pullOutForce = 0.5;
    DrillSoundState hit = before, pulled = before, both = before;
    hit.contactCount = both.contactCount = 1;
    pulled.pullOutCount = both.pullOutCount = 1;
    const std::vector<float> impact = soundOf(before, hit), pullOut = soundOf(before, pulled);
    const std::vector<float> sum = soundOf(before, both);
    for (std::size_t i = 0; i < sum.size(); ++i) ASSERT_NEAR(sum[i], impact[i] + pullOut[i], 1e-6f) << i;
}

}  // namespace
}  // namespace tactooth
