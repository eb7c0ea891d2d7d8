// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Pauses, changes that can be taken back, saved and other teeth.
#include <gtest/gtest.h>

#include "model/session_model_fixture.h"

namespace tactooth {
namespace {

using test::SessionModelTest;

TEST_F(SessionModelTest, APauseEndsTheRunnerAndKeepsTheTooth) {
    ASSERT_TRUE(ticksCome());
    model_.setPaused(true);
    EXPECT_TRUE(model_.isPaused());
    EXPECT_EQ(model_.runner(), nullptr);
    EXPECT_FALSE(model_.step(0.01).newRunner);
    EXPECT_TRUE(model_.log().ticks().empty());
    model_.setPaused(false);
    const auto result = model_.step(0.01);
    EXPECT_TRUE(result.newRunner);
    EXPECT_FALSE(result.newTooth);
}

TEST_F(SessionModelTest, TheSamePauseTwiceKeepsTheRunner) {
    const LiveRunner* const before = model_.runner();
    model_.setPaused(false);
    EXPECT_EQ(model_.runner(), before);
}

TEST_F(SessionModelTest, ADeviceThatComesInAPauseWaitsForItsEnd) {
    model_.setPaused(true);
    installStill(DeviceSlot::First);
    EXPECT_FALSE(model_.step(0.01).newRunner);
    model_.setPaused(false);
    EXPECT_TRUE(model_.step(0.01).newRunner);
}

/// A change that is no cut, as of the water: it calls back for each undo and redo.
class ChangeInASession : public SessionModelTest {
protected:
    void note() {
        model_.noteChange({Message::verbatim("Water"), 0, [this] { --done_; }, [this] { ++done_; }});
    }
    int done_ = 1;
};

TEST_F(ChangeInASession, IsUndoneAndRedone) {
    note();
    ASSERT_EQ(model_.history().steps().size(), 1U);
    model_.undo();
    EXPECT_EQ(done_, 1) << "before the next step";
    EXPECT_TRUE(soon([&] { return done_ == 0; }));
    model_.redo();
    EXPECT_TRUE(soon([&] { return done_ == 1; }));
    model_.goTo(0);
    EXPECT_TRUE(soon([&] { return done_ == 0; }));
    EXPECT_EQ(model_.history().position(), 0U);
}

TEST_F(ChangeInASession, StaysInAnExamination) {
    note();
    model_.setExamination(true);
    EXPECT_TRUE(model_.isExamination());
    model_.undo();
    model_.goTo(0);
    ASSERT_TRUE(ticksCome());
    EXPECT_EQ(done_, 1);
    model_.setExamination(false);
    model_.undo();
    EXPECT_TRUE(soon([&] { return done_ == 0; }));
}

TEST_F(ChangeInASession, IsForgottenWithTheTooth) {
    note();
    model_.install(test::blockTooth());
    (void)model_.step(0);
    EXPECT_TRUE(model_.history().steps().empty());
    model_.undo();
    ASSERT_TRUE(ticksCome());
    EXPECT_EQ(done_, 1);
}

TEST_F(ChangeInASession, GoesOnInAnotherModelWithItsTooth) {
    note();
    test::SpySound sound;
    SessionModel other(sound, test::runInline);
    other.adopt(model_.history());
    other.install(test::blockTooth());
    other.install(test::flatSessionBur());
    (void)other.step(0);
    EXPECT_EQ(other.history().steps().size(), 1U);
    EXPECT_TRUE(other.isTouched()) << "in the model before";
    other.install(test::blockTooth());
    (void)other.step(0);
    EXPECT_TRUE(other.history().steps().empty()) << "only the first tooth has it";
}

TEST_F(SessionModelTest, CutsAreUnsavedUntilTheyAreSaved) {
    EXPECT_FALSE(model_.isModified());
    test::cutBlock(model_);
    EXPECT_TRUE(model_.isModified());
    const MaterialVolumes removed = model_.runner()->feed().removed();
    model_.markSaved({});
    EXPECT_TRUE(model_.isModified()) << "what was cut while the file was written";
    model_.markSaved(removed);
    EXPECT_FALSE(model_.isModified());
    model_.resetTooth();
    EXPECT_TRUE(soon([&] { return total(model_.runner()->feed().removed()) == 0; }));
    EXPECT_FALSE(model_.isModified()) << "a whole tooth is no loss";
}

TEST_F(SessionModelTest, AnotherToothIsUntouched) {
    test::cutBlock(model_);
    EXPECT_TRUE(model_.isTouched());
    model_.install(DeviceSlot::First, nullptr);
    model_.install(test::blockTooth());
    (void)model_.step(0);
    EXPECT_FALSE(model_.isTouched());
    EXPECT_FALSE(model_.isModified());
}

TEST_F(SessionModelTest, TheMirrorWaitsOnTheSideOfTheOtherHand) {
    const Vec3 right = model_.mirror().pose().rotation * Vec3::UnitX();
    model_.setHand({.leftHanded = true});
    const Vec3 left = model_.mirror().pose().rotation * Vec3::UnitX();
    EXPECT_LT(left.dot(right), 0.99);
    model_.install(test::blockTooth(-1));
    EXPECT_EQ(model_.mesialX(), -1);
    EXPECT_EQ(handleX(model_), 1) << "left-handed on the other side of the jaw";
}

TEST_F(SessionModelTest, AMirrorThatWasPlacedWaitsAgainWithAnotherTooth) {
    const Pose parked = model_.mirror().pose();
    model_.mirror().place({Vec3(1, 2, 3), Quat::Identity()});
    EXPECT_EQ(model_.mirror().pose().position, Vec3(1, 2, 3));
    model_.install(test::blockTooth());
    EXPECT_EQ(model_.mirror().pose().position, parked.position);
}

}  // namespace
}  // namespace tactooth
