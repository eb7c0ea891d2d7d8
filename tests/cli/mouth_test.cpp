// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <fstream>

#include "cli/cli_test.h"
#include "geometry/io/stl_reader.h"
#include "geometry/mesh/mesh_report.h"
#include "support/few_teeth.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using namespace test;

/// The program stores its teeth in a folder of the test.
class MouthCommand : public testing::Test {
protected:
    MouthCommand() { setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1); }
    ~MouthCommand() override { unsetenv("XDG_CACHE_HOME"); }

    test::TemporaryFolder folder_;
};

TEST_F(MouthCommand, WritesAllTeethThatAreLeftAndBothGumsClosed) {
    std::string missing;
    for (const int fdi : allTeethExcept({11, 38, 48})) missing += (missing.empty() ? "" : ",") + std::to_string(fdi);
    const ProgramRun run =
        runTactooth({"mouth", "--out", folder_ / "m", "--triangles", "1000", "--missing", missing, "--jaw", "open"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("3 teeth"));
    for (const char* const name :
         {"m/11/outer.stl", "m/38/enamel.stl", "m/48/pulp.stl", "m/gingiva-upper.stl", "m/gingiva-lower.stl"}) {
        EXPECT_TRUE(reportOn(readStl(folder_ / name).value()).watertight()) << name;
    }
    EXPECT_FALSE(fs::exists(folder_ / "m/46"));
    EXPECT_FALSE(fs::exists(folder_ / "m/18"));
}

TEST_F(MouthCommand, KeepsItsTeethForTheNextTimeUnlessForbidden) {
    const std::vector<std::string> toothCommand = {"tooth", "42", "--out", folder_ / "t", "--triangles", "1000"};
    std::vector<std::string> without = toothCommand;
    without.emplace_back("--no-cache");
    EXPECT_EQ(runTactooth(without).exitCode, 0);
    EXPECT_FALSE(fs::exists(folder_ / "tactooth"));
    EXPECT_EQ(runTactooth(toothCommand).exitCode, 0);
    ASSERT_TRUE(fs::exists(folder_ / "tactooth"));
    for (const fs::directory_entry& kept : fs::directory_iterator(folder_ / "tactooth")) {
        std::ofstream(kept.path()) << "damaged";
    }
    EXPECT_EQ(runTactooth(toothCommand).exitCode, 0);
    EXPECT_TRUE(reportOn(readStl(folder_ / "t/outer.stl").value()).watertight());
}

TEST_F(MouthCommand, DrawsTheMouthFromItsSides) {
    for (const char* const view : {"front", "upper", "40,15"}) {
        const ProgramRun run = runTactooth({"render", "--mouth", "--triangles", "1000", "--view", view, "--size",
                                            "320x200", "--out", folder_ / "p.png"});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_GT(fs::file_size(folder_ / "p.png"), 10000u) << view;
    }
}

TEST_F(MouthCommand, DrawsCheeksLipsAndTongueOfAnOpenMouth) {
    const auto draw = [&](const char* file, const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"render", "--mouth", "--triangles", "1000",  "--view",
                                              "front",  "--size",  "320x200",     "--out", (folder_ / file).string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runTactooth(arguments);
    };
    EXPECT_EQ(draw("jaws.png", {"--jaw", "open"}).exitCode, 0);
    EXPECT_EQ(draw("face.png", {"--jaw", "open", "--soft-tissues"}).exitCode, 0);
    EXPECT_NE(fs::file_size(folder_ / "jaws.png"), fs::file_size(folder_ / "face.png"));
    const ProgramRun closed = draw("closed.png", {"--soft-tissues"});
    EXPECT_EQ(closed.exitCode, 2);
    EXPECT_THAT(closed.err, HasSubstr("--jaw open"));
    EXPECT_FALSE(fs::exists(folder_ / "closed.png"));
}

TEST_F(MouthCommand, RefusesWhatIsNoToothAndNoView) {
    const ProgramRun tooth = runTactooth({"mouth", "--out", folder_ / "m", "--missing", "18,19"});
    EXPECT_EQ(tooth.exitCode, 2);
    EXPECT_THAT(tooth.err, HasSubstr("19 in --missing is no permanent tooth"));
    const ProgramRun view = runTactooth({"render", "--mouth", "--view", "sideways", "--out", folder_ / "p.png"});
    EXPECT_EQ(view.exitCode, 2);
    EXPECT_THAT(view.err, HasSubstr("front, right, left, upper, lower"));
    const ProgramRun seed = runTactooth({"render", "--seed", "3", "--out", folder_ / "p.png"});
    EXPECT_EQ(seed.exitCode, 2);
    EXPECT_THAT(seed.err, HasSubstr("--mouth"));
    const ProgramRun window = runTactooth({"--mouth", "19"});
    EXPECT_EQ(window.exitCode, 2);
    EXPECT_THAT(window.err, HasSubstr("permanent tooth"));
}

}  // namespace
}  // namespace tactooth
