// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/sound_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "session/io/material_file.h"
#include "support/materials.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view kHead = "t,speed_rpm,power,material\n";

Expected<std::vector<TimedSoundState>> read(const std::string& rows, std::size_t drive = 0,
                                            const MaterialRegistry& materials = builtinMaterials()) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "speed.csv", std::string(kHead) + rows);
    return readSoundProfile(folder / "speed.csv", spindlePresets()[drive], MaterialTable(materials));
}

std::string refusal(const std::string& rows) {
    const auto track = read(rows);
    return track ? "accepted" : track.error().message();
}

TEST(SoundProfile, ReadsTimesFromTheFirstRowOnAndWhatTheBurDoes) {
    const auto track = read("7,0,0,none\n7.5,300000,4,dentin\n");
    ASSERT_TRUE(track) << track.error().message();
    ASSERT_EQ(track->size(), 2U);
    EXPECT_EQ((*track)[0].time, 0);
    EXPECT_EQ((*track)[1].time, 0.5);
    const DrillSoundState& state = (*track)[1].state;
    EXPECT_EQ(state.motor, MotorKind::AirTurbine);
    EXPECT_EQ(state.speedRpm, 300000);
    EXPECT_EQ(state.freeSpeedRpm, 400000);
    EXPECT_EQ(state.removalPower, 4);
    EXPECT_EQ(state.material.bandCentreHz, builtinMaterials()[test::kDentin].numbers.soundCentre);
}

TEST(SoundProfile, TheLoadIsTheTorqueOfThatPowerAtThatSpeed) {
    const auto track = read("0,300000,15,enamel\n1,300000,15,enamel\n");
    ASSERT_TRUE(track);
    const double torque = 1000 * 15 / (300000 * std::numbers::pi / 30);  // N*mm
    EXPECT_NEAR((*track)[0].state.load, torque / spindlePresets()[0].stallTorque, 1e-12);
}

TEST(SoundProfile, ABurAtRestHasNoAirAndALoadedOneMore) {
    const auto track = read("0,0,0,none\n1,200000,0,none\n2,200000,10,enamel\n3,400000,0,none\n");
    ASSERT_TRUE(track);
    EXPECT_EQ((*track)[0].state.pedal, 0);
    EXPECT_EQ((*track)[1].state.pedal, 0.5);
    EXPECT_GT((*track)[2].state.pedal, 0.6);
    EXPECT_EQ((*track)[3].state.pedal, 1);
}

TEST(SoundProfile, NoneCutsNothingAndSoundsLikeWhatComesNext) {
    const auto track = read("0,300000,0,none\n1,300000,5,none\n2,300000,5,caries\n3,300000,0,none\n");
    ASSERT_TRUE(track);
    EXPECT_EQ((*track)[1].state.removalPower, 0);
    EXPECT_EQ((*track)[1].state.material.bandCentreHz, builtinMaterials()[test::kCaries].numbers.soundCentre);
}

TEST(SoundProfile, KnowsTheMaterialsOfTheTableAlone) {
    const std::string rows = "0,300000,5,gold\n1,300000,5,gold\n";
    EXPECT_THAT(refusal(rows), HasSubstr("line 2: there is no material 'gold'; the materials are " +
                                         builtinMaterials().names() + ", and none"));
    const auto materials = parseMaterials("[gold]\nsound_centre = 3100\n", "mine.toml");
    ASSERT_TRUE(materials);
    const auto track = read(rows, 0, **materials);
    ASSERT_TRUE(track) << track.error().message();
    EXPECT_EQ((*track)[0].state.material.bandCentreHz, 3100);
    EXPECT_THAT(
        read("0,1,0,tin\n1,1,0,tin\n", 0, **materials).error().message(),
        HasSubstr("there is no material 'tin'; the materials are " + builtinMaterials().names() + ", gold, and"));
}

TEST(SoundProfile, AMaterialThatIsNamedNoneIsNotMeantByNone) {
    const auto materials = parseMaterials("[none]\nsound_centre = 3100\n", "mine.toml");
    ASSERT_TRUE(materials);
    const auto track = read("0,300000,5,none\n1,300000,5,caries\n", 0, **materials);
    ASSERT_TRUE(track) << track.error().message();
    EXPECT_EQ((*track)[0].state.removalPower, 0);
    EXPECT_EQ((*track)[0].state.material.bandCentreHz, builtinMaterials()[test::kCaries].numbers.soundCentre);
}

TEST(SoundProfile, EachReturnToAMaterialIsAnImpact) {
    const auto track = read("0,0,0,none\n1,0,0,enamel\n2,0,0,dentin\n3,0,0,none\n4,0,0,enamel\n");
    ASSERT_TRUE(track);
    std::vector<std::uint32_t> counts;
    for (const TimedSoundState& moment : *track) counts.push_back(moment.state.contactCount);
    EXPECT_EQ(counts, (std::vector<std::uint32_t>{0, 1, 1, 1, 2}));
}

TEST(SoundProfile, KnowsTheThreeDrives) {
    EXPECT_EQ((*read("0,1,0,none\n1,1,0,none\n", 1))[0].state.motor, MotorKind::Electric);
    EXPECT_EQ((*read("0,1,0,none\n1,1,0,none\n", 2))[0].state.motor, MotorKind::LowSpeed);
}

TEST(SoundProfile, TwoRowsAtOneTimeAreAStep) {
    EXPECT_TRUE(read("0,300000,0,none\n1,300000,0,none\n1,200000,5,enamel\n2,200000,5,enamel\n"));
}

TEST(SoundProfile, RefusesWithFileAndLine) {
    const std::string good = "0,1000,0,none\n";
    EXPECT_THAT(refusal(good + "-1,1000,0,none\n"), HasSubstr("speed.csv, line 3: time runs backwards"));
    EXPECT_THAT(refusal(good + "1,-5,0,none\n"), HasSubstr("line 3: speed_rpm must be from 0 to 1000000"));
    EXPECT_THAT(refusal(good + "1,1e7,0,none\n"), HasSubstr("line 3: speed_rpm must be"));
    EXPECT_THAT(refusal(good + "1,5,-2,enamel\n"), HasSubstr("line 3: power must be from 0 to 1000 W"));
    EXPECT_THAT(refusal(good + "1,5,2,cheese\n"),
                HasSubstr("line 3: there is no material 'cheese'; the materials are enamel"));
    EXPECT_THAT(refusal(good + "1,5,2,\n"), HasSubstr("line 3: there is no material"));
    EXPECT_THAT(refusal(good + "1,nan,2,enamel\n"), HasSubstr("line 3: column 'speed_rpm': expected a finite number"));
    EXPECT_THAT(refusal(good + "1,5,2\n"), HasSubstr("line 3: expected 4 fields"));
    EXPECT_THAT(refusal(good), HasSubstr("line 2: the rows span no time"));
    EXPECT_THAT(refusal(good + "3601,1000,0,none\n"), HasSubstr("line 3: this is more than an hour after"));
    EXPECT_THAT(refusal("-1e308,1,0,none\n1e308,1,0,none\n"), HasSubstr("line 3: this is more than an hour after"));
    EXPECT_THAT(refusal(""), HasSubstr("speed.csv: there are no rows"));
}

}  // namespace
}  // namespace tactooth
