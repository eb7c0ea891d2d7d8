// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the program and its doctor say where no window can be opened: the same.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using namespace test;

/// No display, whatever the tests run on, but what `more` says.
Environment displayless(const TemporaryFolder& home, const Environment& more) {
    Environment environment = {{"DISPLAY", std::nullopt},
                               {"WAYLAND_DISPLAY", std::nullopt},
                               {"QT_QPA_PLATFORM", std::nullopt},
                               {"ALSOFT_DRIVERS", "none"},
                               {"XDG_CONFIG_HOME", home.path().string()}};
    for (const auto& [name, value] : more) environment[name] = value;
    return environment;
}

/// The doctor's finding about the display.
nlohmann::json displayFinding(const ProgramRun& doctor) { return nlohmann::json::parse(doctor.out).at(0); }

TEST(Display, WithoutOneTheProgramAndTheDoctorSayTheSameAndWhatToDo) {
    const TemporaryFolder home;
    const std::vector<std::pair<Environment, std::string>> cases = {
        {{}, "there is no display"},
        {{{"DISPLAY", ""}}, "there is no display"},
        {{{"DISPLAY", ":7777"}}, "the display ':7777' (DISPLAY) cannot be reached"},
        {{{"WAYLAND_DISPLAY", "nowhere"}}, "the display 'nowhere' (WAYLAND_DISPLAY) cannot be used"},
        {{{"QT_QPA_PLATFORM", "bogus"}}, "no window can be opened on Qt's platform 'bogus'; unset QT_QPA_PLATFORM"}};
    for (const auto& [more, sentence] : cases) {
        SCOPED_TRACE(sentence);
        const Environment environment = displayless(home, more);
        const ProgramRun window = runTactooth({}, environment);
        EXPECT_EQ(window.exitCode, 2);
        EXPECT_THAT(window.err, AllOf(StartsWith("tactooth: " + sentence), HasSubstr("start it from a desktop"),
                                      HasSubstr("ssh -X"), HasSubstr("tactooth demo")));
        EXPECT_EQ(std::ranges::count(window.err, '\n'), 1);
        const ProgramRun doctor = runTactooth({"doctor", "--json"}, environment);
        EXPECT_EQ(doctor.exitCode, 1);
        EXPECT_EQ(displayFinding(doctor).at("verdict"), "missing");
        const std::string text = displayFinding(doctor).at("text");
        EXPECT_EQ(text.substr(1) + "\n", window.err.substr(std::string("tactooth: ").size() + 1));
        EXPECT_TRUE(text.front() == 'T' || text.front() == 'N') << text;
    }
}

TEST(Display, APlatformWithoutAScreenIsOneToTheDoctorToo) {
    const TemporaryFolder home;
    const ProgramRun doctor = runTactooth({"doctor", "--json"}, displayless(home, {{"QT_QPA_PLATFORM", "offscreen"}}));
    EXPECT_EQ(displayFinding(doctor).at("verdict"), "fine");
}

TEST(Display, WhatIsWrongWithAFileIsSaidFirst) {
    const TemporaryFolder home;
    const ProgramRun run = runTactooth({"--bur", "/no/such/bur.stl"}, displayless(home, {}));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("/no/such/bur.stl"));
}

}  // namespace
}  // namespace tactooth
