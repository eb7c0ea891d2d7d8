// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Obstacles to output: files that are closed, full or too long, and names that are already in use.
#include <sys/wait.h>

#include <cstdlib>

#include "cli/motion_files.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;
namespace fs = std::filesystem;

class Endings : public MotionFiles {
protected:
    /// Runs `arguments` in a shell with `around` after them. Returns the exit code and the text on stderr.
    ProgramRun inShell(const std::string& arguments, const std::string& around, const std::string& before = "") {
        const std::string line = before + " '" TACTOOTH_PROGRAM "' " + arguments + " 2>'" + file("err") + "' " + around;
        const int status = std::system(line.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, WIFSIGNALED(status) ? WTERMSIG(status) : 0, "",
                readText(file("err"))};
    }

    static void expectOneSentence(const ProgramRun& run, const std::string& part) {
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_THAT(run.err, AllOf(StartsWith("tactooth: "), HasSubstr(part)));
        EXPECT_TRUE(run.err.ends_with(".\n")) << run.err;
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    }

    /// Commands that succeed, with their output.
    std::vector<std::pair<std::string, std::string>> commands() {
        std::vector<Row> rows;
        for (int i = 0; i < 50; ++i) rows.push_back({0.001 * i, 0, 0, 0.2 - 0.01 * i});
        const std::string way = trajectory(rows);
        const std::string common = " --tooth " + plate() + " --tool " + ball();
        return {{"info " + plate(), ""},
                {"--help", ""},
                {"bur --list", ""},
                {"bur 57 --out " + file("bur.stl"), "bur.stl"},
                {"contact" + common + " --poses " + way + " --out " + file("contact.csv"), "contact.csv"},
                {"feel" + common + " --trajectory " + way + " --out " + file("feel.csv"), "feel.csv"},
                {"cut" + common + " --trajectory " + way + " --speed-rpm 300000 --voxel 0.2 --out " + file("cut.stl"),
                 "cut.stl"}};
    }
};

TEST_F(Endings, AFullOutputIsOneSentenceAndWhatWasMadeIsThere) {
    for (const auto& [command, output] : commands()) {
        SCOPED_TRACE(command);
        expectOneSentence(inShell(command, ">/dev/full"), "the output could not be written");
        if (!output.empty()) {
            EXPECT_TRUE(fs::exists(file(output)));
        }
    }
}

TEST_F(Endings, APipeThatNobodyReadsIsNoCrash) {
    for (const auto& [command, output] : commands()) {
        SCOPED_TRACE(command);
        const ProgramRun run = inShell(command, "| true");  // the shell returns the exit code of the last command
        EXPECT_EQ(run.exitCode, 0);
        EXPECT_THAT(run.err, Not(HasSubstr("terminate")));
        EXPECT_LE(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        if (!output.empty()) {
            EXPECT_TRUE(fs::exists(file(output)));
        }
    }
}

TEST_F(Endings, WhoClosesTheOutputWantsNoneAndNoFileIsTakenForIt) {
    for (const auto& [command, output] : commands()) {
        for (const std::string closed : {">&-", ">&- <&-", "2>&- >&- <&-"}) {
            SCOPED_TRACE(command + closed);
            if (!output.empty()) fs::remove(file(output));
            EXPECT_EQ(inShell(command, closed).exitCode, 0);
            if (output.empty()) continue;
            const std::string content = readText(file(output));
            EXPECT_THAT(content, Not(HasSubstr("written to"))) << "what is printed is not in the file";
            EXPECT_GT(content.size(), 50U);
        }
    }
}

TEST_F(Endings, AFileThatGrowsTooLargeIsASentenceAndNothingIsLeft) {
    for (const auto& [command, output] : commands()) {
        if (output.empty()) continue;
        SCOPED_TRACE(command);
        fs::remove(file(output));
        // One block of 512 bytes: enough for one sentence.
        expectOneSentence(inShell(command, ">/dev/null", "ulimit -f 1;"),
                          output + ": cannot be written: File too large.");
        EXPECT_FALSE(fs::exists(file(output)));
    }
}

TEST_F(Endings, AnOutputThatIsAnInputOrAnotherOutputIsRefusedBeforeTheRun) {
    const std::string way = trajectory({{0, 0, 0, 1}, {0.1, 0, 0, 0.5}});
    const std::string tooth = plate(), tool = ball();
    const std::string folder = fs::path(tooth).parent_path();
    fs::create_symlink("plate.stl", file("link.stl"));
    const std::vector<std::string> cut = {"cut", "--tooth",     tooth, "--tool",  tool,  "--trajectory",
                                          way,   "--speed-rpm", "1",   "--voxel", "0.2", "--out"};
    const std::vector<std::string> feel = {"feel", "--tooth", tooth, "--tool", tool, "--trajectory", way, "--out"};
    const std::vector<std::string> contact = {"contact", "--tooth", tooth, "--tool", tool, "--poses", way, "--out"};
    const auto with = [](std::vector<std::string> words, const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    const std::string reads = "this command reads it", twice = "which this command writes as well";
    const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
        {with(cut, {tooth}), reads},
        {with(cut, {file("link.stl")}), reads},
        {with(cut, {folder + "/./plate.stl"}), reads},
        {with(cut, {way}), reads},
        {with(cut, {file("a"), "--forces", file("a")}), twice},
        {with(cut, {file("a"), "--forces", file("b"), "--removed", folder + "/./b"}), twice},
        {with(cut, {file("a"), "--events", file("c"), "--save", file("c")}), twice},
        {with(cut, {file("l/enamel.stl"), "--export-layers", file("l")}), "folder"},
        {with(cut, {file("a"), "--forces", file("missing/b")}), "its folder does not exist"},
        {with(feel, {tooth}), reads},
        {with(feel, {tool}), reads},
        {with(contact, {way}), reads},
        {{"simplify", tooth, "--keep", "50%", "--out", tooth}, reads},
        {{"subdivide", tooth, "--out", file("link.stl")}, reads},
        {{"render", "--tooth", tooth, "--out", tooth}, reads},
    };
    const std::string before = readText(tooth), beforeWay = readText(way);
    for (const auto& [arguments, part] : wrong) {
        SCOPED_TRACE(::testing::PrintToString(arguments));
        expectOneSentence(runTactooth(arguments), part);
        EXPECT_EQ(readText(tooth), before);
        EXPECT_EQ(readText(way), beforeWay);
        for (const char* name : {"a", "b", "c", "l"}) EXPECT_FALSE(fs::exists(file(name))) << name;
    }
}

TEST_F(Endings, OldOutputsKeepTheirModeAndTheirLinks) {
    const std::string way = trajectory({{0, 0, 0, 1}, {0.1, 0, 0, 0.5}});
    text("real.csv", "old");
    fs::permissions(file("real.csv"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real.csv", file("linked.csv"));
    const ProgramRun run =
        runTactooth({"contact", "--tooth", plate(), "--tool", ball(), "--poses", way, "--out", file("linked.csv")});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_TRUE(fs::is_symlink(file("linked.csv")));
    EXPECT_THAT(readText(file("real.csv")), StartsWith("t,touching"));
    EXPECT_EQ(fs::status(file("real.csv")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

}  // namespace
}  // namespace tactooth
