// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace tactooth::test {

/// Watches how long each processor of this machine keeps a thread of the highest priority waiting: no program can
/// answer sooner.
class StallMonitor {
public:
    StallMonitor();
    /// s: the longest stall of any processor since the last call, or all those of more than half a millisecond together
    /// if that is longer: they may have hit one thread after the other.
    [[nodiscard]] double takeStalls();

private:
    void watch(const std::stop_token& stop, unsigned processor);

    std::mutex mutex_;
    double longest_ = 0, total_ = 0;  // s; protected by the mutex
    std::vector<std::jthread> threads_;
};

/// How long a thread of a process stands in line for a processor. Source: the second number of
/// /proc/PID/task/TID/schedstat.
class ProcessorWait {
public:
    /// Begins to measure.
    explicit ProcessorWait(pid_t process);
    /// s: the time of the thread that has waited the longest; 0 where the process has ended.
    [[nodiscard]] double seconds() const;

private:
    pid_t process_;
    std::map<std::string, double> before_;  // s, since each thread began, by its number
};

}  // namespace tactooth::test
