// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/finish/lost_points.h"

#include <gtest/gtest.h>

#include "assessment/rubric/rubric_file.h"

namespace tactooth {
namespace {

/// A mark by the first criteria of a built-in rubric, of which each costs what the list says.
class LostPoints : public ::testing::Test {
protected:
    void lose(const std::vector<double>& points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            mark_.criteria.push_back(
                {.criterion = &rubric_.criteria[i], .measured = {}, .score = {}, .level = {}, .lost = points[i]});
        }
    }
    [[nodiscard]] std::vector<double> listed() const {
        std::vector<double> lost;
        for (const LostPoint& point : lostPoints(mark_)) lost.push_back(point.score->lost);
        return lost;
    }

    Rubric rubric_ = *findRubric("class-1");
    Mark mark_;
};

TEST_F(LostPoints, TheDearestComesFirst) {
    lose({0.5, 7, 0, 3});
    EXPECT_EQ(listed(), (std::vector<double>{7, 3, 0.5, 0}));
}

TEST_F(LostPoints, WhatLimitsTheMarkComesBeforeAllElse) {
    lose({0.5, 7, 0, 3});
    mark_.limitedBy = {&rubric_.criteria[2]};
    EXPECT_EQ(listed(), (std::vector<double>{0, 7, 3, 0.5}));
    EXPECT_TRUE(lostPoints(mark_)[0].limitsMark);
    EXPECT_FALSE(lostPoints(mark_)[1].limitsMark);
}

TEST_F(LostPoints, WhatCostsNothingKeepsTheOrderOfTheRubric) {
    lose({0, 0, 0});
    const std::vector<LostPoint> points = lostPoints(mark_);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i].score->criterion, &rubric_.criteria[i]);
}

TEST_F(LostPoints, AnErrorIsReplayedWhereThereAreARecordingAndAMoment) {
    lose({3, 2});
    mark_.criteria[0].measured.moment = 12.5;
    const std::vector<LostPoint> points = lostPoints(mark_);
    EXPECT_EQ(errorReplay(points[0], true), ErrorReplay::Possible);
    EXPECT_EQ(errorReplay(points[0], false), ErrorReplay::NoRecording);
    EXPECT_EQ(errorReplay(points[1], true), ErrorReplay::NoMoment);
}

TEST(ReplayStart, IsShortlyBeforeTheMomentAndNeverBeforeTheRecording) {
    EXPECT_DOUBLE_EQ(replayStart(12.5), 10.5);
    EXPECT_DOUBLE_EQ(replayStart(1), 0);
}

}  // namespace
}  // namespace tactooth
