// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/picture_pace.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

using enum PicturePace::Change;

void draw(PicturePace& pace, double ms, int times = 30) {
    for (int i = 0; i < times; ++i) pace.drew(Motion, ms);
}

TEST(PicturePace, WithoutAChangeNothingIsDue) {
    const PicturePace pace;
    EXPECT_FALSE(pace.isDue(None, 1e6));
}

TEST(PicturePace, AFastComputerDrawsThirtyWholePicturesASecond) {
    PicturePace pace;
    draw(pace, 2);
    EXPECT_FALSE(pace.isDue(Motion, 25));
    EXPECT_TRUE(pace.isDue(Motion, 33));
    EXPECT_EQ(pace.resolution(Motion), 1);
}

TEST(PicturePace, ABurThatOnlySpinsIsDrawnWholeAndSeldom) {
    PicturePace pace;
    draw(pace, 40);
    EXPECT_FALSE(pace.isDue(Spin, 100));
    EXPECT_TRUE(pace.isDue(Spin, 130));
    EXPECT_EQ(pace.resolution(Spin), 1);
}

TEST(PicturePace, SlowPicturesGetCoarserAndLeaveHalfOfTheTime) {
    PicturePace pace;
    draw(pace, 30);
    EXPECT_LT(pace.resolution(Motion), 1);
    EXPECT_FALSE(pace.isDue(Motion, 55));
    EXPECT_TRUE(pace.isDue(Motion, 65));
}

TEST(PicturePace, HoweverSlowTheHandIsFollowedTenTimesASecond) {
    PicturePace pace;
    draw(pace, 500);
    EXPECT_TRUE(pace.isDue(Motion, 100));
}

TEST(PicturePace, OnlyAGraphicsCardDrawsSmoothEdgesOfWhatMoves) {
    PicturePace card;
    EXPECT_FALSE(card.isSmooth());
    draw(card, 0.8);
    EXPECT_TRUE(card.isSmooth());
    draw(card, 3);  // smooth ones
    EXPECT_TRUE(card.isSmooth());
    PicturePace software;
    draw(software, 6, 300);
    EXPECT_FALSE(software.isSmooth());
}

TEST(PicturePace, SmoothEdgesThatTurnOutTooSlowAreNotTriedAgain) {
    PicturePace pace;
    draw(pace, 1);
    EXPECT_TRUE(pace.isSmooth());
    draw(pace, 30, 10);
    EXPECT_FALSE(pace.isSmooth());
    draw(pace, 1, 300);
    EXPECT_FALSE(pace.isSmooth());
}

TEST(PicturePace, ItGoesBackToWholePicturesOnlyWhenTheyWouldBeFastEnough) {
    PicturePace pace;
    draw(pace, 30);
    draw(pace, 10);  // a whole one would take twice as long
    EXPECT_LT(pace.resolution(Motion), 1);
    draw(pace, 5);
    EXPECT_EQ(pace.resolution(Motion), 1);
}

}  // namespace
}  // namespace tactooth
