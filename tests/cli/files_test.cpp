// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Files from other programs and systems, tested as a user would use them.
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/motion_files.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using namespace test;

/// A U-shaped bar, 20 mm high: its slot is open toward +y and +z.
std::string slottedBar(const std::string& before = "", const std::string& after = "") {
    const std::array<std::array<int, 2>, 8> outline = {
        {{5, -4}, {5, 4}, {2, 4}, {2, -1}, {-2, -1}, {-2, 4}, {-5, 4}, {-5, -4}}};
    std::string text = before;
    for (const int z : {0, 20}) {
        for (const auto& [x, y] : outline)
            text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    }
    text += "f 8 7 6 5 4 3 2 1\nf 9 10 11 12 13 14 15 16\n";
    for (int i = 1; i <= 8; ++i) {
        const int next = i % 8 + 1;
        text += "f " + std::to_string(i) + " " + std::to_string(next) + " " + std::to_string(next + 8) + " " +
                std::to_string(i + 8) + "\n";
    }
    return text + after;
}

class Files : public test::MotionFiles {
protected:
    fs::path put(const std::string& name, const std::string& text) {
        const fs::path path = fs::path(out()).parent_path() / name;
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }
    static nlohmann::json info(const fs::path& file) {
        const ProgramRun run = runTactooth({"info", "--json", file});
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return nlohmann::json::parse(run.out);
    }
};

TEST_F(Files, ASlotIsFreeWhateverCornerItsLidBeginsWith) {
    const fs::path tooth = put("u.obj", slottedBar());
    EXPECT_NEAR(info(tooth)["area"].get<double>(), 1040, 1e-9);
    EXPECT_NEAR(info(tooth)["volume"].get<double>(), 1200, 1e-9);
    // In the slot, at the end of the slot, across it, in the wall, above.
    const std::string poses = trajectory({{0, 0, 2, 18}, {1, 0, 2, 19.5}, {2, 0, -2.5, 10}, {3, 0, 2, 22}});
    const ProgramRun run =
        runTactooth({"contact", "--tooth", tooth, "--tool", ball(), "--poses", poses, "--out", out()});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(table().at(0, "touching"), 0);
    EXPECT_EQ(table().at(1, "touching"), 0);
    EXPECT_EQ(table().at(2, "touching"), 1);
    EXPECT_EQ(table().at(3, "touching"), 0);
}

TEST_F(Files, InfoSaysWhatWasPassedOver) {
    const fs::path tooth = put("u.obj", slottedBar("\xEF\xBB\xBF", "what is this\n"));
    const ProgramRun run = runTactooth({"info", tooth});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, HasSubstr("  Reading       u.obj: line 27 was not understood and passed over"));
    EXPECT_THAT(run.err, IsEmpty());
    EXPECT_EQ(info(tooth)["remarks"].size(), 1u);
    EXPECT_EQ(info(put("good.obj", slottedBar()))["remarks"].size(), 0u);
}

TEST_F(Files, OtherCommandsSayItOnceOnStderr) {
    const fs::path tooth = put("u.obj", slottedBar("", "what is this\n"));
    const std::string poses = trajectory({{0, 0, 2, 18}});
    const std::string wanted = "tactooth: u.obj: line 27 was not understood and passed over; it begins with 'what'.\n";
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"contact", "--tooth", tooth, "--tool", ball(), "--poses", poses, "--out", out()},
          {"feel", "--tooth", tooth, "--tool", ball(), "--trajectory", poses, "--out", out()},
          {"subdivide", tooth, "--out", out() + ".stl"}}) {
        const ProgramRun run = runTactooth(arguments);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_THAT(run.err, HasSubstr(wanted)) << arguments.front();
    }
}

TEST_F(Files, AFarSurfaceIsReportedWhereItIsAndRefusedWhereItsPlaceCounts) {
    std::string text;
    for (const char* const corner : {"0.001 0 0", "9.001 0 0", "0.001 9 0", "0.001 0 9"})
        text += "v 100000" + std::string(corner) + "\n";
    const fs::path tooth = put("far.obj", text + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    const nlohmann::json report = info(tooth);
    EXPECT_NEAR(report["volume"].get<double>(), 729.0 / 6, 1e-3);
    EXPECT_NEAR(report["box"]["min"][0].get<double>(), 1000000.001, 1e-5);
    EXPECT_THAT(report["remarks"][0].get<std::string>(), HasSubstr("too far from zero for single precision"));
    const ProgramRun run = runTactooth(
        {"contact", "--tooth", tooth, "--tool", ball(), "--poses", trajectory({{0, 0, 2, 18}}), "--out", out()});
    expectRefused(run, "far.obj: the surface lies too far from zero for single precision");
}

TEST_F(Files, NamesThatAreNoUtf8MakeACaseThatOpens) {
    const fs::path folder = fs::path(out()).parent_path() / "scan";
    fs::create_directories(folder);
    double x = 0;
    for (const char* const name : {"Z\xE4hne", "Z\xE5hne", "\x8E\x95", "a\nb", "\xC3"}) {
        ASSERT_TRUE(writeStl(box(Vec3(x - 4, -4, -12), Vec3(x + 4, 4, 8)), folder / (std::string(name) + ".stl")));
        x += 10;
    }
    for (const char* const to : {"case", "case.ttcase"}) {
        const fs::path made = folder.parent_path() / to;
        const ProgramRun run = runTactooth({"case", "new", made, "--from", folder, "--no-model", "--title", "M\xFCller",
                                            "--licence", "\xA9", "--provenance", "\xFF\xFE"});
        ASSERT_EQ(run.exitCode, 0) << run.err;
        const ProgramRun opened = runTactooth({"case", "check", made});
        EXPECT_EQ(opened.exitCode, 0) << opened.err;
        EXPECT_THAT(runTactooth({"case", "info", made}).out, HasSubstr("M\xEF\xBF\xBDller"));
    }
}

TEST_F(Files, HiddenFilesAmongScansArePassedOver) {
    const fs::path folder = put("scan/._36.stl", "no surface").parent_path();
    put("scan/.DS_Store", "no surface");
    put("scan/Thumbs.db", "no surface");
    put("scan/__MACOSX/37.stl", "no surface");
    ASSERT_TRUE(writeStl(box(Vec3(-4, -4, -12), Vec3(4, 4, 8)), folder / "36.stl"));
    const fs::path made = folder.parent_path() / "case.ttcase";
    const ProgramRun run = runTactooth({"case", "new", made, "--from", folder, "--no-model"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("1 teeth"));
}

TEST_F(Files, CaseNewKeepsWhatReadingTheFilesSaid) {
    const fs::path made = fs::path(out()).parent_path() / "case.ttcase";
    const fs::path tooth = put("36.obj", slottedBar("", "what is this\n"));
    const ProgramRun run = runTactooth({"case", "new", made, "--from", tooth, "--no-model"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("    36.obj: line 27 was not understood and passed over"));
    EXPECT_THAT(runTactooth({"case", "info", made}).out, HasSubstr("36.obj: line 27 was not understood"));
}

}  // namespace
}  // namespace tactooth
