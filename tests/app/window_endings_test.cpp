// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The whole program on a display, ended by signals; and how its settings outlive that.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include "app/gui/settings/settings_autosave.h"
#include "cli/run_program.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using namespace test;
namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr double kLongestStart = 300;  // s, on a busy machine

/// A phase of the start, shown by a thread that the program then has. None: it has just begun.
using StartPhase = std::optional<std::string>;
const StartPhase kBegun;
const StartPhase kConnected = "QXcbEventQueue";  // to the display; there is no window yet
const StartPhase kWorking = "servo";             // the window is open and the runner runs
const StartPhase kLoaded = "idle";               // and nothing is left to load, which would be waited for at the end

Environment homeIn(const TemporaryFolder& home) {
    return {{"XDG_CONFIG_HOME", home.path().string()},
            {"XDG_DATA_HOME", (home / "data").string()},
            {"QT_QPA_PLATFORM", std::nullopt}};
}

bool hasThread(pid_t process, const std::string& name) {
    std::error_code ended;
    fs::directory_iterator task("/proc/" + std::to_string(process) + "/task", ended);
    while (!ended && task != fs::directory_iterator()) {
        std::string found;
        std::getline(std::ifstream(task->path() / "comm"), found);
        if (found == name) return true;
        task.increment(ended);
    }
    return false;
}

/// Processor time of all threads of a process, s.
double processorSeconds(pid_t process) {
    std::string text;
    std::getline(std::ifstream("/proc/" + std::to_string(process) + "/stat"), text);
    std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
    std::string skipped;
    for (int i = 3; i < 14; ++i) fields >> skipped;
    double user = 0, system = 0;  // clock ticks
    fields >> user >> system;
    return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Whether the program takes less than a third of a processor for a second.
bool isIdle(pid_t process) {
    const double before = processorSeconds(process);
    std::this_thread::sleep_for(std::chrono::seconds(1));
    return processorSeconds(process) - before < 0.35;
}

/// Returns whether the start has reached the phase.
bool waitFor(const RunningTactooth& program, const StartPhase& phase) {
    if (phase == kLoaded) {
        const bool isWorking = waitFor(program, kWorking);
        for (int i = 0; i < 60 && !isIdle(program.number()); ++i) continue;
        return isWorking;
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kLongestStart);
    while (phase && !hasThread(program.number(), *phase)) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

/// Starts the program and sends the signal in this phase.
ProgramRun runUntil(const StartPhase& phase, int number, const TemporaryFolder& home) {
    RunningTactooth program({}, homeIn(home));
    EXPECT_TRUE(waitFor(program, phase)) << phase.value_or("");
    ::kill(program.number(), number);
    return program.wait();
}

class WindowEndings : public ::testing::TestWithParam<int> {};

TEST_P(WindowEndings, ASignalClosesTheWindowAsByHand) {
    const TemporaryFolder home;
    const fs::path settings = home / "tactooth/window.toml";
    fs::create_directories(settings.parent_path());
    std::ofstream(settings) << "[hand]\nrate = 99\nfineness = 2\n";
    bool isClosed = false;
    for (const StartPhase& phase : {kBegun, kConnected, kWorking, kLoaded}) {
        const ProgramRun run = runUntil(phase, GetParam(), home);
        EXPECT_EQ(run.signal, GetParam()) << run.exitCode << run.err;
        isClosed = run.err.find("tactooth: closed by SIG") != std::string::npos;
        EXPECT_EQ(run.err.find("before it was done") == std::string::npos, isClosed || run.err.empty()) << run.err;
        EXPECT_EQ(std::distance(fs::directory_iterator(settings.parent_path()), {}), 1) << "nothing else is left";
        const fs::path recordings = home / "data/tactooth/recordings";
        if (!isClosed || !fs::exists(recordings)) continue;
        EXPECT_TRUE(fs::is_empty(recordings)) << "the recording was ended, and nothing was touched in it";
    }
    ASSERT_TRUE(isClosed);
    const auto kept = readWindowSettings(settings);
    ASSERT_TRUE(kept) << kept.error().message();
    EXPECT_TRUE(kept->refused.empty()) << "it was written anew";
    EXPECT_EQ(kept->hand.motionScaling, 2);
}
INSTANTIATE_TEST_SUITE_P(All, WindowEndings, ::testing::Values(SIGTERM, SIGINT, SIGHUP),
                         [](const auto& each) { return std::string(sigabbrev_np(each.param)); });

/// A display that the test can end.
class OwnDisplay {
public:
    OwnDisplay() {
        int ends[2];
        if (::pipe(ends) != 0) return;
        process_ = ::fork();
        if (process_ == 0) {
            const std::string end = std::to_string(ends[1]);
            ::close(ends[0]);
            ::execlp("Xvfb", "Xvfb", "-displayfd", end.c_str(), "-screen", "0", "1000x800x24", nullptr);
            ::_exit(1);
        }
        ::close(ends[1]);
        // The server writes the line in parts and ends if nobody reads the last one.
        std::string number;
        for (char next = 0; ::read(ends[0], &next, 1) == 1 && next != '\n';) number += next;
        if (!number.empty()) name_ = ":" + number;
        ::close(ends[0]);
    }
    ~OwnDisplay() { takeAway(); }
    OwnDisplay(const OwnDisplay&) = delete;
    OwnDisplay& operator=(const OwnDisplay&) = delete;

    [[nodiscard]] const std::string& name() const { return name_; }
    void takeAway() {
        if (process_ <= 0) return;
        ::kill(process_, SIGTERM);
        ::waitpid(std::exchange(process_, 0), nullptr, 0);
    }

private:
    pid_t process_ = 0;
    std::string name_;
};

/// Once the window works. Qt itself may crash where the display ends while it connects; no device is open then.
TEST(WindowWithoutDisplay, ReleasesTheDeviceAndSaysSo) {
    const TemporaryFolder home;
    OwnDisplay display;
    ASSERT_NE(display.name(), "");
    Environment environment = homeIn(home);
    environment["DISPLAY"] = display.name();
    RunningTactooth program({}, environment);
    EXPECT_TRUE(waitFor(program, kLoaded));
    display.takeAway();
    const ProgramRun run = program.wait();
    EXPECT_EQ(run.signal, 0) << "no crash: " << run.err;
    EXPECT_THAT(run.err,
                HasSubstr("tactooth: the display is gone; the device was released, and the settings are kept.\n"));
}

TEST(WindowSettingsFile, OneThatIsNotTomlIsKeptBesideTheNewOne) {
    const TemporaryFolder home;
    const fs::path settings = home / "tactooth/window.toml";
    fs::create_directories(settings.parent_path());
    std::ofstream(settings) << "rate = [";
    const ProgramRun run = runUntil(kLoaded, SIGTERM, home);
    EXPECT_THAT(run.err, HasSubstr("tactooth: closed by SIG"));
    EXPECT_TRUE(readWindowSettings(settings));
    EXPECT_TRUE(fs::exists(settings));
    std::string kept;
    std::getline(std::ifstream(settings.string() + ".bad"), kept);
    EXPECT_EQ(kept, "rate = [");
}

/// Processes events until the condition holds, at most so long.
template <class Condition>
bool passUntil(const Condition& condition, qint64 milliseconds) {
    QElapsedTimer timer;
    for (timer.start(); timer.elapsed() < milliseconds && !condition();) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 100);
        std::this_thread::yield();
    }
    return condition();
}

TEST(SettingsAutosave, WritesSoonAfterAChangeAndNotWithoutOne) {
    int argc = 1;
    char name[] = "tests";
    char* argv[] = {name, nullptr};
    const QCoreApplication application(argc, argv);
    const TemporaryFolder home;
    const fs::path file = home / "tactooth/window.toml";
    WindowSettings settings;
    SettingsAutosave autosave([&] { return settings; }, file, std::chrono::milliseconds(50));
    EXPECT_FALSE(passUntil([&] { return fs::exists(file); }, 200)) << "nothing has changed";
    for (const double rate : {2000.0, 1500.0, 3000.0}) {
        settings.hand.rate = rate;
        const auto isWritten = [&] {
            const auto read = readWindowSettings(file);
            return read && read->hand.rate == rate;
        };
        EXPECT_TRUE(passUntil(isWritten, 60000)) << rate;
    }
}

}  // namespace
}  // namespace tactooth
