// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/case_description.h"

#include <gtest/gtest.h>

#include "support/materials.h"

namespace tactooth {
namespace {

CaseDescription example() {
    CaseDescription one;
    one.title = "A \"quoted\" \\ title";
    one.licence = "CC0-1.0";
    one.provenance = {"from somewhere", "\xe6\xad\xaf"};
    one.materials = "materials.toml";
    CaseTooth tooth;
    tooth.name = "46";
    tooth.fdi = 46;
    tooth.outer = "teeth/46/outer.stl";
    tooth.layers = {{test::kEnamel, "teeth/46/enamel.stl"}, {test::kCaries, "teeth/46/caries.stl"}};
    tooth.isModelled = true;
    tooth.toothInCase = {Vec3(1.0 / 3, -2, 1e-9), Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
    tooth.assumed = {"One.", "Two."};
    one.teeth.push_back(tooth);
    CaseTooth plain;
    plain.name = "block";
    plain.outer = "block.stl";
    plain.material = test::kDentin;
    one.teeth.push_back(plain);
    one.around.push_back({"jaw bone", "bone.stl", test::kOther, {Vec3(0, 0, -3), Quat::Identity()}, {"Mended."}});
    one.burs = {"burs/1.toml"};
    return one;
}

TEST(CaseDescription, WhatIsWrittenIsRead) {
    const std::string text = caseText(example());
    const auto read = parseCase(text, "case.toml");
    ASSERT_TRUE(read) << read.error().message() << "\n" << text;
    EXPECT_EQ(caseText(*read), text);
    EXPECT_EQ(read->title, example().title);
    EXPECT_EQ(read->provenance, example().provenance);
    EXPECT_EQ(read->teeth[0].layers, example().teeth[0].layers);
    EXPECT_TRUE(read->teeth[0].isModelled);
    EXPECT_EQ(read->teeth[0].toothInCase.position, example().teeth[0].toothInCase.position);
    EXPECT_EQ(read->teeth[0].toothInCase.rotation.coeffs(), example().teeth[0].toothInCase.rotation.coeffs());
    EXPECT_EQ(read->teeth[1].material, test::kDentin);
    EXPECT_EQ(read->around[0].assumed, example().around[0].assumed);
    EXPECT_EQ(read->burs, example().burs);
}

struct Mistake {
    const char* name;
    const char* text;
    const char* said;
};

class CaseMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(CaseMistake, IsSaidWithItsLine) {
    const auto read = parseCase(GetParam().text, "case.toml");
    ASSERT_FALSE(read) << GetParam().text;
    EXPECT_NE(read.error().message().find(GetParam().said), std::string::npos) << read.error().message();
    EXPECT_TRUE(read.error().message().starts_with("case.toml, line ")) << read.error().message();
}

#define TOOTH "format = 1\ntitle = \"t\"\n[[tooth]]\nname = \"a\"\nouter = \"a.stl\"\n"
INSTANTIATE_TEST_SUITE_P(
    All, CaseMistake,
    ::testing::Values(
        Mistake{"NoToml", "format = ", "this is not TOML"},
        Mistake{"NoFormat", "title = \"x\"", "the key 'format' is missing"},
        Mistake{"NewerFormat", "format = 2\ntitle = \"x\"", "newer than this program"},
        Mistake{"NoTooth", "format = 1\ntitle = \"t\"", "there is no [[tooth]]"},
        Mistake{"ToothIsANumber", "format = 1\ntitle = \"t\"\ntooth = 5", "begin each tooth with a line [[tooth]]"},
        Mistake{"NoOuterSurface", "format = 1\ntitle = \"t\"\n[[tooth]]\nname = \"a\"", "the key 'outer' is missing"},
        Mistake{"UnknownKey", TOOTH "colour = 1", "a tooth has no key 'colour'"},
        Mistake{"UnknownTooth", TOOTH "fdi = 19", "19 is no permanent tooth"},
        Mistake{"UnknownMaterial", TOOTH "layers = { bone = \"x.stl\" }", "there is no material 'bone'"},
        Mistake{"LayerOutOfTheCase", TOOTH "layers = { enamel = \"../x.stl\" }", "points out of the case"},
        Mistake{"NoRotation", TOOTH "rotation = [1, 1, 0, 0]", "a quaternion of length 1"},
        Mistake{"TwoNumbers", TOOTH "position = [1, 2]", "must be a list of 3 numbers"},
        Mistake{"NotANumber", TOOTH "position = [nan, 2, 0]", "must be a list of 3 numbers"},
        Mistake{"FarAway", TOOTH "position = [1e9, 2, 0]", "more than 1000 mm away"},
        Mistake{"NotTrueOrFalse", TOOTH "modelled = 1", "must be true or false"},
        Mistake{"TwiceTheName", TOOTH "[[tooth]]\nname = \"a\"\nouter = \"b.stl\"", "is given twice"},
        Mistake{"BurOutOfTheCase", TOOTH "[[bur]]\nfile = \"/etc/passwd\"", "points out of the case"}),
    [](const auto& instance) { return std::string(instance.param.name); });
#undef TOOTH

TEST(CaseDescription, AHugeTextIsRefused) { EXPECT_FALSE(parseCase(std::string(2'000'000, '#'), "case.toml")); }

TEST(CaseDescription, DeepNestingIsRefused) {
    EXPECT_FALSE(parseCase("format = " + std::string(100'000, '['), "case.toml"));
}

}  // namespace
}  // namespace tactooth
