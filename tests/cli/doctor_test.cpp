// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/cli_test.h"
#include "support/sanitizer.h"
#include "support/test_data.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;
using Json = nlohmann::json;

Json doctorSays(const Environment& changes) { return Json::parse(runTactooth({"doctor", "--json"}, changes).out); }

/// The first finding of this area with a text that starts with `beginning`.
Json finding(const Json& findings, const std::string& area, const std::string& beginning = "") {
    const auto found = std::ranges::find_if(findings, [&](const Json& one) {
        return one.at("area") == area && one.at("text").get<std::string>().starts_with(beginning);
    });
    return found == findings.end() ? Json{{"verdict", "there is none"}, {"text", ""}} : *found;
}

TEST(Doctor, ChecksEverything) {
    const ProgramRun run = runTactooth({"doctor", "--json"});
    const auto json = Json::parse(run.out);
    std::vector<std::string> areas;
    bool missing = false;
    for (const auto& one : json) {
        areas.push_back(one.at("area"));
        missing |= one.at("verdict") == "missing";
        EXPECT_NE(one.at("text"), "");
    }
    const std::vector<std::string> first = {"display", "OpenGL", "sound system", "sound card", "real time"};
    ASSERT_GT(areas.size(), first.size());
    EXPECT_TRUE(std::equal(first.begin(), first.end(), areas.begin()));
    const auto devices = Json::parse(runTactooth({"devices", "--json"}).out);
    EXPECT_EQ(std::ranges::count(areas, "device"), static_cast<long>(devices.size()));
    EXPECT_EQ(run.exitCode, missing ? 1 : 0);
}

TEST(Doctor, SpeaksInSentences) {
    for (const Json& one : doctorSays({{"DISPLAY", std::nullopt}})) {
        if (one.at("area") == "device") continue;
        const std::string text = one.at("text");
        EXPECT_TRUE(text.front() >= 'A' && text.front() <= 'Z') << text;
        EXPECT_EQ(text.back(), '.') << text;
    }
}

TEST(Doctor, ShowsTheLastFaultsOfTheHandProcess) {
    const TemporaryFolder state;
    const Environment environment = {{"XDG_STATE_HOME", state.path().string()}};
    EXPECT_THAT(finding(doctorSays(environment), "hand process").at("text").get<std::string>(),
                HasSubstr("it has no faults"));
    std::filesystem::create_directory(state / "tactooth");
    writeText(state / "tactooth" / "hand-faults.csv",
              "time,cause,device,force_n,zero_ms\n"
              "2026-11-26T07:08:22.123Z,beyond_limits,Touch,3.3,2.1\n"
              "2026-11-27T07:08:22.123Z,no_force,Touch,1.83,2.1\n"
              "2026-11-27T07:08:23.123Z,something,Touch,1,2.1\n"
              "2026-11-27T07:08:24.123Z,hand_killed,Haply Inverse3 \x1b[31m,0,0\n"
              "2026-11-27T07:08:25.123Z,program_ended,Touch,0.2,2.1\n");
    const Json shown = finding(doctorSays(environment), "hand process");
    EXPECT_EQ(shown.at("verdict"), "fine");
    const std::string text = shown.at("text");
    EXPECT_THAT(text, HasSubstr("2026-11-27 07:08:22 UTC, Touch, 1.8 N: no fresh force for 3 ms; "));
    EXPECT_THAT(text, HasSubstr(": the device's process was ended by a signal; "));
    EXPECT_THAT(text, HasSubstr("Touch, 0.2 N: the program ended without closing the device."));
    EXPECT_EQ(text.find("beyond"), text.npos) << "the last three";
    EXPECT_EQ(text.find('\x1b'), text.npos);
}

TEST(Doctor, TheNullDriverIsNoSoundCard) {
    const Json findings = doctorSays({{"ALSOFT_DRIVERS", "null"}});
    EXPECT_EQ(finding(findings, "sound system").at("verdict"), "fine");
    EXPECT_EQ(finding(findings, "sound card").at("verdict"), "optional");
    EXPECT_THAT(finding(findings, "sound card").at("text").get<std::string>(), HasSubstr("unset ALSOFT_DRIVERS"));
}

TEST(Doctor, NoSoundCardIsNoFaultOfTheSoundSystem) {
    const Json findings = doctorSays({{"ALSOFT_DRIVERS", "none"}});
    EXPECT_EQ(finding(findings, "sound system").at("text"), "OpenAL works.");
    EXPECT_THAT(finding(findings, "sound card").at("text").get<std::string>(), StartsWith("No sound card"));
}

TEST(Doctor, ALibraryThatCrashesIsNamedWithItsRemedy) {
    if (isSanitized()) GTEST_SKIP() << "a sanitizer wants to be the first library";
    const Json findings = doctorSays({{"LD_PRELOAD", TACTOOTH_CRASHING_LIBRARIES}, {"ALSOFT_DRIVERS", "null"}});
    const auto textOf = [&](const std::string& area, const std::string& beginning = "") {
        return finding(findings, area, beginning).at("text").get<std::string>();
    };
    EXPECT_THAT(textOf("device", "gamepad"), AllOf(HasSubstr("it crashes"), HasSubstr("libsdl2-2.0-0")));
    EXPECT_THAT(textOf("device", "foot pedal"), AllOf(HasSubstr("it crashes"), HasSubstr("libsdl2-2.0-0")));
    EXPECT_THAT(textOf("device", "SpaceMouse"), AllOf(HasSubstr("it crashes"), HasSubstr("libspnav0")));
    EXPECT_EQ(finding(findings, "sound system").at("verdict"), "fine");
    EXPECT_EQ(finding(findings, "sound card").at("verdict"), "missing") << "it would take the window down";
    EXPECT_THAT(textOf("sound card"), AllOf(HasSubstr("it crashes"), HasSubstr("ALSOFT_DRIVERS=null")));
}

TEST(Doctor, ASoundLibraryThatCrashesIsNotTheCardsFault) {
    if (isSanitized()) GTEST_SKIP() << "a sanitizer wants to be the first library";
    const Json findings = doctorSays({{"LD_PRELOAD", TACTOOTH_CRASHING_MIXER}});
    EXPECT_EQ(finding(findings, "sound system").at("verdict"), "missing");
    EXPECT_THAT(finding(findings, "sound system").at("text").get<std::string>(),
                AllOf(HasSubstr("it crashes"), HasSubstr("libopenal1")));
    EXPECT_THAT(finding(findings, "sound card").at("text").get<std::string>(), HasSubstr("not tried"));
}

}  // namespace
}  // namespace tactooth
