// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/bur_by_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/io/stl_writer.h"
#include "instruments/bur_shape.h"
#include "session/model/session_bur.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

/// A folder to work in that has files with the names of burs.
class BurByName : public ::testing::Test {
protected:
    void SetUp() override {
        const TriangleMesh rod = test::cylinder(Vec3::Zero(), 0.6, 5, 24);
        for (const char* const name : {"57", "rod", "rod.stl"}) ASSERT_TRUE(writeStl(rod, folder_ / name));
        std::filesystem::current_path(folder_.path());
    }
    void TearDown() override { std::filesystem::current_path(before_); }

    std::filesystem::path before_ = std::filesystem::current_path();
    test::TemporaryFolder folder_;
};

TEST_F(BurByName, EveryNumberOfTheCatalogueIsItsBur) {
    for (const BurSpec& spec : burCatalogue()) {
        for (const std::string& number : {spec.number, isoNumber(spec)}) {
            const Expected<CustomBur> bur = findOrReadBur(number);
            ASSERT_TRUE(bur) << number << ": " << bur.error().message();
            EXPECT_EQ(bur->material, spec.material) << number;
            EXPECT_EQ(bur->flutes, spec.flutes) << number;
            EXPECT_EQ(bur->sharpness, spec.sharpness) << number;
            EXPECT_FALSE(bur->surface.empty()) << number;
        }
        EXPECT_EQ(findOrReadBur(spec.number).value().name, spec.name);
        EXPECT_EQ(findOrReadBur(spec.number).value().gritMicrometres, spec.gritMicrometres);
    }
}

TEST_F(BurByName, TheNumberComesBeforeTheFile) {
    EXPECT_EQ(findOrReadBur("57").value().name, findBur("57")->name);
    EXPECT_EQ(findOrReadBur("./57").value().name, "57");
    EXPECT_EQ(findOrLoadTool("57").value()->mesh().triangles.size(), makeBur(*findBur("57")).surface.triangles.size());
    EXPECT_LT(findOrLoadTool("./57").value()->mesh().triangles.size(), 200U);
}

TEST_F(BurByName, AFileNeedsNoEnding) {
    EXPECT_EQ(findOrReadBur("rod").value().name, "rod");
    EXPECT_EQ(findOrReadBur("rod.stl").value().name, "rod.stl");
    EXPECT_TRUE(findOrLoadTool("rod"));
}

TEST_F(BurByName, WhatIsNeitherIsNamed) {
    for (const char* const name : {"58b", "round", "0", "500 314 107 006", ""}) {
        for (const Error& error :
             {findOrReadBur(name).error(), findOrLoadTool(name).error(), findOrLoadSessionBur(name).error()}) {
            EXPECT_THAT(error.message(), HasSubstr("neither a bur of this number nor a file of this name")) << name;
        }
    }
    EXPECT_THAT(findOrReadBur("none.stl").error().message(), HasSubstr("there is no such file"));
}

TEST_F(BurByName, ASessionKnowsWhetherItsBurIsOfTheCatalogue) {
    const Expected<SessionBur> listed = findOrLoadSessionBur("57"), own = findOrLoadSessionBur("rod.stl");
    ASSERT_TRUE(listed && own);
    EXPECT_TRUE(listed->file.empty());
    EXPECT_EQ(listed->name, findBur("57")->name);
    EXPECT_EQ(own->file, "rod.stl");
}

}  // namespace
}  // namespace tactooth
