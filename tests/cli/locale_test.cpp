// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers are written and read with a decimal point in every locale.
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/gui/settings/window_settings.h"
#include "cli/cli_test.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;

/// A locale with decimal commas, made in a separate folder: most machines have only the locales of their users.
class LocaleTest : public ::testing::Test {
protected:
    static constexpr const char* kGerman = "de_DE.UTF-8";

    void SetUp() override {
        if (std::system("command -v localedef >/dev/null") != 0) GTEST_SKIP() << "there is no localedef to make one";
        const std::string make = "localedef -i de_DE -f UTF-8 '" + (folder_ / kGerman).string() + "' >/dev/null 2>&1";
        ASSERT_EQ(std::system(make.c_str()), 0) << make;
    }
    void TearDown() override {
        std::setlocale(LC_ALL, "C");
        ::unsetenv("LOCPATH");
    }

    /// `plain`: with ordinary numbers instead.
    [[nodiscard]] ProgramRun run(const std::vector<std::string>& arguments, bool plain) const {
        const std::string name = plain ? "C" : kGerman;
        return runTactooth(arguments, {{"LC_ALL", name}, {"LANG", name}, {"LOCPATH", folder_.path().string()}});
    }
    void useItHere() const {
        ::setenv("LOCPATH", folder_.path().c_str(), 1);
        ASSERT_NE(std::setlocale(LC_ALL, kGerman), nullptr);
    }

    TemporaryFolder folder_;
};

TEST_F(LocaleTest, HasACommaInItsNumbers) {
    useItHere();
    char text[16];
    std::snprintf(text, sizeof text, "%.1f", 0.5);
    EXPECT_STREQ(text, "0,5");
}

TEST_F(LocaleTest, DevicesAreTheSame) {
    const ProgramRun here = run({"devices", "--json"}, false);
    EXPECT_EQ(here.exitCode, 0);
    EXPECT_EQ(here.out, run({"devices", "--json"}, true).out);
}

TEST_F(LocaleTest, ForcesAreTheSame) {
    const std::vector<std::string> arguments = {"bench",      "stability", "--device",    "touch", "--hand", "firm",
                                                "--material", "enamel",    "--situation", "press", "--json"};
    nlohmann::json runs[2];
    for (const bool plain : {false, true}) {
        const ProgramRun done = run(arguments, plain);
        ASSERT_EQ(done.exitCode, 0) << done.err;
        runs[plain] = nlohmann::json::parse(done.out);
        runs[plain].erase("date");
    }
    EXPECT_EQ(runs[0], runs[1]);
    EXPECT_TRUE(runs[0].at("cases").at(0).at("ripple_percent").is_number_float());
}

TEST_F(LocaleTest, NumbersOfOptionsHaveAPoint) {
    for (const bool plain : {false, true}) {
        const ProgramRun refused = run({"--pedal-up", "0,5"}, plain);
        EXPECT_EQ(refused.exitCode, 2);
        EXPECT_THAT(refused.err, HasSubstr("--pedal-up takes a number from 0 to 1, not '0,5'."));
    }
}

/// Qt draws the plots. It sets the user's locale for the rest of the program.
TEST_F(LocaleTest, TablesAfterAPlotAreTheSame) {
    for (const bool plain : {false, true}) {
        const ProgramRun done = run({"reproduce", "fig11", "fig13", "--out", folder_ / (plain ? "c" : "de")}, plain);
        ASSERT_EQ(done.exitCode, 0) << done.err;
    }
    const std::string table = readText(folder_ / "de" / "fig13.csv");
    EXPECT_EQ(table, readText(folder_ / "c" / "fig13.csv"));
    EXPECT_THAT(table, HasSubstr("."));
}

/// This process stands in for a window: Qt sets the user's locale before the settings are read and written.
TEST_F(LocaleTest, TheWindowsSettingsComeBack) {
    WindowSettings settings;
    settings.force.spring = 0.75;
    settings.hand.pedalUp = 0.125;
    settings.sound.master = 0.3;
    const std::string plain = windowSettingsText(settings);
    useItHere();
    EXPECT_EQ(windowSettingsText(settings), plain);
    ASSERT_TRUE(writeWindowSettings(settings, folder_ / "window.toml"));
    const auto again = readWindowSettings(folder_ / "window.toml");
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_EQ(again->force, settings.force);
    EXPECT_EQ(again->hand, settings.hand);
    EXPECT_EQ(again->sound.master, settings.sound.master);
}

}  // namespace
}  // namespace tactooth
