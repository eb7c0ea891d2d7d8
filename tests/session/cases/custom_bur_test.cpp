// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/custom_bur.h"

#include <gtest/gtest.h>

#include <fstream>

#include "geometry/io/stl_writer.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

class CustomBurFiles : public ::testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(writeStl(test::cylinder(Vec3::Zero(), 0.6, 5, 24), folder_ / "mine.stl")); }
    void describe(const std::string& text) const { std::ofstream(folder_ / "mine.toml") << text; }

    test::TemporaryFolder folder_;
};

TEST_F(CustomBurFiles, ASurfaceAloneIsASharpCarbideBur) {
    const auto bur = readCustomBur(folder_ / "mine.stl");
    ASSERT_TRUE(bur);
    EXPECT_EQ(bur->name, "mine.stl");
    EXPECT_EQ(bur->material, BurMaterial::Carbide);
    EXPECT_EQ(bur->sharpness, 1);
}

TEST_F(CustomBurFiles, TheDescriptionBesideItCounts) {
    describe("name = \"My bur\"\nmaterial = \"carbide\"\nflutes = 12\nsharpness = 0.7\n");
    for (const char* const file : {"mine.stl", "mine.toml"}) {
        if (std::string(file) == "mine.toml") {
            describe("surface = \"mine.stl\"\nname = \"My bur\"\nflutes = 12\nsharpness = 0.7\n");
        }
        const auto bur = readCustomBur(folder_ / file);
        ASSERT_TRUE(bur) << bur.error().message();
        EXPECT_EQ(bur->name, "My bur");
        EXPECT_EQ(bur->flutes, 12);
        EXPECT_EQ(bur->sharpness, 0.7);
        EXPECT_FALSE(bur->surface.empty());
    }
}

TEST_F(CustomBurFiles, WhatIsWrittenIsRead) {
    CustomBur bur;
    bur.name = "My \"fine\" bur";
    bur.material = BurMaterial::Diamond;
    bur.flutes = 0;
    bur.gritMicrometres = 106.5;
    bur.sharpness = 0.725;
    describe(customBurText(bur, "mine.stl"));
    const auto read = readCustomBur(folder_ / "mine.toml");
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->name, bur.name);
    EXPECT_EQ(read->material, bur.material);
    EXPECT_EQ(read->flutes, 0);
    EXPECT_EQ(read->gritMicrometres, 106.5);
    EXPECT_EQ(read->sharpness, 0.725);
}

TEST_F(CustomBurFiles, APathThatCannotBeLookedUpIsRefusedWithASentence) {
    const auto bur = readCustomBur(folder_ / (std::string(300, 'a') + ".stl"));  // longer than a name may be
    ASSERT_FALSE(bur);
    EXPECT_NE(bur.error().message().find("aaa"), std::string::npos);
}

TEST_F(CustomBurFiles, MistakesAreSaid) {
    for (const auto& [text, said] :
         {std::pair("material = \"wood\"", "'material' must be carbide or diamond"),
          std::pair("sharpness = -1", "'sharpness' must be a number from 0 to 10"),
          std::pair("flutes = 1.5", "'flutes' must be a whole number"),
          std::pair("colour = 1", "a bur has no key 'colour'"),
          std::pair("surface = \"../../other.stl\"", "must lie beside this file"),
          std::pair("surface = \"none.stl\"", "none.stl"), std::pair("= 3", "this is not TOML")}) {
        describe(text);
        const auto bur = readCustomBur(folder_ / "mine.stl");
        ASSERT_FALSE(bur) << text;
        EXPECT_NE(bur.error().message().find(said), std::string::npos) << bur.error().message();
    }
}

}  // namespace
}  // namespace tactooth
