// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/tick_sound.h"

#include <gtest/gtest.h>

#include "support/materials.h"

namespace tactooth {
namespace {

Tick cuttingTick() {
    Tick tick;
    tick.input.cutting = true;
    tick.input.pedal = 0.8;
    tick.spindle.speedRpm = 350000;
    tick.spindle.load = 0.7;
    tick.spindle.removalPower = 3;
    tick.contact.material = test::kCaries;
    tick.contact.onsets = 4;
    tick.contact.impactSpeed = 12;
    tick.contact.slideSpeed = 15;
    tick.contact.pullOuts = 3;
    tick.contact.pullOutForce = 0.25;
    tick.force.wrench.force = {0, 0, 0.5};
    return tick;
}

TEST(TickSound, HandsOnWhatTheTickFound) {
    const SpindlePreset turbine = spindlePresets().front();
    const DrillSoundState state = soundOf(cuttingTick(), turbine);
    EXPECT_EQ(state.speedRpm, 350000);
    EXPECT_EQ(state.freeSpeedRpm, turbine.freeSpeedRpm);
    EXPECT_EQ(state.pedal, 0.8);
    EXPECT_EQ(state.load, 0.7 / turbine.stallTorque);
    EXPECT_EQ(state.removalPower, 3);
    EXPECT_EQ(state.contactCount, 4U);
    EXPECT_EQ(state.contactSpeed, 12);
    EXPECT_EQ(state.slideSpeed, 15);
    EXPECT_EQ(state.pullOutCount, 3U);
    EXPECT_EQ(state.pullOutForce, 0.25);
    EXPECT_EQ(state.contactForce, 0.5);
}

TEST(TickSound, TakesTheCharacterOfTheMaterialThatHoldsTheTool) {
    const SoundCharacter heard = soundOf(cuttingTick(), spindlePresets().front()).material;
    EXPECT_EQ(heard.bandCentreHz, builtinMaterials()[test::kCaries].numbers.soundCentre);
    EXPECT_NE(heard.bandCentreHz, builtinMaterials()[test::kEnamel].numbers.soundCentre);
}

TEST(TickSound, BandAndLevelAreThoseOfTheTableOfMaterials) {
    MaterialTable materials;
    materials[test::kCaries].soundCentre = 1234;
    materials[test::kCaries].soundBrightness = 0.5;
    const SoundCharacter heard = soundOf(cuttingTick(), spindlePresets().front(), materials).material;
    EXPECT_EQ(heard.bandCentreHz, 1234);
    EXPECT_EQ(heard.level, 0.5);
}

TEST(TickSound, BladesAreHeardAndACoarseDiamondIsGrainier) {
    const auto with = [](const BurEdge& edge) {
        return soundOf(cuttingTick(), spindlePresets().front(), MaterialTable(), edge);
    };
    EXPECT_EQ(with({8, 0}).blades, 8);
    EXPECT_EQ(with({8, 0}).material.graininess, builtinMaterials()[test::kCaries].numbers.soundGraininess);
    EXPECT_EQ(with({0, 30}).blades, 0);
    EXPECT_GT(with({0, 30}).material.graininess, with({8, 0}).material.graininess);
    EXPECT_GT(with({0, 180}).material.graininess, with({0, 30}).material.graininess);
    EXPECT_EQ(with({0, 400}).material.graininess, with({0, 180}).material.graininess);
    EXPECT_LT(with({0, 400}).material.graininess, 1);
}

TEST(TickSound, SprayFollowsThePedalAndSuctionRunsWhileCuttingIsOn) {
    Tick tick = cuttingTick();
    EXPECT_EQ(soundOf(tick, spindlePresets().front()).water, 0.8);
    EXPECT_EQ(soundOf(tick, spindlePresets().front()).suction, 1);
    tick.input.pedal = 0;
    EXPECT_EQ(soundOf(tick, spindlePresets().front()).water, 0);
    EXPECT_EQ(soundOf(tick, spindlePresets().front()).suction, 1);
    tick.input.cutting = false;
    EXPECT_EQ(soundOf(tick, spindlePresets().front()).suction, 0);
}

TEST(TickSound, KnowsTheThreeKindsOfDrive) {
    EXPECT_EQ(soundOf({}, spindlePresets()[0]).motor, MotorKind::AirTurbine);
    EXPECT_EQ(soundOf({}, spindlePresets()[1]).motor, MotorKind::Electric);
    EXPECT_EQ(soundOf({}, spindlePresets()[2]).motor, MotorKind::LowSpeed);
}

TEST(TickSound, LoadBeyondTheStallTorqueIsFullLoad) {
    Tick tick = cuttingTick();
    tick.spindle.load = 99;
    EXPECT_EQ(soundOf(tick, spindlePresets().front()).load, 1);
}

TEST(TickSound, ThePedalDrivesNoAirInTouchMode) {
    Tick tick = cuttingTick();
    tick.input.cutting = false;
    EXPECT_EQ(soundOf(tick, spindlePresets().front()).pedal, 0);
}

}  // namespace
}  // namespace tactooth
