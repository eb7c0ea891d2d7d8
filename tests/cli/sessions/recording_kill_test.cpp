// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Ends a program that records a session, at a random moment and without a warning. TACTOOTH_KILLS=300 kills that many
// times; a few are usual.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "cli/motion_files.h"
#include "support/disk_watch.h"

namespace tactooth {
namespace {

using namespace test;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr int kUsualKills = 4;
constexpr double kMaxLost = 1.5;  // s: a block of half a second, a sync, and what this machine needs to wake a thread
constexpr auto kPatience = 120s;

int numberOfKills() {
    const char* wanted = std::getenv("TACTOOTH_KILLS");
    return wanted == nullptr ? kUsualKills : std::atoi(wanted);
}

class RecordingKill : public MotionFiles {
protected:
    static nlohmann::json jsonOf(const std::vector<std::string>& arguments) {
        const ProgramRun run = runTactooth(arguments);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        return nlohmann::json::parse(run.out, nullptr, false);
    }
    /// Waits until the file has grown beyond a size; false if it does not.
    static bool growsBeyond(const fs::path& recording, std::uintmax_t bytes) {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        std::error_code missing;
        while (std::chrono::steady_clock::now() < end) {
            const std::uintmax_t size = fs::file_size(recording, missing);
            if (!missing && size > bytes) return true;
            std::this_thread::sleep_for(5ms);
        }
        return false;
    }
    /// Waits until the recording holds ticks: before, the tooth is written.
    static bool hasTicksSoon(const fs::path& recording) {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (std::chrono::steady_clock::now() < end) {
            const ProgramRun run = runTactooth({"session", "info", recording.string(), "--json"});
            const nlohmann::json info = nlohmann::json::parse(run.out, nullptr, false);
            if (run.exitCode == 0 && info.is_object() && info["ticks"] > 0) return true;
            std::this_thread::sleep_for(50ms);
        }
        return false;
    }
};

TEST_F(RecordingKill, AtAnyMomentTheFileOpensReplaysAndLacksNoMoreThanItMay) {
    std::mt19937 random(38);
    const fs::path recording = file("s.ttsession");
    test::DiskWatch disk;
    int replayed = 0;
    for (int i = 0; i < numberOfKills() && !HasFailure(); ++i) {
        fs::remove(recording);
        const double delay = std::uniform_real_distribution(0.0, 2.5)(random);
        SCOPED_TRACE("kill " + std::to_string(i) + ", " + std::to_string(delay) + " s after the file appeared");
        RunningTactooth program({"realtime", "--seconds", "20", "--record", recording.string()});
        ASSERT_TRUE(growsBeyond(recording, 0));
        if (i % 2 == 0) {  // however long a busy machine takes to begin
            ASSERT_TRUE(hasTicksSoon(recording));
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(delay));  // the moment itself, not a wait for it
        const auto written = fs::last_write_time(recording);
        ::kill(program.number(), SIGKILL);
        const auto killed = fs::file_time_type::clock::now();
        const double delayed = disk.takeLongest();  // s
        EXPECT_EQ(program.wait().signal, SIGKILL);

        const nlohmann::json info = jsonOf({"session", "info", recording.string(), "--json"});
        EXPECT_FALSE(info["complete"]);
        if (info["ticks"] == 0) continue;  // it was still writing the tooth
        EXPECT_LT(std::chrono::duration<double>(killed - written).count(), kMaxLost + delayed);
        const nlohmann::json summary = jsonOf({"replay", recording.string(), "--json"});
        EXPECT_TRUE(summary["same"]);
        EXPECT_EQ(summary["ticks"], info["ticks"]);
        ++replayed;
    }
    EXPECT_GT(replayed, numberOfKills() / 4);
}

}  // namespace
}  // namespace tactooth
