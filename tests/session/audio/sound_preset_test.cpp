// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/sound_preset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session/audio/material_sound.h"
#include "session/io/material_file.h"
#include "sound/sound_files.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

class SoundPreset : public ::testing::Test {
protected:
    SoundPreset() {
        std::filesystem::create_directory(folder_ / "sounds");
        test::writeTone(folder_ / "sounds/turbine.wav", 5000, 0.3);
        test::writeTone(folder_ / "sounds/cut.flac", 3000, 0.3, {SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 44100, 2});
    }
    Expected<std::shared_ptr<const SoundKit>> read(const std::string& text,
                                                   const MaterialRegistry* materials = &dentalMaterials()) {
        test::writeText(folder_ / "school.toml", text);
        return readSoundKit(folder_ / "school.toml", spindlePresets()[0], materials);
    }
    std::string refusal(const std::string& text, const MaterialRegistry* materials = &dentalMaterials()) {
        const auto kit = read(text, materials);
        return kit ? "accepted" : kit.error().message();
    }

    test::TemporaryFolder folder_;
};

TEST_F(SoundPreset, SaysWhichRecordingStandsForWhat) {
    const auto kit = read(
        "[motor]\nfile = \"sounds/turbine.wav\"\nspeed_rpm = 380000\ngain_db = -6\n\n"
        "[cutting.enamel]\nfile = \"sounds/cut.flac\"\n\n[suction]\nfile = \"sounds/cut.flac\"\n");
    ASSERT_TRUE(kit) << kit.error().message();
    const SoundKit& read = **kit;
    ASSERT_TRUE(read.motor);
    EXPECT_EQ(read.motor->speedRpm, 380000);
    EXPECT_NEAR(read.motor->gain, 0.501, 0.001);
    ASSERT_EQ(read.cutting.size(), 1U);
    EXPECT_EQ(read.cutting[0].kind, soundKindOf("enamel"));
    EXPECT_EQ(read.cutting[0].part.speedRpm, 0);
    EXPECT_EQ(read.cutting[0].part.recording->rate(), 44100);
    EXPECT_TRUE(read.suction);
    EXPECT_FALSE(read.water);
}

TEST_F(SoundPreset, ARecordingAloneIsTheDriveRunningFree) {
    const auto kit = readSoundKit(folder_ / "sounds/turbine.wav", spindlePresets()[1], nullptr);
    ASSERT_TRUE(kit) << kit.error().message();
    EXPECT_EQ((*kit)->motor->speedRpm, spindlePresets()[1].freeSpeedRpm);
}

TEST_F(SoundPreset, RefusesWithFileAndLine) {
    const std::string motor = "[motor]\nspeed_rpm = 380000\nfile = \"sounds/turbine.wav\"\n";
    EXPECT_EQ(refusal(motor), "accepted");
    EXPECT_THAT(refusal("[motor\n"), HasSubstr("school.toml, line 1: this is not TOML"));
    EXPECT_THAT(refusal(motor + "[engine]\nfile = \"a\"\n"), HasSubstr("line 4: there is no part 'engine'; the parts"));
    EXPECT_THAT(refusal("[motor]\nfile = \"sounds/turbine.wav\"\n"), HasSubstr("line 1: 'motor' needs the speed"));
    EXPECT_THAT(refusal("[water]\ngain_db = 3\n"), HasSubstr("line 1: 'water' has no recording; add file"));
    EXPECT_THAT(refusal(motor + "pitch = 2\n"), HasSubstr("line 4: a recording has no key 'pitch'; the keys are"));
    EXPECT_THAT(refusal("[motor]\nspeed_rpm = -3\n"), HasSubstr("line 2: 'speed_rpm' must be a number from 100 to"));
    EXPECT_THAT(refusal("[motor]\nspeed_rpm = nan\n"), HasSubstr("line 2: 'speed_rpm' must be a number from 100 to"));
    EXPECT_THAT(refusal("[water]\nfile = 3\n"), HasSubstr("line 2: 'file' must be a name in quotes"));
    EXPECT_THAT(refusal("cutting = 3\n"), HasSubstr("line 1: 'cutting' needs a material"));
    EXPECT_THAT(refusal("[cutting.stone]\nfile = \"a\"\n"),
                HasSubstr("line 1: there is no material 'stone'; the materials are " + dentalMaterials().names()));
    EXPECT_THAT(refusal("motor = true\n"), HasSubstr("line 1: 'motor' must be a table"));
}

TEST_F(SoundPreset, AMaterialOfOnesOwnHasARecordingWhateverToothItIsIn) {
    const std::string text = "[cutting.gold]\nfile = \"sounds/cut.flac\"\n";
    const auto mine = parseMaterials("[gold]\n", "mine.toml"), other = parseMaterials("[tin]\n[gold]\n", "case.toml");
    ASSERT_TRUE(mine && other);
    const auto kit = read(text, *mine);
    ASSERT_TRUE(kit) << kit.error().message();
    for (const MaterialRegistry* materials : {*mine, *other}) {
        const MaterialTable table(*materials);
        EXPECT_EQ((*kit)->cuttingOf(characterOf(table, materials->find("gold").value())), 0U);
        for (const char* synthesised : {"enamel", "other"}) {
            EXPECT_EQ((*kit)->cuttingOf(characterOf(table, materials->find(synthesised).value())), 1U) << synthesised;
        }
    }
    EXPECT_THAT(refusal("[cutting.tin]\nfile = \"sounds/cut.flac\"\n", *mine),
                HasSubstr("there is no material 'tin'; the materials are " + builtinMaterials().names() + ", gold"));
}

TEST_F(SoundPreset, TheDentalMaterialsNeedNoFileOfMaterials) {
    for (const std::string name : {"amalgam", "composite"}) {
        const auto kit = read("[cutting." + name + "]\nfile = \"sounds/cut.flac\"\n");
        ASSERT_TRUE(kit) << kit.error().message();
        EXPECT_EQ((*kit)->cutting.at(0).kind, soundKindOf(name));
    }
}

TEST_F(SoundPreset, WithoutMaterialsEachNameThatAMaterialMayHaveIsTaken) {
    const std::string keys = "]\nfile = \"sounds/cut.flac\"\n";
    EXPECT_EQ(refusal("[cutting.gold" + keys, nullptr), "accepted");
    EXPECT_THAT(refusal("[cutting.Gold" + keys, nullptr), HasSubstr("line 1: a material cannot be named 'Gold'"));
    std::string many;
    for (std::size_t i = 0; i < kMaxRecordedMaterials; ++i) many += "[cutting.m" + std::to_string(i) + keys;
    EXPECT_EQ(refusal(many, nullptr), "accepted");
    EXPECT_THAT(refusal(many + "[cutting.one-more" + keys, nullptr),
                HasSubstr("there are more than " + std::to_string(kMaxRecordedMaterials) + " materials"));
}

TEST_F(SoundPreset, NamesNoFileOutsideItsFolder) {
    test::writeTone(folder_ / "tone.wav", 5000, 0.3);
    std::filesystem::create_directory(folder_ / "preset");
    const auto refused = [&](const std::string& entry) {
        test::writeText(folder_ / "preset/p.toml", "[water]\nfile = '" + entry + "'\n");
        const auto kit = readSoundKit(folder_ / "preset/p.toml", spindlePresets()[0], nullptr);
        return kit ? "accepted" : kit.error().message();
    };
    for (const std::string entry :
         {"../tone.wav", "a/../../tone.wav", "/etc/passwd", "", "..", "..\\tone.wav", "C:/tone.wav"}) {
        EXPECT_THAT(refused(entry), HasSubstr("p.toml, line 2: ")) << entry;
        EXPECT_THAT(refused(entry), HasSubstr("must lie beside this file or below it")) << entry;
    }
    for (const std::string entry : {"./tone.wav", "a//b", "C:tone.wav"}) {  // names of files beside it, if odd ones
        EXPECT_THAT(refused(entry), HasSubstr("there is no such file")) << entry;
    }
    EXPECT_THAT(refused(folder_ / "tone.wav"), HasSubstr("must lie beside"));
    std::filesystem::create_symlink(folder_ / "tone.wav", folder_ / "preset/out.wav");
    std::filesystem::create_symlink("../tone.wav", folder_ / "preset/near.wav");
    std::filesystem::create_directory_symlink("..", folder_ / "preset/up");
    for (const std::string entry : {"out.wav", "near.wav", "up/tone.wav"}) {
        EXPECT_THAT(refused(entry), HasSubstr("is a link that leads out of the folder")) << entry;
    }
    std::filesystem::create_directory(folder_ / "preset/in");
    test::writeTone(folder_ / "preset/in/tone.wav", 5000, 0.3);
    std::filesystem::create_symlink("in/tone.wav", folder_ / "preset/inside.wav");
    EXPECT_EQ(refused("in/tone.wav"), "accepted");
    EXPECT_EQ(refused("inside.wav"), "accepted");
}

TEST_F(SoundPreset, NamesTheLineOfARecordingThatCannotBeUsed) {
    test::writeText(folder_ / "sounds/bad.wav", "RIFF");
    EXPECT_THAT(refusal("[water]\n\nfile = \"sounds/none.wav\"\n"), HasSubstr("school.toml, line 3: "));
    EXPECT_THAT(refusal("[water]\n\nfile = \"sounds/none.wav\"\n"), HasSubstr("none.wav: there is no such file"));
    EXPECT_THAT(refusal("[water]\nfile = \"sounds/bad.wav\"\n"), HasSubstr("bad.wav: this is not a recording"));
}

}  // namespace
}  // namespace tactooth
