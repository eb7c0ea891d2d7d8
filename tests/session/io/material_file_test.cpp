// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/io/material_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/materials.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

void expectEqual(const MaterialTable& got, const MaterialTable& expected) {
    ASSERT_EQ(got.registry().size(), expected.registry().size());
    for (const MaterialId id : got.registry().ids()) {
        EXPECT_EQ(got.registry().nameOf(id), expected.registry().nameOf(id));
        EXPECT_EQ(got[id], expected[id]) << got.registry().nameOf(id);
    }
}

const MaterialRegistry& registryOf(std::string_view text) {
    const auto registry = parseMaterials(text, "m.toml");
    EXPECT_TRUE(registry) << registry.error().message();
    return registry ? **registry : builtinMaterials();
}

MaterialTable parsed(std::string_view text) { return MaterialTable(registryOf(text)); }

std::string refusal(std::string_view text) {
    const auto registry = parseMaterials(text, "m.toml");
    return registry ? "accepted" : registry.error().message();
}

/// The layers below know no TOML: CMake makes their materials from the same file.
TEST(MaterialFile, TheProgramsTextGivesTheMaterialsThatAreBuiltIn) {
    std::vector<MaterialDefinition> blank = builtinMaterials().definitions();
    for (MaterialDefinition& one : blank) one.titleEn = one.titleJa = {}, one.numbers = {};
    const auto registry = parseMaterials(defaultMaterialsText(), "data/materials.toml", MaterialRegistry::make(blank));
    ASSERT_TRUE(registry) << registry.error().message();
    EXPECT_EQ((*registry)->definitions(), builtinMaterials().definitions());
}

/// The materials of `text` on top of the built-in ones, whose numbers are all `filled` first: a key that a block leaves
/// out shows what was there before.
std::vector<MaterialDefinition> readOver(double filled, std::string_view text) {
    std::vector<MaterialDefinition> start = builtinMaterials().definitions();
    for (MaterialDefinition& one : start) {
        for (const MaterialNumberKey& key : materialNumberKeys()) key.set(one.numbers, filled);
        one.numbers.colour.fill(static_cast<float>(filled));
        one.titleEn = one.titleJa = filled > 0 ? "filled" : "blank";
    }
    const auto registry = parseMaterials(text, "m.toml", MaterialRegistry::make(start));
    EXPECT_TRUE(registry) << registry.error().message();
    return registry ? (*registry)->definitions() : start;
}

TEST(MaterialFile, TheProgramsTextGivesEveryKeyOfEachMaterial) {
    const std::vector<MaterialDefinition> overBlanks = readOver(0, defaultMaterialsText());
    const std::vector<MaterialDefinition> overOthers = readOver(0.75, defaultMaterialsText());
    ASSERT_EQ(overBlanks.size(), overOthers.size());
    for (std::size_t i = 0; i < overBlanks.size(); ++i) EXPECT_EQ(overBlanks[i], overOthers[i]) << overBlanks[i].name;
}

TEST(MaterialFile, SoDoesTheTextOfTheDentalMaterials) {
    const std::size_t builtin = builtinMaterials().size();
    const std::vector<MaterialDefinition> overBlanks = readOver(0, dentalMaterialsText());
    const std::vector<MaterialDefinition> overOthers = readOver(0.75, dentalMaterialsText());
    ASSERT_EQ(overBlanks.size(), builtin + 2);
    ASSERT_EQ(overOthers.size(), builtin + 2);
    for (std::size_t i = builtin; i < overBlanks.size(); ++i) {
        EXPECT_EQ(overBlanks[i], overOthers[i]) << overBlanks[i].name;
        EXPECT_NE(overBlanks[i].titleJa, overBlanks[i].name);
    }
}

/// Up to the most that a tooth can have; the list of materials grows and moves meanwhile.
TEST(MaterialFile, AddsAsManyMaterialsAsThereIsRoomFor) {
    const std::size_t builtin = builtinMaterials().size();
    for (std::size_t count = 1; builtin + count <= kMaxMaterials; ++count) {
        std::string text;
        for (std::size_t i = 0; i < count; ++i) {
            text += "[filling-" + std::to_string(i) + "]\nstiffness = 0." + std::to_string(100 + i) + "\n";
        }
        const MaterialRegistry& all = registryOf(text);
        ASSERT_EQ(all.size(), builtin + count);
        for (std::size_t i = 0; i < count; ++i) {
            const auto id = all.find("filling-" + std::to_string(i));
            ASSERT_TRUE(id);
            EXPECT_DOUBLE_EQ(all[*id].numbers.stiffness, 0.1 + 0.001 * static_cast<double>(i));
        }
    }
}

TEST(MaterialFile, TheDentalMaterialsAreBehindTheBuiltInOnes) {
    const MaterialRegistry& all = dentalMaterials();
    EXPECT_EQ(all.names(), builtinMaterials().names() + ", amalgam, composite");
    for (const MaterialId id : builtinMaterials().ids()) EXPECT_EQ(all[id], builtinMaterials()[id]);
    EXPECT_EQ(&withDentalMaterials(builtinMaterials()), &all);
    EXPECT_EQ(&withDentalMaterials(all), &all);
}

TEST(MaterialFile, ADentalMaterialOfOnesOwnStaysAsItIs) {
    const MaterialRegistry& mine = registryOf("[amalgam]\nsound_centre = 8800\ncode = 65\n[gold]\n");
    const MaterialRegistry& all = withDentalMaterials(mine);
    EXPECT_EQ(all.names(), mine.names() + ", composite");
    EXPECT_EQ(all[all.find("amalgam").value()].numbers.soundCentre, 8800);
    EXPECT_EQ(all[all.find("composite").value()].numbers,
              dentalMaterials()[dentalMaterials().find("composite").value()].numbers);
}

TEST(MaterialFile, ATableThatIsFullTakesNoDentalMaterials) {
    std::string text;
    for (std::size_t i = builtinMaterials().size(); i < kMaxMaterials; ++i) {
        text += "[filling-" + std::to_string(i) + "]\n";
    }
    const MaterialRegistry& full = registryOf(text);
    ASSERT_EQ(full.size(), kMaxMaterials);
    EXPECT_EQ(&withDentalMaterials(full), &full);
}

TEST(MaterialFile, AFileOverridesOnlyWhatItNames) {
    const test::TemporaryFolder folder;
    test::writeText(folder / "mine.toml", "[caries]\nstiffness = 0.4\ncolour = [0, 0.5, 1]\n\n[pulp]\nremoval = 2\n");
    const auto registry = readMaterials(folder / "mine.toml");
    ASSERT_TRUE(registry) << registry.error().message();
    MaterialTable expected;
    expected[test::kCaries].stiffness = 0.4;
    expected[test::kCaries].colour = {0, 0.5F, 1};
    expected[test::kPulp].removal = 2;
    expectEqual(MaterialTable(**registry), expected);
}

TEST(MaterialFile, AnyWayOfWritingATomlTableWill) {
    EXPECT_EQ(parsed("enamel.stiffness = 3")[test::kEnamel].stiffness, 3);
    EXPECT_EQ(parsed("dentin = { damping = 1e-3 }")[test::kDentin].damping, 0.001);
    EXPECT_EQ(parsed("\xEF\xBB\xBF[other]\r\nroughness = 1\r\n")[test::kOther].roughness, 1);
    expectEqual(parsed("# nothing but a comment\n"), MaterialTable());
}

TEST(MaterialFile, ANewBlockAddsAMaterialThatIsOtherwiseAsTheSurroundings) {
    const MaterialRegistry& all =
        registryOf("[composite]\nstiffness = 0.7\ntitle_ja = 'コンポジット'\n[amalgam]\ncode = 70\n");
    ASSERT_EQ(all.size(), builtinMaterials().size() + 2);
    EXPECT_EQ(all.names(), builtinMaterials().names() + ", composite, amalgam");
    const MaterialDefinition& composite = all[all.find("composite").value()];
    Material expected = builtinMaterials()[test::kOther].numbers;
    expected.stiffness = 0.7;
    EXPECT_EQ(composite.numbers, expected);
    EXPECT_EQ(composite.titleEn, "composite");
    EXPECT_EQ(composite.titleJa, "コンポジット");
    EXPECT_EQ(composite.role, MaterialRole::None);
    EXPECT_EQ(composite.nesting, builtinMaterials()[test::kOther].nesting);
    EXPECT_EQ(composite.code, 64);
    EXPECT_EQ(all[all.find("amalgam").value()].code, 70);
    for (const MaterialId id : builtinMaterials().ids()) EXPECT_EQ(all[id], builtinMaterials()[id]);
}

TEST(MaterialFile, ANewMaterialMayHaveARoleAndANestingOrder) {
    const MaterialRegistry& all = registryOf("[nerve]\nrole = 'pulp'\nnesting = 9\n");
    EXPECT_TRUE(all.hasRole(all.find("nerve").value(), MaterialRole::Pulp));
    EXPECT_EQ(all[all.find("nerve").value()].nesting, 9);
}

TEST(MaterialFile, ACodeThatTheFileGivesLaterIsLeftFree) {
    const MaterialRegistry& all = registryOf("[a]\n[b]\ncode = 64\n");
    EXPECT_EQ(all[all.find("a").value()].code, 65);
    EXPECT_EQ(all[all.find("b").value()].code, 64);
}

TEST(MaterialFile, RefusesADefinitionThatCannotBe) {
    EXPECT_EQ(refusal("[Gold]\n"),
              "m.toml, line 1: a material cannot be named 'Gold'; take small letters, digits, - and _, at most 40, a "
              "letter first.");
    EXPECT_EQ(refusal("[gold]\ncode = 1\n"),
              "m.toml, line 2: the code 1 is that of dentin; give each material its own.");
    EXPECT_EQ(refusal("[gold]\nrole = 'metal'\n"),
              "m.toml, line 2: 'role' must be one of enamel, dentin, pulp, decay, surroundings, none.");
    EXPECT_EQ(refusal("[enamel]\nnesting = 9\n"),
              "m.toml, line 2: 'nesting' belongs to new materials; that of enamel is built in.");
    EXPECT_THAT(refusal("[enamel]\nrole = 'pulp'\n"), HasSubstr("'role' belongs to new materials"));
    EXPECT_THAT(refusal("[gold]\ncode = 256\n"), HasSubstr("'code' must be a whole number from 0 to 255"));
    EXPECT_THAT(refusal("[gold]\ntitle_en = 3\n"), HasSubstr("'title_en' must be a text of one line in quotes"));
    std::string many;
    for (std::size_t i = 0; i <= kMaxMaterials; ++i) many += "[m" + std::to_string(i) + "]\n";
    const std::string tooMany = std::to_string(kMaxMaterials - builtinMaterials().size() + 1);
    EXPECT_EQ(refusal(many), "m.toml, line " + tooMany + ": there are more than " + std::to_string(kMaxMaterials) +
                                 " materials; leave some out.");
}

TEST(MaterialFile, RefusesAnUnknownKey) {
    EXPECT_EQ(refusal("[enamel]\n# as steel\nstiffnes = 1\n"),
              "m.toml, line 3: a material has no key 'stiffnes'; the keys are colour, stiffness, damping, friction, "
              "removal, roughness, translucency, wetness, grain, metalness, sound_centre, sound_level, sound_octaves, "
              "sound_graininess, tap_frequency, tap_decay, tap_brightness, title_en, title_ja, role, nesting, code.");
    EXPECT_EQ(refusal("stiffness = 1\n"),
              "m.toml, line 1: expected the keys of stiffness below a line [stiffness], but found 1.");
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
    EXPECT_EQ(most[test::kOther].stiffness, kMaxMaterialStiffness);
    EXPECT_EQ(most[test::kOther].damping, kMaxMaterialDamping);
    EXPECT_EQ(most[test::kOther].friction, kMaxMaterialFriction);
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
    const auto registry = readMaterials(folder / "none.toml");
    ASSERT_FALSE(registry);
    EXPECT_THAT(registry.error().message(), HasSubstr("none.toml: there is no such file"));
}

}  // namespace
}  // namespace tactooth
