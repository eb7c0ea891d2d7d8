// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "cli/cli_test.h"

namespace tactooth {
namespace {

using namespace test;

TEST(Usage, HelpNamesTheCommands) {
    const ProgramRun run = runTactooth({"--help"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("Usage: tactooth"), HasSubstr("info"), HasSubstr("--version")));
    EXPECT_THAT(run.err, IsEmpty());
}

TEST(Usage, CommandHelpNamesItsOptions) {
    const ProgramRun run = runTactooth({"info", "--help"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, AllOf(HasSubstr("Usage: tactooth info"), HasSubstr("FILE"), HasSubstr("--json")));
}

TEST(Usage, VersionIsOneLine) {
    const ProgramRun run = runTactooth({"--version"});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.out, MatchesRegex("tactooth [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Usage, WrongUsageIsOneSentenceThatSaysWhereHelpIs) {
    const std::vector<std::vector<std::string>> wrong = {
        {"nonsense"}, {"--nonsense"}, {"info"}, {"info", "--nonsense", "a.stl"}, {"info", "--json"}};
    for (const std::vector<std::string>& arguments : wrong) {
        SCOPED_TRACE(arguments.back());
        const ProgramRun run = runTactooth(arguments);
        EXPECT_EQ(run.exitCode, 2);
        EXPECT_THAT(run.out, IsEmpty());
        EXPECT_THAT(run.err, AllOf(StartsWith("tactooth: "), HasSubstr("--help'.\n")));
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    }
}

TEST(Usage, WhatExcludesEachOtherIsSaidInPlainWords) {
    const ProgramRun run = runTactooth({"render", "--mouth", "--tooth", "a.stl", "--out", "a.png"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("--tooth cannot be given together with --mouth"));
}

}  // namespace
}  // namespace tactooth
