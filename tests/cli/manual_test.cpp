// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>

#include "cli/cli_test.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;

std::string manual(const std::string& form) {
    const ProgramRun run = runTactooth({"manual", form});
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_THAT(run.err, IsEmpty());
    return run.out;
}

/// The completions that a shell offers after these words.
std::string completions(const std::string& words) {
    const TemporaryFolder folder;
    writeText(folder / "complete", manual("bash"));
    const std::string count = "$((${#COMP_WORDS[@]} - 1))";
    const std::string script = "source '" + (folder / "complete").string() + "'; COMP_WORDS=(tactooth " + words +
                               "); COMP_CWORD=" + count + "; _tactooth; echo \"${COMPREPLY[@]}\" > '" +
                               (folder / "offered").string() + "'";
    EXPECT_EQ(std::system(("bash -s <<'END'\n" + script + "\nEND\n").c_str()), 0);
    return readText(folder / "offered");
}

TEST(Manual, PagesAreThoseOfTheProgram) {
    const std::string pages = TACTOOTH_PAGES;
    EXPECT_EQ(manual("markdown"), readText(pages + "/commands.md"))
        << "run: tactooth manual markdown > docs/user/commands.md";
    EXPECT_EQ(manual("metrics"), readText(pages + "/metrics.md"))
        << "run: tactooth manual metrics > docs/user/metrics.md";
    EXPECT_EQ(manual("metrics-ja"), readText(pages + "/metrics.ja.md"))
        << "run: tactooth manual metrics-ja > docs/user/metrics.ja.md";
    EXPECT_EQ(manual("keys"), readText(pages + "/keys.md")) << "run: tactooth manual keys > docs/user/keys.md";
    EXPECT_EQ(manual("keys-ja"), readText(pages + "/keys.ja.md"))
        << "run: tactooth manual keys-ja > docs/user/keys.ja.md";
}

TEST(Manual, ManPageNamesCommandsAndOptions) {
    const std::string page = manual("man");
    EXPECT_THAT(page, StartsWith(".TH TACTOOTH 1"));
    EXPECT_THAT(page, AllOf(HasSubstr(".SS tactooth bench contact"), HasSubstr("\\-\\-trajectory"),
                            HasSubstr(".SH EXIT STATUS"), Not(HasSubstr("\n.--"))));
}

TEST(Manual, CompletionOffersCommandsOptionsAndChoices) {
    EXPECT_THAT(completions("be"), HasSubstr("bench"));
    EXPECT_THAT(completions("bench co"), HasSubstr("contact"));
    EXPECT_THAT(completions("cut --traj"), HasSubstr("--trajectory"));
    EXPECT_THAT(completions("feel --mode pe"), HasSubstr("penalty"));
    EXPECT_THAT(completions("feel --mode pe"), Not(HasSubstr("--mode")));
}

TEST(Manual, AnUnknownFormIsOneSentence) {
    const ProgramRun run = runTactooth({"manual", "latex"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("must be one of man,bash,markdown,metrics"));
}

}  // namespace
}  // namespace tactooth
