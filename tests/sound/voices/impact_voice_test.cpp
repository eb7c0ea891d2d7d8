// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/impact_voice.h"

#include <gtest/gtest.h>

#include "sound/files/sound_format.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace test;

// The sound of one impact on a material with an instrument at rest.
std::vector<float> tapOn(const char* material, double speed) {
    DrillSynthesiser synthesiser;
    DrillSoundState state;
    state.material = soundCharacterOf(material);
    state.contactSpeed = speed;
    (void)renderDrill(synthesiser, 0.2, [&](double) { return state; });
    state.contactCount = 1;
    return renderDrill(synthesiser, 0.5, [&](double) { return state; });
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

TEST(ImpactVoice, CountThatWasAlreadyThereDoesNotKnock) {
    DrillSynthesiser synthesiser;
    DrillSoundState state;
    state.contactCount = 41;
    state.contactSpeed = 100.0;
    EXPECT_EQ(peak(renderDrill(synthesiser, 0.2, [&](double) { return state; })), 0.0f);
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

}  // namespace
}  // namespace tactooth
