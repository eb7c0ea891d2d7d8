// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// hand_parent DEVICE: opens a device as the window does and renders a plane to it, until somebody ends or stops it: the
// program whose faults a test tries. SIGUSR1 makes its servo spin for some seconds, at real-time priority. It prints a
// line for each change: "hand PROCESS", "fault SENTENCE", "no fault", "spins TIME".
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "devices/base/monotonic_clock.h"
#include "devices/open_device.h"
#include "devices/process/hand_process_device.h"
#include "geometry/util/number_text.h"
#include "standin/plane_servo.h"

namespace {

using namespace tactooth;

constexpr double kSpin = 3;  // s

std::atomic<double> spinsFrom{0};  // s of the monotonic clock

void spin(int) {
    spinsFrom = monotonicSeconds();
    for (const double end = monotonicSeconds() + kSpin; monotonicSeconds() < end;) {
    }
}

/// Sends a signal to the thread of that name.
void signalThread(const std::string& name, int number) {
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
        std::ifstream file(entry.path() / "comm");
        std::string found;
        std::getline(file, found);
        if (found == name) (void)syscall(SYS_tgkill, getpid(), std::stoi(entry.path().filename()), number);
    }
}

volatile std::sig_atomic_t shallSpin = 0;

void say(const std::string& line) {
    std::puts(line.c_str());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody else would end it
    if (argc != 2) return 2;
    std::signal(SIGUSR1, [](int) { shallSpin = 1; });
    std::signal(SIGUSR2, spin);
    const auto device = openDevice(argv[1]);
    if (!device) {
        say("error " + device.error().message());
        return 1;
    }
    const auto& hand = dynamic_cast<const HandProcessDevice&>(**device);
    const test::PlaneServo servo(**device);
    pid_t process = 0;
    const Message* fault = nullptr;
    for (;;) {
        if (const pid_t now = hand.processId(); now != process && now != 0)
            say("hand " + std::to_string(process = now));
        if (const Message* const now = hand.faultMessage(); now != fault) {
            fault = now;
            say(fault != nullptr ? "fault " + fault->in(Language::English) : "no fault");
        }
        if (shallSpin != 0) signalThread("servo", SIGUSR2);
        shallSpin = 0;
        if (const double from = spinsFrom.exchange(0); from > 0) say("spins " + numberText(from));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}
