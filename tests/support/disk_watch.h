// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>

#include "support/test_data.h"

namespace tactooth::test {

/// Measures how long this machine takes to write a byte to the disk. No recording can be on the disk sooner.
class DiskWatch {
public:
    /// s: the longest such time since the last call. A write that has not ended counts, too.
    [[nodiscard]] double takeLongest() {
        const Clock::time_point now = Clock::now(), began = began_;
        const double unfinished = now > began ? std::chrono::duration<double>(now - began).count() : 0;
        return std::max(longest_.exchange(0), unfinished);
    }

private:
    using Clock = std::chrono::steady_clock;

    void watch(const std::stop_token& stop) {
        constexpr auto kPause = std::chrono::milliseconds(20);
        const int file = ::open((folder_ / "byte").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
        while (!stop.stop_requested() && file >= 0) {
            if (::pwrite(file, "x", 1, 0) != 1 || ::fsync(file) != 0) break;
            std::this_thread::sleep_for(kPause);
            const Clock::time_point now = Clock::now();
            const double took = std::chrono::duration<double>(now - began_.load() - kPause).count();
            longest_ = std::max(longest_.load(), took);
            began_ = now;
        }
        began_ = Clock::time_point::max();
        if (file >= 0) ::close(file);
    }

    TemporaryFolder folder_;
    std::atomic<double> longest_{0};
    std::atomic<Clock::time_point> began_{Clock::now()};
    std::jthread thread_{[this](const std::stop_token& stop) { watch(stop); }};  // last: it uses the members above
};

}  // namespace tactooth::test
