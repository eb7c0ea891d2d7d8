// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_test.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;

TEST(Reproduce, LeavesTablePlotAndPage) {
    const test::TemporaryFolder folder;
    const ProgramRun run = runTactooth({"reproduce", "fig11", "fig13", "--out", folder / "found"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out,
                AllOf(HasSubstr("teeth: "), HasSubstr("fig11: Ten-patch object"), HasSubstr("published 10 cm/s")));
    for (const std::string name : {"fig11", "fig13"}) {
        EXPECT_THAT(test::readText(folder / "found" / (name + ".png")), StartsWith("\x89PNG"));
        EXPECT_GT(std::filesystem::file_size(folder / "found" / (name + ".png")), 20000U);
    }
    EXPECT_THAT(test::readText(folder / "found" / "fig11.csv"), StartsWith("place,mm_per_s,ticks"));
    EXPECT_THAT(test::readText(folder / "found" / "index.html"),
                AllOf(StartsWith("<!DOCTYPE html>"), HasSubstr("fig11.png"), HasSubstr("fig13.csv"),
                      HasSubstr("reproduce fig11 fig13"), HasSubstr("commit "), Not(HasSubstr("fig15"))));
}

TEST(Reproduce, RefusesWhatItDoesNotKnow) {
    const ProgramRun unknown = runTactooth({"reproduce", "fig99", "--out", "/tmp"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.err, HasSubstr("see 'tactooth reproduce --help'"));
    const ProgramRun nowhere = runTactooth({"reproduce", "fig11", "--out", "/proc/nowhere"});
    EXPECT_EQ(nowhere.exitCode, 2);
    EXPECT_THAT(nowhere.err, HasSubstr("/proc/nowhere cannot be made"));
}

TEST(Reproduce, HelpExplainsEachName) {
    const ProgramRun run = runTactooth({"reproduce", "--help"});
    EXPECT_EQ(run.exitCode, 0);
    for (const char* name : {"table2", "table3", "table4", "fig11", "fig13", "fig15", "fig16", "fig17", "all"}) {
        EXPECT_THAT(run.out, HasSubstr(name));
    }
}

}  // namespace
}  // namespace tactooth
