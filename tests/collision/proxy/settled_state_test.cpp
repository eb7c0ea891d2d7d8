// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/settled_state.h"

#include <gtest/gtest.h>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

Pose goalAt(double x) { return {Vec3(x, 0, 0), Quat::Identity()}; }

ActiveContacts contactsWith(std::initializer_list<std::uint32_t> triangles) {
    ActiveContacts contacts;
    for (const std::uint32_t triangle : triangles) contacts.pairs[contacts.count++].pair = {0, triangle, 0};
    return contacts;
}

MoveResult ended(MoveStatus status) {
    MoveResult result;
    result.status = status;
    result.iterations = 3;
    result.distances = 5;
    result.work = 1000;
    return result;
}

void move(SettledState& settled, const Pose& goal, MoveStatus status, const ActiveContacts& contacts) {
    settled.beginMove(goal);
    settled.endMove(ended(status), contacts);
}

}  // namespace

TEST(SettledState, AnswersTheSameGoalOnlyOnceItHasSettled) {
    for (const auto& [status, settles] :
         {std::pair(MoveStatus::Reached, true), std::pair(MoveStatus::InContact, true),
          std::pair(MoveStatus::OutOfIterations, false), std::pair(MoveStatus::OutOfBudget, false),
          std::pair(MoveStatus::Overlapping, false)}) {
        SettledState settled;
        EXPECT_FALSE(settled.answers(goalAt(1)));
        move(settled, goalAt(1), status, {});
        EXPECT_EQ(settled.answers(goalAt(1)), settles);
        EXPECT_FALSE(settled.answers(goalAt(1 + 1e-15)));
        EXPECT_FALSE(settled.answers({goalAt(1).position, Quat(-1, 0, 0, 0)})) << "the same rotation in other numbers";
    }
}

TEST(SettledState, ItsResultHasNoWork) {
    SettledState settled;
    move(settled, goalAt(1), MoveStatus::InContact, contactsWith({4}));
    EXPECT_EQ(settled.result().status, MoveStatus::InContact);
    EXPECT_EQ(settled.result().iterations, 0);
    EXPECT_EQ(settled.result().distances, 0);
    EXPECT_EQ(settled.result().work, 0);
}

TEST(SettledState, ComparesPairsInAnyOrder) {
    SettledState settled;
    move(settled, goalAt(1), MoveStatus::InContact, contactsWith({4, 9, 2}));
    EXPECT_TRUE(settled.isUnchanged(contactsWith({2, 4, 9})));
    EXPECT_FALSE(settled.isUnchanged(contactsWith({2, 4})));
    EXPECT_FALSE(settled.isUnchanged(contactsWith({2, 4, 8})));
}

TEST(SettledState, AMoveThatWasCutShortKnowsNoPairs) {
    SettledState settled;
    move(settled, goalAt(1), MoveStatus::OutOfBudget, contactsWith({4}));
    EXPECT_FALSE(settled.isUnchanged(contactsWith({4})));
    EXPECT_TRUE(settled.isUnchanged({}));
}

TEST(SettledState, AsksForAFreshCheckOnceInEightMoves) {
    SettledState settled;
    const ActiveContacts contacts = contactsWith({4, 5});
    int fresh = 0;
    for (int i = 0; i < 80; ++i) {
        move(settled, goalAt(i), MoveStatus::InContact, contacts);
        fresh += settled.isKnown(contacts) ? 0 : 1;
    }
    EXPECT_EQ(fresh, 80 / SettledState::kRecheckInterval);
    EXPECT_FALSE(settled.isKnown(contactsWith({4, 6})));
}

TEST(SettledState, CountsTheDisplacementOfTheGoalFromThePoseOfALaggingProxy) {
    SettledState settled;
    const Pose pose = goalAt(0.5);
    move(settled, goalAt(1), MoveStatus::InContact, {});
    EXPECT_EQ(settled.origin(pose).position, goalAt(1).position);
    move(settled, goalAt(2), MoveStatus::OutOfIterations, {});
    EXPECT_EQ(settled.origin(pose).position, pose.position);
    settled.placeAt(goalAt(3));
    EXPECT_EQ(settled.origin(pose).position, goalAt(3).position);
}

TEST(SettledState, ForgetsWhenTheSurfaceChangesOrTheProxyIsPlaced) {
    for (int how = 0; how < 3; ++how) {
        SettledState settled;
        move(settled, goalAt(1), MoveStatus::InContact, contactsWith({4}));
        if (how == 0) settled.forgetContacts();
        if (how == 1) settled.placeAt(goalAt(1));
        if (how == 2) settled.unsettle();
        EXPECT_FALSE(settled.answers(goalAt(1)));
        EXPECT_EQ(settled.isUnchanged(contactsWith({4})), how == 2) << "the pairs still hold if only the result is old";
        EXPECT_ASSERT((void)settled.result());
    }
}

}  // namespace tactooth
