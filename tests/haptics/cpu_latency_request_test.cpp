// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/cpu_latency_request.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRequests = "/dev/cpu_dma_latency";

/// Number of requests that this program has open.
int requests() {
    int count = 0;
    for (const auto& file : fs::directory_iterator("/proc/self/fd")) {
        std::error_code gone;  // for the descriptor of the folder itself
        count += fs::read_symlink(file.path(), gone) == kRequests ? 1 : 0;
    }
    return count;
}

TEST(CpuLatencyRequest, IsOpenWhileTheObjectLives) {
    ASSERT_EQ(requests(), 0);
    {
        const CpuLatencyRequest one;
        EXPECT_EQ(one.isGranted(), fs::exists(kRequests) && mayLimitCpuLatency());
        EXPECT_EQ(requests(), one.isGranted() ? 1 : 0);
        const CpuLatencyRequest other;
        EXPECT_EQ(requests(), one.isGranted() ? 2 : 0) << "each servo has its own";
    }
    EXPECT_EQ(requests(), 0);
}

}  // namespace
}  // namespace tactooth
