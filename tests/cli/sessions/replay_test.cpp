// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/motion_files.h"
#include "support/text_file.h"

namespace tactooth {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// Two seconds of a simulated hand that touches the built-in molar, then cuts it.
class ReplayCommand : public test::MotionFiles {
protected:
    std::string recorded() {
        const ProgramRun run = runTactooth({"realtime", "--seconds", "2", "--record", file("s.ttsession")});
        EXPECT_LE(run.exitCode, 1) << run.err;  // 1: this machine was late now and then
        return file("s.ttsession");
    }
    static nlohmann::json jsonOf(const std::vector<std::string>& arguments) {
        const ProgramRun run = runTactooth(arguments);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return nlohmann::json::parse(run.out);
    }
    /// The recording without its last bytes, in the midst of a block of events.
    std::string cutOff(const std::string& whole) {
        constexpr std::uintmax_t kLost = 2500;
        fs::copy_file(whole, file("crash.ttsession"), fs::copy_options::overwrite_existing);
        fs::resize_file(file("crash.ttsession"), fs::file_size(whole) - kLost);
        return file("crash.ttsession");
    }
};

TEST_F(ReplayCommand, ReachesTheRecordedToothAndWritesIt) {
    const std::string session = recorded();
    const auto info = jsonOf({"session", "info", session, "--json"});
    EXPECT_TRUE(info["complete"]);
    EXPECT_TRUE(info["cut_off_at"].is_null());
    EXPECT_NEAR(info["seconds"], 2, 0.5);
    EXPECT_GT(info["ticks"], 500);
    EXPECT_EQ(info["bytes"], fs::file_size(session));
    EXPECT_EQ(info["events"]["burs"], 1);
    EXPECT_GT(info["events"]["cuts"], 0);
    const auto summary = jsonOf({"replay", session, "--verify", "--out", file("out"), "--json"});
    EXPECT_TRUE(summary["same"]);
    EXPECT_EQ(summary["ticks"], info["ticks"]);
    EXPECT_GT(summary["removed_mm3"]["enamel"], 0);
    EXPECT_EQ(nlohmann::json::parse(readText(file("out/summary.json")))["hash"], summary["hash"]);
    EXPECT_EQ(nlohmann::json::parse(runTactooth({"info", file("out/cut.stl"), "--json"}).out)["watertight"], true);
    std::ifstream forces(file("out/forces.csv"));
    int rows = -1;  // the header
    for (std::string line; std::getline(forces, line);) ++rows;
    EXPECT_EQ(rows, info["ticks"]);
    const ProgramRun verified = runTactooth({"session", "verify", session});
    EXPECT_EQ(verified.exitCode, 0) << verified.err;
    EXPECT_THAT(verified.out, HasSubstr("bit for bit"));
    const auto part = jsonOf({"replay", session, "--until", "0.5", "--json"});
    EXPECT_NEAR(part["seconds"], 0.5, 0.05);
}

TEST_F(ReplayCommand, ARecordingThatWasCutOffIsPlayedToItsEndAndRepaired) {
    const std::string crashed = cutOff(recorded());
    const auto info = jsonOf({"session", "info", crashed, "--json"});
    EXPECT_FALSE(info["complete"]);
    const ProgramRun played = runTactooth({"replay", crashed});
    EXPECT_EQ(played.exitCode, 0) << played.err;
    EXPECT_THAT(played.out, HasSubstr("cut off"));
    const ProgramRun repaired = runTactooth({"session", "repair", crashed, "--out", file("whole.ttsession")});
    EXPECT_EQ(repaired.exitCode, 0) << repaired.err;
    const auto mended = jsonOf({"session", "info", file("whole.ttsession"), "--json"});
    EXPECT_EQ(mended["ticks"], info["ticks"]);
    EXPECT_TRUE(mended["cut_off_at"].is_null());
}

/// A byte of the tooth: the chain of checksums ends there.
TEST_F(ReplayCommand, ADamagedRecordingHasASentence) {
    const std::string session = recorded();
    std::fstream bytes(session, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(static_cast<std::streamoff>(fs::file_size(session) / 2));
    bytes.put('\0'), bytes.put('\1');
    bytes.close();
    const auto info = jsonOf({"session", "info", session, "--json"});
    EXPECT_FALSE(info["complete"]);
    EXPECT_FALSE(info["cut_off_at"].is_null());
}

TEST_F(ReplayCommand, WhatIsNoRecordingHasASentence) {
    std::ofstream(file("text.ttsession")) << "no recording";
    for (const std::string& name : {file("text.ttsession"), file("missing.ttsession"), file("")}) {
        for (const std::vector<std::string>& command :
             {std::vector<std::string>{"replay", name}, {"session", "info", name}, {"session", "verify", name}}) {
            const ProgramRun run = runTactooth(command);
            EXPECT_EQ(run.exitCode, 2) << name;
            EXPECT_THAT(run.err, ::testing::StartsWith("tactooth: "));
        }
    }
    const ProgramRun run = runTactooth({"realtime", "--seconds", "1", "--record", file("missing/s.ttsession")});
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_THAT(run.err, HasSubstr("missing"));
}

}  // namespace
}  // namespace tactooth
