// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/frame_pacer.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

using enum FramePacer::Change;

void draw(FramePacer& pacer, double ms, int times = 30) {
    for (int i = 0; i < times; ++i) pacer.recordFrame(Motion, ms);
}

TEST(FramePacer, WithoutAChangeNothingIsDue) {
    const FramePacer pacer;
    EXPECT_FALSE(pacer.isDue(None, 1e6));
}

TEST(FramePacer, AFastComputerDrawsThirtyWholePicturesASecond) {
    FramePacer pacer;
    draw(pacer, 2);
    EXPECT_FALSE(pacer.isDue(Motion, 25));
    EXPECT_TRUE(pacer.isDue(Motion, 33));
    EXPECT_EQ(pacer.resolution(Motion), 1);
}

TEST(FramePacer, ABurThatOnlySpinsIsDrawnWholeAndSeldom) {
    FramePacer pacer;
    draw(pacer, 40);
    EXPECT_FALSE(pacer.isDue(Spin, 100));
    EXPECT_TRUE(pacer.isDue(Spin, 130));
    EXPECT_EQ(pacer.resolution(Spin), 1);
}

TEST(FramePacer, SlowPicturesGetCoarserAndLeaveHalfOfTheTime) {
    FramePacer pacer;
    draw(pacer, 30);
    EXPECT_LT(pacer.resolution(Motion), 1);
    EXPECT_FALSE(pacer.isDue(Motion, 55));
    EXPECT_TRUE(pacer.isDue(Motion, 65));
}

TEST(FramePacer, HoweverSlowTheHandIsFollowedTenTimesASecond) {
    FramePacer pacer;
    draw(pacer, 500);
    EXPECT_TRUE(pacer.isDue(Motion, 100));
}

TEST(FramePacer, OnlyAGraphicsCardDrawsSmoothEdgesOfWhatMoves) {
    FramePacer card;
    EXPECT_FALSE(card.isSmooth());
    draw(card, 0.8);
    EXPECT_TRUE(card.isSmooth());
    draw(card, 3);  // smooth pictures
    EXPECT_TRUE(card.isSmooth());
    FramePacer software;
    draw(software, 6, 300);
    EXPECT_FALSE(software.isSmooth());
}

TEST(FramePacer, SmoothEdgesThatTurnOutTooSlowAreNotTriedAgain) {
    FramePacer pacer;
    draw(pacer, 1);
    EXPECT_TRUE(pacer.isSmooth());
    draw(pacer, 30, 10);
    EXPECT_FALSE(pacer.isSmooth());
    draw(pacer, 1, 300);
    EXPECT_FALSE(pacer.isSmooth());
}

TEST(FramePacer, ItGoesBackToWholePicturesOnlyWhenTheyWouldBeFastEnough) {
    FramePacer pacer;
    draw(pacer, 30);
    draw(pacer, 10);  // a full picture would take twice as long
    EXPECT_LT(pacer.resolution(Motion), 1);
    draw(pacer, 5);
    EXPECT_EQ(pacer.resolution(Motion), 1);
}

}  // namespace
}  // namespace tactooth
