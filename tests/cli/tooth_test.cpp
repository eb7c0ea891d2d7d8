// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_test.h"
#include "geometry/io/stl_reader.h"
#include "geometry/mesh/mesh_report.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using namespace test;

TEST(ToothCommand, WritesClosedLayers) {
    const test::TemporaryFolder folder;
    const ProgramRun run = runTactooth({"tooth", "25", "--out", folder / "t", "--triangles", "3000", "--seed", "3"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Upper left second premolar (FDI 25)"));
    for (const char* const name : {"t/outer.stl", "t/enamel.stl", "t/dentin.stl", "t/pulp.stl"}) {
        EXPECT_TRUE(reportOn(readStl(folder / name).value()).watertight()) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "t/caries.stl"));
}

TEST(ToothCommand, AddsDecayWhenAskedFor) {
    const test::TemporaryFolder folder;
    const ProgramRun run = runTactooth({"tooth", "46", "--out", folder / "t", "--triangles", "3000", "--caries",
                                        "mesial", "--caries-width", "1.5", "--caries-depth", "2"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(reportOn(readStl(folder / "t/caries.stl").value()).watertight());
}

TEST(ToothCommand, RefusesNumbersThatAreNoTooth) {
    const ProgramRun run = runTactooth({"tooth", "19", "--out", "nowhere"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("19 is no permanent tooth"));
    EXPECT_FALSE(std::filesystem::exists("nowhere"));
}

TEST(ToothCommand, RefusesOcclusalDecayOfAnAnteriorTooth) {
    const ProgramRun run = runTactooth({"tooth", "11", "--out", "nowhere", "--caries", "occlusal"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("anterior tooth"));
}

TEST(GalleryCommand, DrawsTheTeethThatAreAskedFor) {
    const test::TemporaryFolder folder;
    const ProgramRun run = runTactooth({"gallery", "--out", folder / "g", "--teeth", "36", "--triangles", "2000"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_GT(std::filesystem::file_size(folder / "g/teeth.png"), 20000u);
}

TEST(GalleryCommand, RefusesOptionsOfTeethWithExercises) {
    const test::TemporaryFolder folder;
    const std::vector<std::vector<std::string>> ofTeeth = {
        {"--teeth", "36"}, {"--triangles", "2000"}, {"--seed", "1"}, {"--no-cache"}};
    for (const std::vector<std::string>& options : ofTeeth) {
        std::vector<std::string> arguments = {"gallery", "--out", folder / "g", "--exercises"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramRun run = runTactooth(arguments);
        EXPECT_EQ(run.exitCode, 2) << options.front();
        EXPECT_NE(run.err.find(options.front()), std::string::npos) << run.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "g"));
    }
}

}  // namespace
}  // namespace tactooth
