// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/work_history.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

CutStep stroke(double time) { return {CutStep::Kind::Stroke, time}; }
CutStep reset(double time) { return {CutStep::Kind::Reset, time}; }

/// A tooth that keeps its steps, and the history that follows it.
class WorkHistoryTest : public ::testing::Test {
protected:
    void cut(const CutStep& step) {
        tooth_.undone.clear();
        tooth_.done.push_back(step);
        follow(step.time + 0.5);
    }
    void carryOut(Edit edit) {
        std::vector<CutStep>& from = edit == Edit::Undo ? tooth_.done : tooth_.undone;
        std::vector<CutStep>& to = edit == Edit::Undo ? tooth_.undone : tooth_.done;
        ASSERT_FALSE(from.empty());
        to.push_back(from.back());
        from.pop_back();
    }
    void follow(double now) { history_.follow(tooth_, events_, now, 0); }
    /// Until the goal is reached.
    void settle() {
        for (int i = 0; i < 100; ++i) {
            const auto edit = history_.advance();
            if (!edit) return;
            EXPECT_FALSE(history_.advance()) << "one request at a time";
            carryOut(*edit);
            follow(50);
        }
    }
    void change(int& value, int to, double time = 0, int kind = 0) {
        const int before = value;
        value = to;
        history_.add({Message::verbatim("change"), time, [&value, before] { value = before; },
                      [&value, to] { value = to; }, kind});
    }
    [[nodiscard]] std::size_t taken() const {
        std::size_t count = 0;
        for (const CutEvent& event : events_.all()) count += event.isTakenBack ? 1 : 0;
        return count;
    }

    CutHistory tooth_;
    CutEvents events_{builtinMaterials(),
                      {{CutEventKind::FirstContact, 1.1, Vec3::Zero()},
                       {CutEventKind::DentinReached, 2.2, Vec3::Zero()},
                       {CutEventKind::PulpExposed, 3.3, Vec3::Zero()}}};
    WorkHistory history_;
};

TEST_F(WorkHistoryTest, UndoesAndRedoesCutsAndChangesInTheirOrder) {
    int bur = 0;
    cut(stroke(1));
    change(bur, 1);
    cut(stroke(2));
    EXPECT_EQ(history_.steps().size(), 3U);
    EXPECT_EQ(history_.position(), 3U);
    history_.undo();
    settle();
    EXPECT_EQ(tooth_.done.size(), 1U);
    EXPECT_EQ(bur, 1);
    history_.undo();
    history_.undo();  // before the first one is done
    settle();
    EXPECT_EQ(bur, 0);
    EXPECT_TRUE(tooth_.done.empty());
    EXPECT_EQ(history_.position(), 0U);
    history_.undo();  // nothing is left
    settle();
    history_.goTo(3);
    settle();
    EXPECT_EQ(bur, 1);
    EXPECT_EQ(tooth_.done.size(), 2U);
    EXPECT_EQ(history_.position(), 3U);
}

TEST_F(WorkHistoryTest, EventsOfAnUndoneStrokeAreTakenBackAndComeBackWithIt) {
    cut(stroke(1));
    cut(stroke(2));
    cut(stroke(3));
    history_.undo();
    settle();
    EXPECT_TRUE(events_.all()[2].isTakenBack);
    EXPECT_EQ(taken(), 1U);
    history_.undo();
    settle();
    EXPECT_EQ(taken(), 2U);
    history_.goTo(3);
    settle();
    EXPECT_EQ(taken(), 0U);
}

TEST_F(WorkHistoryTest, AResetTakesAllEventsBackAndUndoingItBringsBackWhatItTook) {
    cut(stroke(1));
    cut(stroke(2));
    history_.undo();
    settle();
    ASSERT_EQ(taken(), 2U) << "from 2 s on";
    cut(reset(4));
    EXPECT_EQ(taken(), 3U);
    history_.undo();
    settle();
    EXPECT_EQ(taken(), 2U);
}

TEST_F(WorkHistoryTest, ANewCutForgetsWhatWasUndone) {
    cut(stroke(1));
    cut(stroke(2));
    history_.undo();
    settle();
    cut(stroke(5));
    ASSERT_EQ(history_.steps().size(), 2U);
    EXPECT_EQ(history_.steps()[1].time, 5);
    history_.redo();
    settle();
    EXPECT_EQ(history_.position(), 2U);
}

TEST_F(WorkHistoryTest, ACutWhileAnUndoIsAskedForIsWhatIsUndone) {
    cut(stroke(1));
    history_.undo();
    ASSERT_EQ(history_.advance(), Edit::Undo);
    tooth_.done.push_back(stroke(2));  // it comes before the undo
    carryOut(Edit::Undo);
    follow(3);
    EXPECT_EQ(history_.steps().size(), 2U);
    EXPECT_EQ(history_.position(), 1U);
    settle();
    EXPECT_EQ(history_.position(), 1U);
}

TEST_F(WorkHistoryTest, ACutAfterAnUndoThatNobodySawReplacesTheUndoneOne) {
    cut(stroke(1));
    cut(stroke(2));
    history_.undo();
    ASSERT_EQ(history_.advance(), Edit::Undo);
    tooth_.done = {stroke(1), stroke(7)};
    follow(8);
    ASSERT_EQ(history_.steps().size(), 2U);
    EXPECT_EQ(history_.steps()[1].time, 7);
    EXPECT_EQ(history_.position(), 2U);
}

TEST_F(WorkHistoryTest, WhatTheToothForgetsIsForgotten) {
    int value = 0;
    cut(stroke(1));
    change(value, 1);
    cut(stroke(2));
    cut(stroke(3));
    tooth_.done.erase(tooth_.done.begin());
    follow(5);
    EXPECT_EQ(history_.steps().size(), 3U) << "the change came after it";
    EXPECT_EQ(history_.position(), 3U);
    history_.goTo(0);
    settle();
    EXPECT_EQ(value, 0);
    EXPECT_TRUE(tooth_.done.empty());
}

TEST_F(WorkHistoryTest, ASliderThatMovesIsOneStep) {
    int value = 0;
    for (int i = 1; i <= 5; ++i) change(value, i, 10 + 0.2 * i, 7);
    EXPECT_EQ(history_.steps().size(), 1U);
    change(value, 9, 20, 7);
    EXPECT_EQ(history_.steps().size(), 2U);
    history_.goTo(0);
    settle();
    EXPECT_EQ(value, 0);
    history_.goTo(1);
    settle();
    EXPECT_EQ(value, 5);
}

TEST_F(WorkHistoryTest, AChangeAfterAnUndoneCutKeepsTheCutToRedo) {
    int value = 0;
    cut(stroke(1));
    change(value, 1);
    history_.goTo(0);
    settle();
    change(value, 5);
    ASSERT_EQ(history_.steps().size(), 2U);
    EXPECT_EQ(history_.position(), 1U);
    history_.redo();
    settle();
    EXPECT_EQ(tooth_.done.size(), 1U);
    EXPECT_EQ(value, 5);
}

TEST_F(WorkHistoryTest, AJumpShowsHowFarItIsAndCanBeGivenUp) {
    for (int i = 1; i <= 4; ++i) cut(stroke(i));
    EXPECT_FALSE(history_.share());
    history_.goTo(0);
    EXPECT_EQ(history_.share(), 0.0);
    for (int done = 1; done <= 2; ++done) {
        const auto edit = history_.advance();
        ASSERT_EQ(edit, Edit::Undo);
        carryOut(*edit);
        follow(50);
        EXPECT_EQ(history_.share(), done / 4.0);
    }
    history_.giveUp();
    EXPECT_TRUE(history_.isGivingUp());
    EXPECT_EQ(history_.share(), 0.0);
    settle();
    EXPECT_EQ(history_.position(), 4U);
    EXPECT_EQ(tooth_.done.size(), 4U);
    EXPECT_FALSE(history_.share());
    history_.goTo(1);  // a new jump is none that was given up
    EXPECT_FALSE(history_.isGivingUp());
    settle();
    EXPECT_EQ(history_.position(), 1U);
    history_.giveUp();  // nothing is under way
    settle();
    EXPECT_EQ(history_.position(), 1U);
}

TEST_F(WorkHistoryTest, ForAnotherWindowTheCutsRemain) {
    int value = 0;
    cut(stroke(1));
    change(value, 1);
    cut(stroke(2));
    history_.undo();
    settle();
    WorkHistory other = history_.cutsAlone();
    EXPECT_EQ(other.steps().size(), 2U);
    EXPECT_EQ(other.position(), 1U);
    other.follow(tooth_, events_, 60, 40);
    EXPECT_EQ(other.steps()[0].time, 1) << "it knows them";
}

}  // namespace
}  // namespace tactooth
