// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cli/cli_test.h"
#include "devices/probe/device_backend.h"
#include "devices/standin/pen_folder.h"

namespace tactooth {
namespace {

using namespace test;
using Json = nlohmann::json;

/// The number of visible letters of a UTF-8 text.
std::size_t lettersOf(const std::string& line) {
    return static_cast<std::size_t>(
        std::ranges::count_if(line, [](unsigned char byte) { return (byte & 0xC0) != 0x80; }));
}

TEST(HapticsCommands, StabilityListsEachRunAsJson) {
    const ProgramRun run = runTactooth({"bench", "stability", "--device", "touch-x", "--hand", "loose", "--material",
                                        "enamel", "--situation", "press", "--situation", "fissure", "--json"});
    EXPECT_EQ(run.exitCode, 0);
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json.at("stable"), true);
    ASSERT_EQ(json.at("cases").size(), 2U);
    EXPECT_EQ(json["cases"][0].at("device"), "touch-x");
    EXPECT_EQ(json["cases"][1].at("situation"), "fissure");
    EXPECT_NEAR(json["cases"][0].at("stiffness_n_per_mm").get<double>(), 1.0, 1e-9);
    EXPECT_LT(json["cases"][0].at("ripple_percent"), 3);
}

TEST(HapticsCommands, StabilityHasALineForEachDeviceAndHandOrForEachRun) {
    const std::vector<std::string> few = {"bench", "stability",  "--device", "omni",        "--hand",
                                          "firm",  "--material", "pulp",     "--situation", "press"};
    EXPECT_THAT(runTactooth(few).out, HasSubstr("1 of 1 stable"));
    std::vector<std::string> all = few;
    all.emplace_back("--all");
    EXPECT_THAT(runTactooth(all).out, AllOf(HasSubstr("omni       firm     pulp      press"), HasSubstr("command:")));
}

// The friction of arm and tooth would hold a softer hand, so that nothing would move.
TEST(HapticsCommands, StabilityCutsAndTrembles) {
    const ProgramRun run = runTactooth({"bench", "stability", "--device", "touch-x", "--hand", "firm", "--material",
                                        "dentin", "--situation", "cut", "--situation", "tremor", "--json"});
    EXPECT_EQ(run.exitCode, 0) << run.out;
    const auto json = nlohmann::json::parse(run.out);
    ASSERT_EQ(json.at("cases").size(), 2U);
    EXPECT_NEAR(json["cases"][0].at("most_ripple_percent").get<double>(), 7, 1e-9);
    EXPECT_GT(json["cases"][1].at("ripple_percent"), 0.5) << "a tremor changes the force";
}

TEST(HapticsCommands, StabilityKnowsItsDevices) {
    const ProgramRun run = runTactooth({"bench", "stability", "--device", "joystick"});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("see 'tactooth bench stability --help'"));
}

TEST(HapticsCommands, RealtimeReportsHowTheMachineKeptTime) {
    const ProgramRun run = runTactooth({"realtime", "--seconds", "1", "--json"});
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_GT(json.at("ticks"), 50);
    for (const char* line : {"period_jitter", "tick", "lateness", "device_to_force", "link_in_process",
                             "link_through_hand", "link_added"}) {
        EXPECT_GT(json.at(line).at("p50_us"), 0) << line;
        EXPECT_LE(json.at(line).at("p50_us"), json.at(line).at("max_us")) << line;
        std::uint64_t count = 0;
        for (const Json& bin : json.at(line).at("bins")) count += bin.at("count").get<std::uint64_t>();
        EXPECT_GT(count, 50U) << line;
        EXPECT_GT(json.at(line).at("bins").back().at("below_us"), json.at(line).at("max_us")) << line;
    }
    const ProgramRun table = runTactooth({"realtime", "--seconds", "1", "--rate", "2000", "--load"});
    EXPECT_THAT(table.out, AllOf(HasSubstr("2000 Hz, with all other cores busy"), HasSubstr("deadlines missed"),
                                 HasSubstr("below, us  period jitter"), HasSubstr("█")));
    std::istringstream lines(table.out.substr(table.out.find("below, us")));
    for (std::string line; std::getline(lines, line) && !line.empty();) EXPECT_LE(lettersOf(line), 100U) << line;
    EXPECT_EQ(runTactooth({"realtime", "--rate", "100"}).exitCode, 2);
    EXPECT_TRUE(json.at("heavy_scene").is_boolean());
}

TEST(HapticsCommands, DevicesAlwaysHaveTheMouse) {
    const PenFolder noPens({});
    const ProgramRun run = runTactooth({"devices", "--json"});
    EXPECT_EQ(run.exitCode, 0);
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json.at(0).at("name"), "mouse");
    EXPECT_EQ(json.at(0).at("ready"), true);
    std::vector<std::string> names;
    for (const auto& device : json) names.push_back(device.at("name"));
    for (const char* name : {"pen", "gamepad", "spacemouse", "pedal"}) EXPECT_THAT(names, ::testing::Contains(name));
    EXPECT_TRUE(std::ranges::any_of(
        json, [](const auto& device) { return device.at("backend") == "Haply Inverse3" && device.at("text") != ""; }));
    EXPECT_THAT(runTactooth({"devices"}).out, HasSubstr("mouse and keyboard"));
}

Json deviceNamed(const std::string& name, const Environment& changes) {
    for (const Json& device : Json::parse(runTactooth({"devices", "--json"}, changes).out)) {
        if (device.at("name") == name) return device;
    }
    return {};
}

TEST(HapticsCommands, DevicesGiveTheirCapabilitiesInNumbers) {
    const PenFolder noPens({});
    const Json pen = deviceNamed("pen", {{"TACTOOTH_LIBHD", TACTOOTH_STANDIN_HD}});
    EXPECT_EQ(pen.at("state"), "ready");
    EXPECT_EQ(pen.at("force_n"), 3.3);
    EXPECT_EQ(pen.at("continuous_force_n"), 0.88);
    EXPECT_EQ(pen.at("workspace_mm"), Json({160, 70, 120}));
    EXPECT_EQ(pen.at("stiffness_n_per_mm"), 0.5);
    EXPECT_EQ(pen.at("buttons"), 2);
    EXPECT_EQ(deviceNamed("mouse", {}).at("force_n"), 0);
}

TEST(HapticsCommands, ADeviceThatIsBrokenIsNotUsableAndOneThatIsMissingIsNotThere) {
    const PenFolder noPens({});
    const Json broken = deviceNamed("pen", {{"TACTOOTH_LIBHD", TACTOOTH_CRASHING_HD}});
    EXPECT_EQ(broken.at("state"), "not usable");
    EXPECT_EQ(broken.at("ready"), false);
    EXPECT_FALSE(broken.contains("force_n")) << "nobody knows";
    EXPECT_EQ(deviceNamed("pen", {{"TACTOOTH_LIBHD", "libNoSuchHD.so"}}).at("state"), "not there");
}

TEST(HapticsCommands, EachPenThatIsSetUpIsListedByItsName) {
    const PenFolder pens({"Default Device", "Left"});
    const Environment standin = {{"TACTOOTH_LIBHD", TACTOOTH_STANDIN_HD}};
    EXPECT_EQ(deviceNamed("pen", standin).at("state"), "ready");
    EXPECT_EQ(deviceNamed("pen:Left", standin).at("state"), "ready");
    EXPECT_THAT(runTactooth({"doctor"}, standin).out,
                AllOf(HasSubstr("  OpenHaptics (PHANToM, Touch): Touch (stand-in): force"),
                      HasSubstr("  pen:Left, OpenHaptics (PHANToM, Touch): Touch (stand-in) 'Left': force")));
}

TEST(HapticsCommands, DevicesStandInColumns) {
    const PenFolder pens({"Default Device", "Left, which has a long name"});
    std::istringstream lines(runTactooth({"devices"}, {{"TACTOOTH_LIBHD", TACTOOTH_CRASHING_HD}}).out);
    std::set<std::size_t> columns;
    for (std::string line; std::getline(lines, line);) {
        const auto end = std::min({line.find("  ready  "), line.find("  not there  "), line.find("  not usable  ")});
        ASSERT_NE(end, std::string::npos) << line;
        columns.insert(line.find_first_not_of(' ', end));
    }
    EXPECT_EQ(columns.size(), 1U);
}

/// The names of these kinds of devices as a message lists them.
std::string listed(std::span<const DeviceBackend> kinds) {
    std::string names;
    for (const DeviceBackend& kind : kinds) names += (names.empty() ? "" : ", ") + std::string(kind.name);
    return names;
}

TEST(HapticsCommands, ADeviceThatNobodyKnowsIsRefusedByTheNameOfItsOption) {
    const ProgramRun first = runTactooth({"--device", "joystick", "--second-device", "bogus"});
    EXPECT_EQ(first.exitCode, 2);
    EXPECT_THAT(first.err,
                AllOf(StartsWith("tactooth: --device takes " + listed(deviceBackends())), HasSubstr("not 'joystick'")));
    const ProgramRun second = runTactooth({"--device", "pen:Right", "--second-device", "bogus"});
    EXPECT_EQ(second.exitCode, 2);
    EXPECT_THAT(second.err,
                AllOf(StartsWith("tactooth: --second-device takes none, " + listed(deviceBackends().subspan(1))),
                      HasSubstr("not 'bogus'")));
}

}  // namespace
}  // namespace tactooth
