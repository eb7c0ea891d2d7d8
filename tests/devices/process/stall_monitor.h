// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <mutex>
#include <thread>
#include <vector>

namespace tactooth::test {

/// Watches how long each processor of this machine keeps a thread of the highest priority waiting: no program can
/// answer sooner.
class StallMonitor {
public:
    StallMonitor();
    /// s: the longest stall of any processor since the last call.
    [[nodiscard]] double takeLongest();

private:
    void watch(const std::stop_token& stop, unsigned processor);

    std::mutex mutex_;
    double longest_ = 0;  // s; protected by the mutex
    std::vector<std::jthread> threads_;
};

/// How long the threads of a process stand in line for a processor. Source: the second number of
/// /proc/PID/task/TID/schedstat.
class ProcessorWait {
public:
    /// Begins to measure.
    explicit ProcessorWait(pid_t process);
    /// s, all threads together; 0 where the process has ended.
    [[nodiscard]] double seconds() const;

private:
    pid_t process_;
    double before_;  // s, since the threads began
};

}  // namespace tactooth::test
