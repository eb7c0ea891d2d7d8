// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/case_names.h"

#include <gtest/gtest.h>

#include "support/materials.h"

namespace tactooth {
namespace {

TEST(CaseNames, NamesTellWhatASurfaceIs) {
    EXPECT_EQ(surfaceNamed("x/L6_enamel.stl").body, "L6");
    EXPECT_EQ(surfaceNamed("x/L6_enamel.stl").material, test::kEnamel);
    EXPECT_EQ(surfaceNamed("L6_whole.stl").body, "L6");
    EXPECT_FALSE(surfaceNamed("L6_whole.stl").material);
    EXPECT_EQ(surfaceNamed("tooth_2_outer.stl").body, "tooth_2");
    EXPECT_EQ(surfaceNamed("my molar.ply").body, "my molar");
    EXPECT_TRUE(surfaceNamed("mandible_cortical_bone.stl").isAdjacent);
    EXPECT_TRUE(surfaceNamed("gum.obj").isAdjacent);
    EXPECT_FALSE(surfaceNamed("bonehead.stl").isAdjacent);
}

TEST(CaseNames, CapitalsDoNotCount) {
    EXPECT_EQ(surfaceNamed("L6_ENAMEL.STL").material, test::kEnamel);
    EXPECT_TRUE(surfaceNamed("GUM.stl").isAdjacent);
}

TEST(CaseNames, TheNumberOfAToothIsTheEndOfItsName) {
    EXPECT_EQ(fdiNamed("T36", std::nullopt), 36);
    EXPECT_EQ(fdiNamed("36", 1), 36);
    EXPECT_EQ(fdiNamed("L6", 3), 36);
    EXPECT_EQ(fdiNamed("L6", std::nullopt), 0);
    EXPECT_EQ(fdiNamed("L9", 3), 0);
    EXPECT_EQ(fdiNamed("T39", std::nullopt), 0);
    EXPECT_EQ(fdiNamed("molar", 3), 0);
    EXPECT_EQ(fdiNamed("", 3), 0);
}

TEST(EntryNames, ArePlainAndNeverTheSame) {
    EntryNames names;
    EXPECT_EQ(names.make("L6"), "L6");
    EXPECT_EQ(names.make("my molar.1"), "my-molar-1");
    EXPECT_EQ(names.make("my-molar-1"), "my-molar-1-2");
    EXPECT_EQ(names.make("l6"), "l6-2") << "some file systems take L6 and l6 for the same";
    EXPECT_EQ(names.make("L6"), "L6-3");
    EXPECT_EQ(names.make("\xe6\xad\xaf"), "---");
    EXPECT_EQ(names.make("\xe5\x8f\xb3"), "----2");
}

TEST(EntryNames, OfALongNameAreShort) {
    EntryNames names;
    EXPECT_EQ(names.make(std::string(200, 'a')), std::string(80, 'a'));
    EXPECT_EQ(names.make(std::string(201, 'a')), std::string(80, 'a') + "-2");
}

TEST(BodyNames, AreTextThatACaseTakes) {
    BodyNames names;
    EXPECT_EQ(names.make("L6"), "L6");
    EXPECT_EQ(names.make("L6"), "L6-2");
    EXPECT_EQ(names.make("a/b\\c\nd"), "a-b-c-d");
    EXPECT_EQ(names.make("a\xCC\x88"), "\xC3\xA4");
    EXPECT_EQ(names.make("Z\xE4hne"), "Z\xEF\xBF\xBDhne");
    EXPECT_EQ(names.make("Z\xE5hne"), "Z\xEF\xBF\xBDhne-2");  // another file
}

TEST(BodyNames, AreCutBetweenLetters) {
    BodyNames names;
    std::string teeth;
    for (int i = 0; i < 40; ++i) teeth += "\xE6\xAD\xAF";
    EXPECT_EQ(names.make(teeth), teeth.substr(0, 54));
    EXPECT_EQ(names.make(teeth), teeth.substr(0, 54) + "-2");
    EXPECT_LE(names.make(std::string(300, 'x')).size(), 60u);
}

}  // namespace
}  // namespace tactooth
