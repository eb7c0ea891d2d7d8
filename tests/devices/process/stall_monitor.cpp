// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "process/stall_monitor.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

namespace tactooth::test {
namespace {

/// s: how long each thread of a process has stood in line since it began, by its number.
std::map<std::string, double> waitsOf(pid_t process) {
    std::map<std::string, double> waits;
    std::error_code error;
    for (std::filesystem::directory_iterator thread("/proc/" + std::to_string(process) + "/task", error), end;
         !error && thread != end; thread.increment(error)) {
        std::ifstream file(thread->path() / "schedstat");
        double ran = 0, inLine = 0;  // ns
        if (file >> ran >> inLine) waits[thread->path().filename()] = 1e-9 * inLine;
    }
    return waits;
}

}  // namespace

StallMonitor::StallMonitor() {
    for (unsigned processor = 0; processor < std::thread::hardware_concurrency(); ++processor) {
        threads_.emplace_back([this, processor](const std::stop_token& stop) { watch(stop, processor); });
    }
}

void StallMonitor::watch(const std::stop_token& stop, unsigned processor) {
    constexpr auto kStep = std::chrono::microseconds(250);
    constexpr double kNoticed = 0.0005;  // s; a shorter delay is that of an ordinary timer
    // Where a call is refused, the monitor sees fewer stalls, and the test is stricter.
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(processor, &only);
    pthread_setaffinity_np(pthread_self(), sizeof(only), &only);
    sched_param priority{};
    priority.sched_priority = 50;  // below a servo: what delays a servo delays it, too
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
    auto last = std::chrono::steady_clock::now();
    while (!stop.stop_requested()) {
        std::this_thread::sleep_for(kStep);  // the beat that a stall makes late
        const auto now = std::chrono::steady_clock::now();
        const double late = std::chrono::duration<double>(now - last - kStep).count();
        last = now;
        const std::lock_guard lock(mutex_);
        longest_ = std::max(longest_, late);
        if (late > kNoticed) total_ += late;
    }
}

double StallMonitor::takeStalls() {
    const std::lock_guard lock(mutex_);
    return std::max(std::exchange(longest_, 0.0), std::exchange(total_, 0.0));
}

ProcessorWait::ProcessorWait(pid_t process) : process_(process), before_(waitsOf(process)) {}

double ProcessorWait::seconds() const {
    double longest = 0;
    for (const auto& [thread, waited] : waitsOf(process_)) {
        const auto known = before_.find(thread);
        longest = std::max(longest, waited - (known != before_.end() ? known->second : 0));
    }
    return longest;
}

}  // namespace tactooth::test
