// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/work_budget.h"

#include <gtest/gtest.h>

#include "support/expect_assert.h"

namespace tactooth {

TEST(WorkBudget, IsUnlimitedAtFirst) {
    WorkBudget budget;
    budget.beginMove();
    budget.add(Work{1} << 50);
    EXPECT_FALSE(budget.isLimited());
    EXPECT_FALSE(budget.isExhausted());
    EXPECT_TRUE(budget.mayContinue());
}

TEST(WorkBudget, IsExhaustedAboveItsAllowanceNotAtIt) {
    WorkBudget budget;
    budget.setLimit(100);
    budget.beginMove();
    budget.add(100);
    EXPECT_FALSE(budget.isExhausted());
    budget.add(1);
    EXPECT_TRUE(budget.isExhausted());
    EXPECT_FALSE(budget.mayContinue());
}

TEST(WorkBudget, DoesNotCountTheFirstListAgainstTheAllowance) {
    WorkBudget budget;
    budget.setLimit(100);
    budget.beginMove();
    budget.addListWork(5000, true);
    EXPECT_FALSE(budget.isExhausted());
    EXPECT_EQ(budget.work(), 5000);
    budget.addListWork(101, false);
    EXPECT_TRUE(budget.isExhausted());
    EXPECT_EQ(budget.work(), 5101);
}

TEST(WorkBudget, BeginsEachMoveAtZero) {
    WorkBudget budget;
    budget.setLimit(100);
    budget.beginMove();
    budget.addDistance();
    budget.addListWork(7, true);
    budget.beginMove();
    EXPECT_EQ(budget.work(), 0);
    EXPECT_EQ(budget.distances(), 0);
    budget.add(101);
    EXPECT_TRUE(budget.isExhausted()) << "the first list of the move before does not count";
}

TEST(WorkBudget, GivesAtMostTwoBudgetsAfterMovesThatRanOut) {
    WorkBudget budget;
    budget.setLimit(100);
    for (int move = 0; move < 3; ++move) {
        budget.beginMove();
        budget.add(move == 0 ? 100 : 200);
        EXPECT_FALSE(budget.isExhausted()) << move;
        budget.add(1);
        EXPECT_TRUE(budget.isExhausted()) << move;
        budget.endMove(true, true);
    }
    budget.beginMove();
    budget.endMove(false, true);
    budget.beginMove();
    budget.add(101);
    EXPECT_TRUE(budget.isExhausted()) << "one budget again";
}

TEST(WorkBudget, AMoveThatWasStoppedForAnotherReasonDoesNotRaiseTheAllowance) {
    WorkBudget budget;
    budget.setLimit(100);
    budget.beginMove();
    budget.add(100);
    budget.endMove(true, false);
    EXPECT_FALSE(budget.isStarved());
    EXPECT_EQ(budget.stepScale(), 1);
    budget.beginMove();
    budget.add(101);
    EXPECT_TRUE(budget.isExhausted());
}

TEST(WorkBudget, StarvedMovesQuarterTheFirstStepDownToItsLeast) {
    WorkBudget budget;
    budget.setLimit(10);
    for (const double scale : {0.25, 0.0625, 1.0 / 64, 1.0 / 64}) {
        budget.beginMove();
        budget.add(1000);
        budget.endMove(true, false);
        EXPECT_TRUE(budget.isStarved());
        EXPECT_EQ(budget.stepScale(), scale);
    }
    budget.add(1000);
    EXPECT_TRUE(budget.mayContinue()) << "at the shortest step it continues whatever it costs";
    for (const double scale : {1.0 / 32, 1.0 / 16}) {
        budget.beginMove();
        budget.endMove(false, true);
        EXPECT_FALSE(budget.isStarved());
        EXPECT_EQ(budget.stepScale(), scale);
    }
}

TEST(WorkBudget, EndsStarvationButKeepsTheAllowance) {
    WorkBudget budget;
    budget.setLimit(10);
    budget.beginMove();
    budget.add(11);
    budget.endMove(true, false);
    budget.endStarvation();
    EXPECT_FALSE(budget.isStarved());
    EXPECT_EQ(budget.stepScale(), 1);
    budget.beginMove();
    budget.add(20);
    EXPECT_FALSE(budget.isExhausted());
}

TEST(WorkBudget, OnlyANewLimitResetsTheAllowance) {
    WorkBudget budget;
    budget.setLimit(10);
    budget.beginMove();
    budget.add(11);
    budget.endMove(true, true);
    budget.setLimit(10);
    budget.beginMove();
    budget.add(20);
    EXPECT_FALSE(budget.isExhausted());
    budget.setLimit(15);
    EXPECT_TRUE(budget.isExhausted());
}

TEST(WorkBudget, CountsGjkRunsWithAndWithoutTheirCost) {
    WorkBudget budget;
    budget.beginMove();
    budget.addDistance();
    budget.countDistances(2);
    EXPECT_EQ(budget.distances(), 3);
    EXPECT_EQ(budget.work(), cost::kDistance);
}

TEST(WorkBudget, AssertsThatWorkIsNeverNegative) {
    WorkBudget budget;
    EXPECT_ASSERT(budget.add(-1));
    EXPECT_ASSERT(budget.addListWork(-1, true));
    EXPECT_ASSERT(budget.countDistances(0));
    EXPECT_ASSERT(budget.setLimit(-1));
}

}  // namespace tactooth
