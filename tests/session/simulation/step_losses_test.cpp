// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/step_losses.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

ToothLoss loss(double beside) {
    ToothLoss loss;
    loss.beside = beside;
    return loss;
}

CutStep stroke(double time) { return {CutStep::Kind::Stroke, time}; }

TEST(StepLosses, UndoGivesTheLossBeforeAndRedoTheLossAfter) {
    StepLosses steps;
    steps.mark(stroke(1), loss(0));
    steps.follow(1, 0);
    steps.mark(stroke(2), loss(0.5));
    steps.follow(2, 0);
    EXPECT_EQ(steps.undo(loss(0.75)).beside, 0.5);
    EXPECT_EQ(steps.undo(loss(0.5)).beside, 0);
    EXPECT_EQ(steps.history(), (CutHistory{{}, {stroke(2), stroke(1)}}));
    EXPECT_EQ(steps.redo(loss(0)).beside, 0.5);
    EXPECT_EQ(steps.redo(loss(0.5)).beside, 0.75);
    EXPECT_EQ(steps.history(), (CutHistory{{stroke(1), stroke(2)}, {}}));
}

TEST(StepLosses, AMarkWithoutAChangeIsNoStep) {
    StepLosses steps;
    steps.mark(stroke(1), loss(0));
    steps.mark(stroke(2), loss(0));
    steps.follow(1, 0);
    EXPECT_EQ(steps.history().done, std::vector{stroke(2)});
}

TEST(StepLosses, TheOldestGoFirst) {
    StepLosses steps;
    for (int i = 1; i <= 5; ++i) {
        steps.mark(stroke(i), loss(i));
        steps.follow(static_cast<std::size_t>(i), 0);
    }
    steps.follow(3, 0);
    EXPECT_EQ(steps.history().done, (std::vector{stroke(3), stroke(4), stroke(5)}));
}

TEST(StepLosses, AChangeAfterAnUndoDropsWhatWasUndone) {
    StepLosses steps;
    steps.mark(stroke(1), loss(0));
    steps.follow(1, 0);
    EXPECT_EQ(steps.undo(loss(1)).beside, 0);
    steps.follow(1, 0);
    EXPECT_TRUE(steps.history().undone.empty());
    EXPECT_EQ(steps.undo(loss(2)).beside, 0) << "a change without a mark begins where the undo ended";
}

}  // namespace
}  // namespace tactooth
