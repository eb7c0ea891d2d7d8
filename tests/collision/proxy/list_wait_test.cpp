// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/list_wait.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

/// How many moves a proxy waits at the end of its list.
int movesWaited(ListWait& wait, bool isListFresh) {
    int moves = 0;
    while (moves < 100 && wait.mayWait(isListFresh)) {
        wait.endMove(true);
        ++moves;
    }
    return moves;
}

int movesRested(ListWait& wait) {
    int moves = 0;
    while (moves < 100 && wait.takeRest()) ++moves;
    return moves;
}

}  // namespace

TEST(ListWait, DoesNotWaitForAListWithoutHavingOne) {
    ListWait wait;
    EXPECT_FALSE(wait.mayWait(false));
    EXPECT_FALSE(wait.mayWait(true));
}

TEST(ListWait, WaitsEightMovesAtTheEndOfAGivenList) {
    ListWait wait;
    wait.listGiven();
    EXPECT_EQ(movesWaited(wait, false), ListWait::kMaxWaits);
}

TEST(ListWait, WaitsWithoutLimitWithinAFreshList) {
    ListWait wait;
    wait.listGiven();
    EXPECT_EQ(movesWaited(wait, true), 100);
}

TEST(ListWait, StartsTheCountAnewAfterAMoveThatDidNotWait) {
    ListWait wait;
    wait.listGiven();
    for (int i = 0; i < 5; ++i) wait.endMove(true);
    wait.endMove(false);
    EXPECT_EQ(movesWaited(wait, false), ListWait::kMaxWaits);
}

TEST(ListWait, StartsTheCountAnewWithTheNextList) {
    ListWait wait;
    wait.listGiven();
    for (int i = 0; i < 8; ++i) wait.endMove(true);
    EXPECT_FALSE(wait.mayWait(false));
    wait.listGiven();
    EXPECT_EQ(movesWaited(wait, false), ListWait::kMaxWaits);
}

TEST(ListWait, DoesNotWaitAtTheEndOfItsOwnList) {
    ListWait wait;
    wait.listGiven();
    wait.listBuilt();
    EXPECT_EQ(movesWaited(wait, true), 0);
}

TEST(ListWait, RestsOnlyIfSomebodyHasGivenAList) {
    ListWait wait;
    wait.beginRest();
    EXPECT_EQ(movesRested(wait), 0);
    wait.listGiven();
    wait.listBuilt();
    wait.beginRest();
    EXPECT_EQ(movesRested(wait), ListWait::kMaxWaits);
}

TEST(ListWait, EndsTheRestWhenAListIsGivenOrTheProxyIsPutElsewhere) {
    ListWait wait;
    wait.listGiven();
    wait.beginRest();
    wait.listGiven();
    EXPECT_EQ(movesRested(wait), 0);
    wait.beginRest();
    wait.endRest();
    EXPECT_EQ(movesRested(wait), 0);
}

}  // namespace tactooth
