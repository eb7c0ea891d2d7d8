// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "geometry/io/stl_writer.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using namespace test;

class Info : public ::testing::Test {
protected:
    std::string withBox(const std::string& name) {
        EXPECT_TRUE(writeStl(test::box(Vec3(0, 0, 0), Vec3(1, 2, 3)), folder_ / name));
        return folder_ / name;
    }
    std::string withText(const std::string& name, std::string_view text) {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }
    const test::TemporaryFolder& folder() const { return folder_; }

private:
    test::TemporaryFolder folder_;
};

TEST_F(Info, TableSaysWhatASoundSurfaceIsLike) {
    const ProgramRun run = runTactooth({"info", withBox("box.stl")});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, IsEmpty());
    EXPECT_EQ(run.out, (folder() / "box.stl").string() +
                           "\n"
                           "  Triangles     12\n"
                           "  Vertices      8\n"
                           "  Size          1.00 x 2.00 x 3.00 mm\n"
                           "  Closed        yes\n"
                           "  Orientation   outward\n"
                           "  Shells        1\n"
                           "  Tunnels       0\n"
                           "  Volume        6.00 mm3\n"
                           "  Surface area  22.00 mm2\n"
                           "  Findings      none\n");
}

/// A body of 4 x 4 x 12 mm, thicker at the end toward -y.
TriangleMesh lyingWedge() {
    TriangleMesh mesh = test::box(Vec3(-2, -6, -2), Vec3(2, 6, 2));
    for (Vec3f& vertex : mesh.vertices) {
        if (vertex.y() > 0) vertex = Vec3f(vertex.x() / 2, vertex.y(), vertex.z() / 2);
    }
    return mesh;
}

TEST_F(Info, ATiltedBodyIsSaidToBeTilted) {
    ASSERT_TRUE(writeStl(lyingWedge(), folder() / "wedge.stl"));
    EXPECT_THAT(runTactooth({"info", folder() / "wedge.stl"}).out,
                HasSubstr("  Long axis     thicker end 90 degrees from +z\n"));
    const auto json = nlohmann::json::parse(runTactooth({"info", "--json", folder() / "wedge.stl"}).out);
    EXPECT_NEAR(json["crown_tilt_degrees"].get<double>(), 90, 0.1);
    const ProgramRun picture = runTactooth(
        {"render", "--tooth", folder() / "wedge.stl", "--out", folder() / "wedge.png", "--size", "160x120"});
    EXPECT_EQ(picture.exitCode, 0);
    EXPECT_THAT(picture.err, AllOf(HasSubstr("90 degrees away from +z"), HasSubstr("case new")));
}

TEST_F(Info, TableNamesWeaknessesAndIsStillASuccess) {
    TriangleMesh open = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    open.triangles.pop_back();
    ASSERT_TRUE(writeStl(open, folder() / "open.stl"));
    const ProgramRun run = runTactooth({"info", folder() / "open.stl"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("Closed        no, 3 open edges"), HasSubstr("Volume        none"),
                               HasSubstr("Findings      3 edges are open"), Not(HasSubstr("Tunnels"))));
}

TEST_F(Info, JsonHoldsTheNumbers) {
    const ProgramRun run = runTactooth({"info", "--json", withBox("Моляр.stl")});
    EXPECT_EQ(run.exitCode, 0);
    const nlohmann::json json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json["file"], (folder() / "Моляр.stl").string());
    EXPECT_EQ(json["triangles"], 12);
    EXPECT_EQ(json["vertices"], 8);
    EXPECT_EQ(json["box"]["size"], nlohmann::json({1.0, 2.0, 3.0}));
    EXPECT_TRUE(json["crown_tilt_degrees"].is_null());
    EXPECT_EQ(json["closed"], true);
    EXPECT_EQ(json["volume"], 6.0);
    EXPECT_EQ(json["area"], 22.0);
    EXPECT_EQ(json["genus"], 0);
    EXPECT_EQ(json["shells"].size(), 1U);
    EXPECT_TRUE(json["findings"].empty());
}

TEST_F(Info, JsonOfAnOpenSurfaceHasNoVolume) {
    TriangleMesh open = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    open.triangles.pop_back();
    ASSERT_TRUE(writeStl(open, folder() / "open.stl"));
    const nlohmann::json json = nlohmann::json::parse(runTactooth({"info", folder() / "open.stl", "--json"}).out);
    EXPECT_TRUE(json["volume"].is_null());
    EXPECT_EQ(json["boundary_edges"], 3);
}

TEST_F(Info, JsonOfSeveralFilesIsOneLineEach) {
    const ProgramRun run = runTactooth({"info", withBox("a.stl"), withBox("b.stl"), "--json"});
    std::istringstream lines(run.out);
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) names.push_back(nlohmann::json::parse(line)["file"]);
    EXPECT_EQ(names, (std::vector<std::string>{folder() / "a.stl", folder() / "b.stl"}));
}

TEST_F(Info, EveryUnreadableFileIsOneSentence) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {withText("empty.stl", ""), "the file is empty"},
        {withText("garbage.stl", "solid x\nfacet wrong\n"), "line 2: expected 'normal', but found 'wrong'"},
        {withText("nan.stl", "solid x\nfacet normal 0 0 1 outer loop vertex nan 0 0\n"),
         "expected a finite coordinate"},
        {withText("short.stl", std::string(80, '\1') + std::string("\5\0\0\0", 4)), "the file is cut short"},
        {withText("other.txt", "hello\n"), "not an STL surface"},
        {folder() / "missing.stl", "there is no such file"},
        {folder().path(), "this is a folder"}};
    for (const auto& [file, sentence] : cases) {
        SCOPED_TRACE(file);
        const ProgramRun run = runTactooth({"info", file});
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_THAT(run.out, IsEmpty());
        EXPECT_THAT(run.err, AllOf(StartsWith("tactooth: " + file), HasSubstr(sentence)));
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    }
}

TEST_F(Info, TheOtherFilesAreShownBesideAnUnreadableOne) {
    const ProgramRun run = runTactooth({"info", folder() / "missing.stl", withBox("box.stl")});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("missing.stl: there is no such file"));
    EXPECT_THAT(run.out, HasSubstr("Triangles     12"));
}

}  // namespace
}  // namespace tactooth
