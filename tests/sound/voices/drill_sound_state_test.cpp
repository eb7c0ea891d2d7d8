// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/drill_sound_state.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sound/material_sounds.h"

namespace tactooth {
namespace {

TEST(SoundCharacter, HarderSoundsBrighter) {
    EXPECT_GT(test::characterOf("enamel").bandCentreHz, 6000.0);
    EXPECT_LT(test::characterOf("dentin").bandCentreHz, 6000.0);
    EXPECT_LT(test::characterOf("caries").bandCentreHz, 3000.0);
    EXPECT_GT(test::characterOf("enamel").tapHz, test::characterOf("caries").tapHz);
}

TEST(DrillSoundState, SensibleValuesAreLeftAlone) {
    DrillSoundState state;
    state.speedRpm = 312345.0;
    state.pedal = 0.7;
    state.load = 0.3;
    state.removalPower = 4.5;
    state.material = test::characterOf("enamel");
    state.contactSpeed = 12.0;
    state.pullOutCount = 3;
    state.pullOutForce = 0.4;
    state.water = 0.4;
    state.suction = 1.0;
    const DrillSoundState safe = sanitised(state);
    EXPECT_EQ(safe.speedRpm, 312345.0);
    EXPECT_EQ(safe.pedal, 0.7);
    EXPECT_EQ(safe.load, 0.3);
    EXPECT_EQ(safe.removalPower, 4.5);
    EXPECT_EQ(safe.material.bandCentreHz, state.material.bandCentreHz);
    EXPECT_EQ(safe.material.kind, state.material.kind);
    EXPECT_EQ(safe.material.standIn, state.material.standIn);
    EXPECT_EQ(safe.contactSpeed, 12.0);
    EXPECT_EQ(safe.pullOutCount, 3U);
    EXPECT_EQ(safe.pullOutForce, 0.4);
    EXPECT_EQ(safe.water, 0.4);
    EXPECT_EQ(safe.suction, 1.0);
}

TEST(DrillSoundState, ReverseSoundsLikeForward) {
    DrillSoundState state;
    state.speedRpm = -8000.0;
    EXPECT_EQ(sanitised(state).speedRpm, 8000.0);
}

TEST(DrillSoundState, NonsenseBecomesTheNearestSense) {
    DrillSoundState state;
    state.speedRpm = std::nan("");
    state.pedal = 7.0;
    state.load = -1.0;
    state.removalPower = std::nan("");
    state.blades = -3;
    state.pullOutForce = -0.4;
    state.material.bandCentreHz = 1e9;
    state.material.level = std::nan("");
    const DrillSoundState safe = sanitised(state);
    EXPECT_EQ(safe.speedRpm, 0.0);
    EXPECT_EQ(safe.pedal, 1.0);
    EXPECT_EQ(safe.blades, 0);
    EXPECT_EQ(safe.pullOutForce, 0.0);
    EXPECT_EQ(safe.load, 0.0);
    EXPECT_EQ(safe.removalPower, 0.0);
    EXPECT_EQ(safe.material.bandCentreHz, 16000.0);
    EXPECT_EQ(safe.material.level, 0.0);
}

}  // namespace
}  // namespace tactooth
