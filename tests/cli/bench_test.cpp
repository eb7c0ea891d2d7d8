// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <nlohmann/json.hpp>

#include "cli/motion_files.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

using namespace test;

class BenchCommand : public test::MotionFiles {
protected:
    std::vector<std::string> contact(std::vector<std::string> more) {
        std::vector<std::string> arguments = {"bench",  "contact", "--tooth",  plate(),
                                              "--tool", ball(),    "--repeat", "1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
};

TEST_F(BenchCommand, TableSaysWhatWasMeasuredWhereAndHow) {
    const ProgramRun run = runTactooth(contact({"--resolution", "100"}));
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("machine:"), HasSubstr("compiler:"), HasSubstr("commit:"),
                               HasSubstr("bench contact --tooth"), HasSubstr("p99.9"), HasSubstr("plate ")));
}

TEST_F(BenchCommand, JsonHoldsOneCaseForEachResolutionAndSpeed) {
    const ProgramRun run = runTactooth(contact({"--json", "--resolution", "100", "--resolution", "50"}));
    EXPECT_EQ(run.exitCode, 0);
    const auto json = nlohmann::json::parse(run.out);
    for (const char* key : {"machine", "compiler", "commit", "command", "date"}) EXPECT_NE(json.at(key), "");
    EXPECT_EQ(json.at("tool_triangles"), 960);
    ASSERT_EQ(json.at("cases").size(), 4U);
    EXPECT_EQ(json["cases"][0].at("percent"), 50);
    EXPECT_EQ(json["cases"][3].at("percent"), 100);
    EXPECT_EQ(json["cases"][3].at("mm_per_s"), 100);
    for (const auto& one : json["cases"]) {
        EXPECT_GT(one.at("in_contact"), 100);
        EXPECT_GT(one.at("p50_us"), 0);
        EXPECT_LE(one.at("p50_us"), one.at("p99_us"));
        EXPECT_LE(one.at("p99_us"), one.at("p999_us"));
        EXPECT_LE(one.at("p999_us"), one.at("max_us"));
        EXPECT_GE(one.at("contacts"), 1);
        EXPECT_GE(one.at("rounds"), 1);
    }
}

TEST_F(BenchCommand, RefusesWhatItCannotMeasure) {
    expectRefused(runTactooth({"bench", "contact", "--tooth", missing()}), "missing: there is no such file");
    TriangleMesh open = test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0));
    open.triangles.pop_back();
    const std::string file = text("open.stl", "");
    ASSERT_TRUE(writeStl(open, file));
    expectRefused(runTactooth({"bench", "contact", "--tooth", file}), "measure it with --resolution 100");
    EXPECT_EQ(runTactooth({"bench", "contact", "--tooth", file, "--resolution", "100", "--repeat", "1"}).exitCode, 0);
    expectRefused(runTactooth({"bench", "contact", "--resolution", "0"}), "see 'tactooth bench contact --help'");
    expectRefused(runTactooth({"bench"}), "see 'tactooth bench --help'");
}

TEST_F(BenchCommand, CutSaysWhatATickAndANewSurfaceCost) {
    const ProgramRun run = runTactooth(
        {"bench", "cut", "--tooth", plate(), "--voxel", "100", "--diameter", "0.5", "--diameter", "1", "--json"});
    EXPECT_EQ(run.exitCode, 0);
    const auto json = nlohmann::json::parse(run.out);
    for (const char* key : {"machine", "compiler", "commit", "command", "date"}) EXPECT_NE(json.at(key), "");
    ASSERT_EQ(json.at("cases").size(), 2U);
    EXPECT_EQ(json["cases"][0].at("diameter_mm"), 0.5);
    EXPECT_EQ(json["cases"][1].at("voxel_um"), 100);
    // The bur moves in real time. Under a sanitizer the cut follows ten times slower, and less is removed at the end.
    const double leastRemoved = test::isSanitized() ? 0.0 : 0.5;
    const int leastUpdates = test::isSanitized() ? 0 : 20;
    for (const auto& one : json["cases"]) {
        EXPECT_GT(one.at("removed_mm3"), leastRemoved);
        EXPECT_GT(one.at("updates"), leastUpdates);
        EXPECT_GT(one.at("tick_p50_us"), 0);
        EXPECT_LE(one.at("tick_p50_us"), one.at("tick_p999_us"));
        EXPECT_GE(one.at("felt_p50_ms"), 1) << "a tick cannot feel what it has asked for itself";
        EXPECT_LE(one.at("update_p50_ms"), one.at("update_max_ms"));
    }
}

TEST_F(BenchCommand, SlotSaysHowAToolFaresInIt) {
    const ProgramRun run = runTactooth({"bench", "slot", "--tooth", plate(), "--voxel", "100", "--json"});
    EXPECT_EQ(run.exitCode, 0);
    const auto json = nlohmann::json::parse(run.out);
    for (const char* key : {"machine", "compiler", "commit", "command", "date"}) EXPECT_NE(json.at(key), "");
    std::string tools;
    for (const auto& one : json.at("cases")) {
        tools += one.at("tool").get<std::string>() + ' ' + one.at("motion").get<std::string>() + ';';
        EXPECT_GT(one.at("tick_p50_us"), 0);
        EXPECT_TRUE(one.at("leaves").get<bool>());
    }
    EXPECT_EQ(tools,
              "bur rests;bur trembles;bur slides;bur turns;probe rests;probe trembles;probe slides;probe turns;");
}

TEST_F(BenchCommand, CutRefusesAToothWithoutAnInside) {
    TriangleMesh open = test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0));
    open.triangles.pop_back();
    const std::string file = text("open.stl", "");
    ASSERT_TRUE(writeStl(open, file));
    expectRefused(runTactooth({"bench", "cut", "--tooth", file}), "is open (3 edges");
    expectRefused(runTactooth({"bench", "cut", "--voxel", "0"}), "see 'tactooth bench cut --help'");
}

/// The times of such small frames mean nothing. The test checks that each scene is drawn in each of its variants.
TEST_F(BenchCommand, ViewHoldsACuttingBurAgainstOneThatOnlyMoves) {
    if (isSanitized()) GTEST_SKIP() << "draws a whole mouth, which takes minutes under a sanitizer";
    const ProgramRun run = runTactooth({"bench", "view", "--size", "160x100", "--frames", "2", "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    std::map<std::string, std::vector<std::string>> drawn;
    const auto json = nlohmann::json::parse(run.out);
    for (const auto& one : json["cases"]) {
        EXPECT_GT(one["processor_ms"].get<double>(), 0);
        EXPECT_GT(one["pictures_per_s"].get<double>(), 0);
        drawn[one["scene"]].push_back(one["drawn"]);
        if (drawn[one["scene"]].size() == 1) {
            EXPECT_EQ(one["of_first"].get<double>(), 1);
            EXPECT_EQ(one["of_first_by_rate"].get<double>(), 1);
        }
    }
    EXPECT_EQ(json["software"].get<bool>(), json["opengl"].get<std::string>().find("llvmpipe") != std::string::npos);
    const std::vector<std::string> atWork = {"bur moves", "bur cuts", "with second view", "with ghost of target"};
    EXPECT_EQ(drawn["molar, work"], atWork);
    EXPECT_EQ(drawn["tooth, work"], std::vector(atWork.begin(), atWork.end() - 1));
    const std::vector<std::string> settings = {"bare, in one colour", "light and shadow", "antialiased edges",
                                               "smooth edges, soft", "all of it"};
    EXPECT_EQ(drawn["tooth"], settings);
    EXPECT_EQ(drawn["mouth"].size(), 3U);
}

}  // namespace
}  // namespace tactooth
