// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/pose_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tactooth {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

constexpr double kTick = 0.001;  // s

TEST(PoseWatch, AHandWithoutAFaultIsNoTrouble) {
    PoseWatch watch;
    for (int i = 0; i < 1000; ++i) watch.see(HandFault::None, kTick);
    EXPECT_EQ(watch.trouble(), nullptr);
}

TEST(PoseWatch, AFaultIsSaidForThreeSecondsAndTheNewestOne) {
    PoseWatch watch;
    watch.see(HandFault::Jump, kTick);
    ASSERT_NE(watch.trouble(), nullptr);
    EXPECT_THAT(watch.trouble(), HasSubstr("has jumped"));
    for (int i = 0; i < 2990; ++i) watch.see(HandFault::None, kTick);
    EXPECT_NE(watch.trouble(), nullptr);
    watch.see(HandFault::NoNumber, kTick);
    EXPECT_THAT(watch.trouble(), HasSubstr("is no number"));
    for (int i = 0; i < 3010; ++i) watch.see(HandFault::None, kTick);
    EXPECT_EQ(watch.trouble(), nullptr);
}

TEST(PoseWatch, EachFaultHasASentenceOfItsOwn) {
    std::set<std::string> sentences;
    for (const HandFault fault : {HandFault::NoNumber, HandFault::BrokenTurn, HandFault::Jump, HandFault::TooFast,
                                  HandFault::TurnsTooFast, HandFault::Stale, HandFault::Force}) {
        ASSERT_NE(handFaultText(fault), nullptr);
        EXPECT_THAT(handFaultText(fault), EndsWith("."));
        EXPECT_TRUE(sentences.insert(handFaultText(fault)).second);
    }
    EXPECT_EQ(handFaultText(HandFault::None), nullptr);
}

}  // namespace
}  // namespace tactooth
