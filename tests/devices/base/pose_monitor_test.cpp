// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/pose_monitor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

using test::kTick;

TEST(PoseMonitor, AValidPoseIsNoFault) {
    PoseMonitor monitor;
    for (int i = 0; i < 1000; ++i) monitor.update(PoseFault::None, kTick);
    EXPECT_EQ(monitor.faultMessage(), nullptr);
}

TEST(PoseMonitor, AFaultIsSaidForThreeSecondsAndTheNewestOne) {
    PoseMonitor monitor;
    monitor.update(PoseFault::Jump, kTick);
    ASSERT_NE(monitor.faultMessage(), nullptr);
    EXPECT_THAT(monitor.faultMessage()->in(Language::English), HasSubstr("has jumped"));
    for (int i = 0; i < 2990; ++i) monitor.update(PoseFault::None, kTick);
    EXPECT_NE(monitor.faultMessage(), nullptr);
    monitor.update(PoseFault::NotANumber, kTick);
    EXPECT_THAT(monitor.faultMessage()->in(Language::English), HasSubstr("is not a number"));
    for (int i = 0; i < 3010; ++i) monitor.update(PoseFault::None, kTick);
    EXPECT_EQ(monitor.faultMessage(), nullptr);
}

TEST(PoseMonitor, EachFaultHasASentenceOfItsOwn) {
    std::set<std::string> sentences;
    for (const PoseFault fault : {PoseFault::NotANumber, PoseFault::InvalidRotation, PoseFault::Jump,
                                  PoseFault::TooFast, PoseFault::RotatesTooFast, PoseFault::Stale, PoseFault::Force}) {
        const Message* const message = poseFaultMessage(fault);
        ASSERT_NE(message, nullptr);
        EXPECT_THAT(message->in(Language::English), EndsWith("."));
        EXPECT_TRUE(sentences.insert(message->in(Language::English)).second);
    }
    EXPECT_EQ(poseFaultMessage(PoseFault::None), nullptr);
}

}  // namespace
}  // namespace tactooth
