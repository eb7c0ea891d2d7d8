// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/case_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "geometry/stl_writer.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class CaseSurfaceFiles : public ::testing::Test {
protected:
    void put(const std::string& name, double size = 1) {
        fs::create_directories((folder_ / name).parent_path());
        ASSERT_TRUE(writeStl(test::box(Vec3::Zero(), Vec3(size, size, size)), folder_ / name));
    }
    [[nodiscard]] std::string refusal(const std::vector<fs::path>& from) const {
        const auto surfaces = readCaseSurfaces(from);
        return surfaces ? "taken" : surfaces.error().message;
    }

    test::TemporaryFolder folder_;
};

TEST_F(CaseSurfaceFiles, AreSortedIntoTeethAndWhatIsAround) {
    for (const char* const name : {"b/L7.stl", "L6_outer.stl", "L6_pulp.stl", "jaw_bone.stl"}) put(name);
    std::ofstream(folder_ / "notes.txt") << "no surface";
    const auto surfaces = readCaseSurfaces({folder_.path()});
    ASSERT_TRUE(surfaces) << surfaces.error().message;
    ASSERT_EQ(surfaces->teeth.size(), 2u);
    EXPECT_EQ(surfaces->teeth[0].name, "L6");
    EXPECT_FALSE(surfaces->teeth[0].outer.empty());
    ASSERT_EQ(surfaces->teeth[0].layers.size(), 1u);
    EXPECT_EQ(surfaces->teeth[0].layers[0].material, MaterialId::Pulp);
    EXPECT_EQ(surfaces->teeth[1].name, "L7");
    ASSERT_EQ(surfaces->around.size(), 1u);
    EXPECT_EQ(surfaces->around.begin()->first, "jaw_bone");
    EXPECT_THAT(surfaces->files, ElementsAre("L6_outer.stl", "L6_pulp.stl", "L7.stl", "jaw_bone.stl"));
}

TEST_F(CaseSurfaceFiles, OneGivenTwiceIsRefused) {
    for (const char* const name : {"T36.stl", "T36_pulp.stl", "bone.stl"}) put(name);
    for (const char* const name : {"again/T36_outer.stl", "again/T36_pulp.stl", "again/bone.stl"}) {
        put(name, 2);
        const std::string sentence = refusal({folder_.path()});
        EXPECT_THAT(sentence, HasSubstr("has this surface already"));
        EXPECT_THAT(sentence, HasSubstr(fs::path(name).filename().string()));
        fs::remove(folder_ / name);
    }
}

TEST_F(CaseSurfaceFiles, WithoutAToothThereIsNoCase) {
    put("jaw/bone.stl");
    fs::create_directories(folder_ / "empty");
    EXPECT_THAT(refusal({folder_ / "jaw"}), HasSubstr("none of the surfaces is a tooth"));
    EXPECT_THAT(refusal({folder_ / "empty"}), HasSubstr("there is no STL, OBJ or PLY file"));
    EXPECT_THAT(refusal({folder_ / "missing"}), HasSubstr("missing"));
}

TEST_F(CaseSurfaceFiles, AnUnusableOneIsNamed) {
    std::ofstream(folder_ / "bad.stl") << "nothing";
    EXPECT_THAT(refusal({folder_ / "bad.stl"}), HasSubstr("bad.stl"));
}

}  // namespace
}  // namespace tactooth
