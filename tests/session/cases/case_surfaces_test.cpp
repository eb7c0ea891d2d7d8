// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/case_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "geometry/io/stl_writer.h"
#include "support/materials.h"
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
        return surfaces ? "taken" : surfaces.error().message();
    }

    test::TemporaryFolder folder_;
};

TEST_F(CaseSurfaceFiles, AreSortedIntoTeethAndWhatIsAround) {
    for (const char* const name : {"b/L7.stl", "L6_outer.stl", "L6_pulp.stl", "jaw_bone.stl"}) put(name);
    std::ofstream(folder_ / "notes.txt") << "no surface";
    const auto surfaces = readCaseSurfaces({folder_.path()});
    ASSERT_TRUE(surfaces) << surfaces.error().message();
    ASSERT_EQ(surfaces->teeth.size(), 2u);
    EXPECT_EQ(surfaces->teeth[0].name, "L6");
    EXPECT_FALSE(surfaces->teeth[0].outer.empty());
    ASSERT_EQ(surfaces->teeth[0].layers.size(), 1u);
    EXPECT_EQ(surfaces->teeth[0].layers[0].material, test::kPulp);
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

TEST_F(CaseSurfaceFiles, HiddenAndForeignFilesArePassedOver) {
    put("36.stl");
    for (const char* const name : {"._36.stl", ".DS_Store", "Thumbs.db", "desktop.ini", ".Trash/37.stl",
                                   "__MACOSX/._36.stl", "__MACOSX/37.stl", ".hidden.obj"}) {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << "no surface";
    }
    const auto surfaces = readCaseSurfaces({folder_.path()});
    ASSERT_TRUE(surfaces) << surfaces.error().message();
    EXPECT_THAT(surfaces->files, ElementsAre("36.stl"));
}

TEST_F(CaseSurfaceFiles, AFolderThatIsNamedMayBeHiddenItself) {
    put(".scans/36.stl");
    EXPECT_TRUE(readCaseSurfaces({folder_ / ".scans"}));
}

TEST_F(CaseSurfaceFiles, HandOnWhatReadingThemSays) {
    std::ofstream(folder_ / "36.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nwhat\n";
    std::ofstream(folder_ / "jaw.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nwhat\n";
    const auto surfaces = readCaseSurfaces({folder_.path()});
    ASSERT_TRUE(surfaces) << surfaces.error().message();
    ASSERT_EQ(surfaces->teeth[0].importNotes.size(), 1u);
    EXPECT_EQ(surfaces->teeth[0].importNotes[0].topic, ImportNoteTopic::File);
    EXPECT_THAT(inWords(surfaces->teeth[0].importNotes[0]), testing::StartsWith("36.obj: line 5 was not understood"));
    EXPECT_EQ(surfaces->aroundImportNotes.at("jaw").size(), 1u);
}

TEST_F(CaseSurfaceFiles, FarFromZeroStayInOneFrame) {
    const auto write = [&](const char* name, int x) {
        std::ofstream(folder_ / name) << "v " << x << ".001 0 0\nv " << x + 9 << ".001 0 0\nv " << x
                                      << ".001 20 0\nf 1 2 3\n";
    };
    write("36.obj", 1000000);
    write("37.obj", 1000010);
    const auto surfaces = readCaseSurfaces({folder_.path()});
    ASSERT_TRUE(surfaces) << surfaces.error().message();
    const Vec3f apart = surfaces->teeth[1].outer.vertices[0] - surfaces->teeth[0].outer.vertices[0];
    EXPECT_NEAR(apart.x(), 10, 1e-5);
}

}  // namespace
}  // namespace tactooth
