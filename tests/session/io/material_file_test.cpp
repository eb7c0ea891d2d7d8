// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/material_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sound/voices/drill_sound_state.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

void expectEqual(const MaterialTable& got, const MaterialTable& expected) {
    for (std::size_t i = 0; i < kMaterialCount; ++i) {
        const auto id = static_cast<MaterialId>(i);
        SCOPED_TRACE(materialName(id));
        EXPECT_EQ(got[id].stiffness, expected[id].stiffness);
        EXPECT_EQ(got[id].damping, expected[id].damping);
        EXPECT_EQ(got[id].friction, expected[id].friction);
        EXPECT_EQ(got[id].removal, expected[id].removal);
        EXPECT_EQ(got[id].colour, expected[id].colour);
        EXPECT_EQ(got[id].roughness, expected[id].roughness);
        EXPECT_EQ(got[id].soundCentre, expected[id].soundCentre);
        EXPECT_EQ(got[id].soundBrightness, expected[id].soundBrightness);
    }
}

MaterialTable parsed(std::string_view text) {
    const auto table = parseMaterials(text, "m.toml", {});
    EXPECT_TRUE(table) << table.error().message();
    return table ? *table : MaterialTable();
}

std::string refusal(std::string_view text) {
    const auto table = parseMaterials(text, "m.toml", {});
    return table ? "accepted" : table.error().message();
}

TEST(MaterialFile, TheBuiltInTextNamesEachNumberOfTheProgramsDefaults) {
    MaterialTable other;
    for (std::size_t i = 0; i < kMaterialCount; ++i) {
        other[static_cast<MaterialId>(i)] = {-1, -1, -1, -1, {-1, -1, -1}, -1, -1, -1};
    }
    const auto table = parseMaterials(defaultMaterialsText(), "data/materials.toml", other);
    ASSERT_TRUE(table) << table.error().message();
    expectEqual(*table, MaterialTable());
    expectEqual(defaultMaterials(), MaterialTable());
}

TEST(MaterialFile, TheDefaultsSoundAsTheSynthesisersOwnCharacters) {
    const MaterialTable table;
    for (std::size_t i = 0; i < kMaterialCount; ++i) {
        const auto id = static_cast<MaterialId>(i);
        const SoundCharacter character = soundCharacterOf(materialName(id));
        EXPECT_EQ(table[id].soundCentre, character.bandCentreHz) << materialName(id);
        EXPECT_EQ(table[id].soundBrightness, character.level) << materialName(id);
    }
}

TEST(MaterialFile, AFileOverridesOnlyWhatItNames) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "mine.toml", "[caries]\nstiffness = 0.4\ncolour = [0, 0.5, 1]\n\n[pulp]\nremoval = 2\n");
    const auto table = readMaterials(folder / "mine.toml");
    ASSERT_TRUE(table) << table.error().message();
    MaterialTable expected;
    expected[MaterialId::Caries].stiffness = 0.4;
    expected[MaterialId::Caries].colour = {0, 0.5F, 1};
    expected[MaterialId::Pulp].removal = 2;
    expectEqual(*table, expected);
}

TEST(MaterialFile, AnyWayOfWritingATomlTableWill) {
    EXPECT_EQ(parsed("enamel.stiffness = 3")[MaterialId::Enamel].stiffness, 3);
    EXPECT_EQ(parsed("dentin = { damping = 1e-3 }")[MaterialId::Dentin].damping, 0.001);
    EXPECT_EQ(parsed("\xEF\xBB\xBF[other]\r\nroughness = 1\r\n")[MaterialId::Other].roughness, 1);
    expectEqual(parsed("# nothing but a comment\n"), MaterialTable());
}

TEST(MaterialFile, RefusesAnUnknownMaterialOrKey) {
    EXPECT_EQ(refusal("\n[gold]\nstiffness = 1\n"),
              "m.toml, line 2: there is no material 'gold'; the materials are enamel, dentin, pulp, other, "
              "restoration, caries.");
    EXPECT_EQ(refusal("[enamel]\n# as steel\nstiffnes = 1\n"),
              "m.toml, line 3: a material has no key 'stiffnes'; the keys are colour, stiffness, damping, friction, "
              "removal, roughness, sound_centre, sound_level.");
    EXPECT_THAT(refusal("stiffness = 1\n"), HasSubstr("line 1: there is no material 'stiffness'"));
}

TEST(MaterialFile, RefusesAValueOfAnotherKind) {
    EXPECT_EQ(refusal("enamel = 4"), "m.toml, line 1: expected the keys of enamel below a line [enamel], but found 4.");
    EXPECT_EQ(refusal("[enamel]\nstiffness = 'hard'"),
              "m.toml, line 2: 'stiffness' must be a number from 0 to 5, but is a text in quotes.");
    EXPECT_THAT(refusal("[enamel]\ndamping = true"), HasSubstr("but is true or false"));
    EXPECT_THAT(refusal("[enamel]\nfriction = [1]"), HasSubstr("but is a list"));
    EXPECT_THAT(refusal("[enamel]\nremoval = 2020-01-01"), HasSubstr("but is a date or a time"));
    EXPECT_THAT(refusal("[[enamel]]\nremoval = 1"), HasSubstr("but found a list"));
}

TEST(MaterialFile, RefusesNumbersOutOfRange) {
    EXPECT_EQ(refusal("[dentin]\n\nstiffness = -0.5"),
              "m.toml, line 3: 'stiffness' must be a number from 0 to 5, but is -0.5.");
    for (const std::string bad : {"nan", "inf", "-inf", "-1", "-1e-300"}) {
        for (const std::string key :
             {"stiffness", "damping", "friction", "removal", "roughness", "sound_centre", "sound_level"}) {
            EXPECT_THAT(refusal("[pulp]\n" + key + " = " + bad), HasSubstr("line 2: '" + key + "' must be a number"));
        }
    }
    EXPECT_THAT(refusal("[pulp]\nroughness = 1.01"), HasSubstr("from 0 to 1, but is 1.01"));
    EXPECT_THAT(refusal("[pulp]\nsound_level = 2"), HasSubstr("from 0 to 1, but is 2"));
}

TEST(MaterialFile, RefusesWhatNoDeviceMayRender) {
    EXPECT_EQ(refusal("[enamel]\nstiffness = 5.1"),
              "m.toml, line 2: 'stiffness' must be a number from 0 to 5, but is 5.1.");
    EXPECT_EQ(refusal("[pulp]\ndamping = 1"), "m.toml, line 2: 'damping' must be a number from 0 to 0.02, but is 1.");
    EXPECT_EQ(refusal("caries.friction = 1e9"),
              "m.toml, line 1: 'friction' must be a number from 0 to 2, but is 1e+09.");
    EXPECT_THAT(refusal("[dentin]\nremoval = 11"), HasSubstr("from 0 to 10, but is 11"));
    EXPECT_THAT(refusal("[dentin]\nsound_centre = 1e5"), HasSubstr("from 0 to 20000, but is 1e+05"));
    const MaterialTable most = parsed("[other]\nstiffness = 5\ndamping = 0.02\nfriction = 2\n");
    EXPECT_EQ(most[MaterialId::Other].stiffness, kMaxMaterialStiffness);
    EXPECT_EQ(most[MaterialId::Other].damping, kMaxMaterialDamping);
    EXPECT_EQ(most[MaterialId::Other].friction, kMaxMaterialFriction);
}

TEST(MaterialFile, RefusesAColourThatIsNone) {
    EXPECT_EQ(refusal("[pulp]\ncolour = [1, 0]"),
              "m.toml, line 2: 'colour' must be three numbers in brackets (red, green, blue), but is a list of 2.");
    EXPECT_THAT(refusal("[pulp]\ncolour = 'red'"), HasSubstr("but is a text in quotes"));
    EXPECT_EQ(refusal("[pulp]\ncolour = [0,\n0,\n1.5]"),
              "m.toml, line 4: 'colour' must be a number from 0 to 1, but is 1.5.");
    EXPECT_THAT(refusal("[pulp]\ncolour = [0, '0', 1]"), HasSubstr("but is a text in quotes"));
}

TEST(MaterialFile, RefusesWhatIsNotToml) {
    EXPECT_THAT(refusal("[enamel\nstiffness = 1"), HasSubstr("m.toml, line 1: this is not TOML: "));
    EXPECT_THAT(refusal("[enamel]\nstiffness = 1\nstiffness = 2"), HasSubstr("m.toml, line 3: this is not TOML: "));
    EXPECT_THAT(refusal("[enamel]\nstiffness = \n"), HasSubstr("m.toml, line 2: "));
}

TEST(MaterialFile, SaysWhichFileIsMissing) {
    const test::TemporaryFolder folder;
    const auto table = readMaterials(folder / "none.toml");
    ASSERT_FALSE(table);
    EXPECT_THAT(table.error().message(), HasSubstr("none.toml: there is no such file"));
}

}  // namespace
}  // namespace tactooth
