// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window is ended by a signal while it has unsaved cuts; the next start brings them back. Each window is a program
// of its own, which is this one with an argument, since Qt has one application.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>

#include "app/common/termination.h"
#include "app/gui/window/main_window.h"
#include "app/gui/window/run_window.h"
#include "devices/simulated/scripted_device.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCut = "--cut";          // cuts, says how much, and waits for the signal
constexpr const char* kRestore = "--restore";  // says what was restored, and ends
constexpr auto kPatience = std::chrono::minutes(5);
constexpr int kCheckInterval = 20;  // ms between two looks at the window

std::string task;   // of this process; empty: the tests
fs::path homePath;  // its home

/// How much is gone. Appears as a whole.
void say(const char* name, const MaterialVolumes& removed) {
    std::ofstream(homePath / "unfinished") << std::hexfloat << total(removed);
    fs::rename(homePath / "unfinished", homePath / name);
}

MainWindow* mainWindow() {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* const window = qobject_cast<MainWindow*>(widget)) return window;
    }
    return nullptr;
}

/// A hand presses the bur into the crown from above, and lifts it.
std::unique_ptr<HapticDevice> pressOn(const SessionModel& model) {
    const Box3 box = model.tooth()->box();
    const Vec3 top(box.center().x(), box.center().y(), box.max().z());
    const auto at = [&](double time, double z) {
        return DeviceKeyframe{time, {.hand = {top + Vec3(0, 0, z), Quat::Identity()}, .pedal = 1}};
    };
    return std::make_unique<ScriptedDevice>(
        std::vector{at(0, 3), at(0.5, 3), at(3, -3), at(4, -3), at(5, 8), at(1e6, 8)}, "press", true);
}

/// The hand has left the tooth, and nothing has been removed for a long time (in ticks).
bool isCut(const SessionModel& model) {
    static MaterialVolumes removed;
    static TickNumber since = 0;
    constexpr TickNumber kQuiet = 500;
    const Tick& tick = model.log().newest();
    const MaterialVolumes now = model.runner()->feed().removed();
    const double height = tick.input.device.position.z() - model.tooth()->box().max().z();
    if (now != removed || height < 7 || tick.contact.triangles > 0) removed = now, since = tick.number;
    return total(removed) > 0.01 && tick.number > since + kQuiet;
}

void cut(SessionModel& model) {
    static bool isPressing = false;
    if (!std::exchange(isPressing, true)) {
        model.setCutting(true);
        model.install(DeviceSlot::First, pressOn(model));
    } else if (!fs::exists(homePath / "cut") && isCut(model)) {
        say("cut", model.runner()->feed().removed());
    }
}

void answerAndCheck(MainWindow& window) {
    static bool isAnswered = false;
    if (auto* const question = window.findChild<QMessageBox*>("restoreSession"); question != nullptr && !isAnswered) {
        isAnswered = true;
        question->defaultButton()->click();
        return;
    }
    if (!isAnswered || window.isBusy() || !window.model().isModified()) return;
    say("restored", window.model().runner()->feed().removed());
    std::_Exit(0);  // nobody asks what to do with the cuts
}

void visitWindow() {
    if (task.empty()) return;
    auto* const timer = new QTimer(QCoreApplication::instance());
    QObject::connect(timer, &QTimer::timeout, timer, [] {
        MainWindow* const window = mainWindow();
        if (window == nullptr || window->isBusy() || window->model().runner() == nullptr) return;
        if (task == kRestore) answerAndCheck(*window);
        if (task == kCut) cut(window->model());
    });
    timer->start(kCheckInterval);
}
Q_COREAPP_STARTUP_FUNCTION(visitWindow)

int runTask(const std::string& name, const char* home) {
    task = name;
    homePath = home;
    setenv("XDG_CONFIG_HOME", home, 1);
    setenv("XDG_CACHE_HOME", home, 1);
    setenv("XDG_DATA_HOME", (homePath / "data").c_str(), 1);  // of the recordings
    WindowOptions options;
    options.exercise = "pit-46";
    return runWindow(options);
}

/// This program with a task.
class Window {
public:
    Window(const char* name, const fs::path& home) : process_(::fork()) {
        if (process_ != 0) return;
        ::execl("/proc/self/exe", "window", name, home.c_str(), nullptr);
        ::_exit(127);
    }
    ~Window() {
        if (process_ <= 0) return;
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void send(int signal) const { ::kill(process_, signal); }
    /// What it has said under this name; empty if it says nothing, or ends.
    [[nodiscard]] std::string waitFor(const fs::path& file) {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (std::chrono::steady_clock::now() < end && !fs::exists(file)) {
            if (::waitpid(process_, &status_, WNOHANG) == process_) {
                process_ = -1;
                break;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        std::string text;
        std::ifstream(file) >> text;
        return text;
    }
    /// The status of waitpid.
    [[nodiscard]] int wait() {
        if (process_ > 0) ::waitpid(process_, &status_, 0);
        process_ = -1;
        return status_;
    }

private:
    pid_t process_;
    int status_ = 0;
};

class WindowSignals : public ::testing::TestWithParam<int> {};

TEST_P(WindowSignals, UnsavedCutsAreSavedAndTheNextStartRestoresThem) {
    const test::TemporaryFolder home;
    std::string before;
    {
        Window window(kCut, home.path());
        before = window.waitFor(home / "cut");
        ASSERT_FALSE(before.empty());
        window.send(GetParam());
        const int status = window.wait();
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == GetParam()) << status;
    }
    int teeth = 0, finished = 0;
    for (const auto& entry : fs::directory_iterator(home / "data/tactooth/recordings")) {
        const std::string name = entry.path().filename().string();
        EXPECT_FALSE(name.starts_with("live-")) << "the recording has its end and its name";
        teeth += name.starts_with("autosave-") ? 1 : 0;
        finished += entry.path().extension() == ".ttsession" ? 1 : 0;
    }
    EXPECT_EQ(teeth, 1);
    EXPECT_EQ(finished, 1);
    Window again(kRestore, home.path());
    EXPECT_EQ(again.waitFor(home / "restored"), before);
}
INSTANTIATE_TEST_SUITE_P(All, WindowSignals, ::testing::Values(SIGTERM, SIGHUP, SIGINT),
                         [](const auto& each) { return std::string(sigabbrev_np(each.param)); });

}  // namespace
}  // namespace tactooth

int main(int argc, char** argv) {
    constexpr int kWithTask = 3;
    if (argc == kWithTask) {  // as the program does
        tactooth::installTerminationHandlers();
        return tactooth::exitAsRequested(tactooth::runTask(argv[1], argv[2]));
    }
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
