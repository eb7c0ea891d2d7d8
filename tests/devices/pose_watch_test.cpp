// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/pose_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace tactooth {
namespace {

using ::testing::HasSubstr;

constexpr double kTick = 0.001;  // s

TEST(PoseWatch, AHandThatMovesIsNoTrouble) {
    PoseWatch watch;
    for (int i = 0; i < 1000; ++i) watch.see(Vec3(2.0 * i, 0, 0), true, kTick);  // 2 m/s
    EXPECT_EQ(watch.trouble(), nullptr);
}

TEST(PoseWatch, AJumpAndAPlaceThatIsNoNumberAreSaidForThreeSeconds) {
    PoseWatch watch;
    watch.see(Vec3::Zero(), true, kTick);
    watch.see(Vec3(50, 0, 0), true, kTick);
    ASSERT_NE(watch.trouble(), nullptr);
    EXPECT_THAT(watch.trouble(), HasSubstr("has jumped"));
    for (int i = 0; i < 2990; ++i) watch.see(Vec3(50, 0, 0), true, kTick);
    EXPECT_NE(watch.trouble(), nullptr);
    for (int i = 0; i < 20; ++i) watch.see(Vec3(50, 0, 0), true, kTick);
    EXPECT_EQ(watch.trouble(), nullptr);
    watch.see(Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0), true, kTick);
    EXPECT_THAT(watch.trouble(), HasSubstr("is no number"));
}

TEST(PoseWatch, TimeWithoutAReadingIsTimeToMove) {
    PoseWatch watch;
    watch.see(Vec3::Zero(), true, kTick);
    for (int i = 0; i < 20; ++i) watch.see(Vec3::Zero(), false, kTick);
    watch.see(Vec3(50, 0, 0), true, kTick);
    EXPECT_EQ(watch.trouble(), nullptr);
}

}  // namespace
}  // namespace tactooth
