// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/glide_voice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sound/material_sounds.h"
#include "sound/spectrum.h"

namespace tactooth {
namespace {

using test::averageSpectrum;
using test::characterOf;
using test::decibel;
using test::rms;
using test::steadySound;

DrillSoundState gliding(const char* material, double newtons = 0.5, double speed = 20) {
    DrillSoundState state;
    state.material = characterOf(material);
    state.contactForce = newtons;
    state.slideSpeed = speed;
    return state;
}

double levelOf(const DrillSoundState& state) {
    const double level = rms(steadySound(state, 1));
    return decibel(level * level);
}

bool isSilent(const DrillSoundState& state) {
    return std::ranges::all_of(steadySound(state, 0.3), [](float sample) { return sample == 0; });
}

TEST(GlideVoice, IsSilentAtRestAndInTheAir) {
    EXPECT_TRUE(isSilent(gliding("enamel", 0.5, 0)));
    EXPECT_TRUE(isSilent(gliding("enamel", 0, 20)));
    EXPECT_FALSE(isSilent(gliding("enamel")));
}

TEST(GlideVoice, IsLouderTheFasterAndTheHarderTheToolGlides) {
    const double usual = levelOf(gliding("enamel"));
    EXPECT_GT(levelOf(gliding("enamel", 0.5, 40)), usual + 1);
    EXPECT_GT(levelOf(gliding("enamel", 1.5, 20)), usual + 1);
    EXPECT_LT(levelOf(gliding("enamel", 0.5, 5)), usual - 2);
    EXPECT_NEAR(levelOf(gliding("enamel", 1, 10)), levelOf(gliding("enamel", 0.5, 20)), 1) << "the same power";
}

TEST(GlideVoice, IsHeardInAQuietRoomAndBelowACut) {
    const double scratch = levelOf(gliding("enamel"));
    EXPECT_GT(scratch, -45);
    EXPECT_LT(levelOf(gliding("enamel", 100, 1000)), -27);
    EXPECT_LT(scratch, levelOf(test::cutting("enamel", 3)) - 10);
}

TEST(GlideVoice, SoundsBrightOnEnamelAndDullOnDecay) {
    const auto centre = [](const char* material) {
        return averageSpectrum(steadySound(gliding(material), 2), 4096).centroidHz();
    };
    EXPECT_GT(centre("enamel"), 1.3 * centre("dentin"));
    EXPECT_GT(centre("dentin"), 1.3 * centre("caries"));
}

TEST(GlideVoice, LeavesATurningBurToTheNoiseOfCutting) {
    DrillSoundState glides = test::spinning(300000), turns = glides;
    glides.contactForce = 0.5;
    glides.slideSpeed = 20;
    EXPECT_EQ(steadySound(glides, 0.3), steadySound(turns, 0.3));
}

TEST(GlideVoice, BeginsAndEndsWithoutAClick) {
    const std::vector<float> steady = steadySound(gliding("enamel"), 1);
    DrillSynthesiser synthesiser;
    const std::vector<float> onAndOff = test::renderDrill(
        synthesiser, 2, [](double time) { return gliding("enamel", 0.5, std::fmod(time, 0.2) < 0.1 ? 20 : 0); });
    EXPECT_LT(test::largestJump(onAndOff), 1.3F * test::largestJump(steady));
}

TEST(GlideVoice, HoldsWhatIsNotFiniteForNothing) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(isSilent(gliding("enamel", kNan, 20)));
    EXPECT_TRUE(isSilent(gliding("enamel", 0.5, kNan)));
    EXPECT_TRUE(isSilent(gliding("enamel", -1, 20)));
}

}  // namespace
}  // namespace tactooth
