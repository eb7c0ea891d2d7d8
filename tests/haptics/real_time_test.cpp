// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/real_time.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tactooth {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(RealTimeRights, WithAllRightsThereIsNoHint) {
    const RealTimeRights all{.priority = true, .memory = true, .cpuLatency = true};
    EXPECT_EQ(missingRights(all), "");
    EXPECT_EQ(realTimeHint(all), "");
}

TEST(RealTimeRights, AMissingRightIsNamedWithTheFileToWrite) {
    EXPECT_EQ(missingRights({}), "real-time priority, locked memory, keeping the processors from deep sleep");
    EXPECT_THAT(realTimeHint({}), AllOf(HasSubstr("limits.d/tactooth.conf"), HasSubstr("rules.d/99-tactooth.rules")));
    EXPECT_THAT(realTimeHint({.priority = true, .memory = false, .cpuLatency = true}),
                AllOf(HasSubstr("memlock"), Not(HasSubstr("rules.d"))));
    EXPECT_THAT(realTimeHint({.priority = true, .memory = true, .cpuLatency = false}),
                AllOf(HasSubstr("cpu_dma_latency"), Not(HasSubstr("limits.d"))));
}

}  // namespace
}  // namespace tactooth
