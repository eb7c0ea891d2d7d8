// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/mouse_manipulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hands/pinhole.h"
#include "session/hands/instrument_poses.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

const Box3 kTooth(Vec3(-5, -5, -10), Vec3(5, 5, 5));

class MouseManipulatorTest : public testing::Test {
protected:
    MouseManipulatorTest() {
        surface_.base = std::make_shared<const SurfacePart>(test::box(kTooth.min(), kTooth.max()));
    }
    void lookFrom(const ViewDirection& direction) { picture_ = test::Pinhole(direction); }
    [[nodiscard]] Vec2 pixelOf(const Vec3& point) const { return picture_.pixelOf(point); }

    Surface surface_;
    test::Pinhole picture_;
    MouseManipulator hand_{kTooth, 1};
};

TEST_F(MouseManipulatorTest, AimingHoversRightAboveThePointUnderTheMouse) {
    hand_.aim(picture_, pixelOf(Vec3(2, 1, 5)), surface_);
    const Vec3 tip = hand_.pose().position;
    EXPECT_NEAR(tip.x(), 2, 1e-6);
    EXPECT_NEAR(tip.y(), 1, 1e-6);
    EXPECT_GT(tip.z(), 6);
    EXPECT_LT(tip.z(), 8);
}

TEST_F(MouseManipulatorTest, APressedHandGoesStraightDownUntilItStandsThePressDepthBeyondTheTool) {
    hand_.setPressDepth(0.7);
    hand_.aim(picture_, pixelOf(Vec3(2, 1, 5)), surface_);
    hand_.press(picture_, pixelOf(Vec3(2, 1, 5)));
    Vec3 tool = hand_.pose().position;
    for (int i = 0; i < 200; ++i) {
        hand_.advance(0.016, tool, 0);
        tool = hand_.pose().position;
        tool.z() = std::max(tool.z(), 5.0);  // a flat tooth
    }
    const Vec3 tip = hand_.pose().position;
    EXPECT_NEAR(tip.x(), 2, 1e-6);
    EXPECT_NEAR(tip.y(), 1, 1e-6);
    EXPECT_NEAR(tip.z(), 5 - 0.7, 1e-9);
}

TEST_F(MouseManipulatorTest, TheApproachIsNoFasterThanACarefulHand) {
    hand_.aim(picture_, pixelOf(Vec3(0, 0, 5)), surface_);
    hand_.press(picture_, pixelOf(Vec3(0, 0, 5)));
    const Vec3 before = hand_.pose().position;
    hand_.advance(0.016, before, 0);
    EXPECT_LE((hand_.pose().position - before).norm(), 20 * 0.016);
}

TEST_F(MouseManipulatorTest, DraggingFollowsTheMouseInThePlaneSquareToTheShaft) {
    hand_.aim(picture_, pixelOf(Vec3(0, 0, 5)), surface_);
    const Vec3 start = hand_.pose().position;
    const Vec3 goal = start + Vec3(1.5, -2, 0);
    hand_.press(picture_, pixelOf(start));
    hand_.drag(picture_, pixelOf(goal));
    EXPECT_LT((hand_.pose().position - goal).norm(), 1e-9);
}

TEST_F(MouseManipulatorTest, AHandPulledFarFromItsToolSlipsAfterIt) {
    hand_.aim(picture_, pixelOf(Vec3(0, 0, 5)), surface_);
    const Vec3 start = hand_.pose().position;
    hand_.press(picture_, pixelOf(start));
    hand_.drag(picture_, pixelOf(start + Vec3(4, 0, 0)));
    hand_.advance(0.016, start, 0);
    const Vec3 offset = hand_.pose().position - start;
    EXPECT_NEAR(Vec3(offset.x(), offset.y(), 0).norm(), 2, 1e-9);
}

TEST_F(MouseManipulatorTest, LettingGoLiftsTheToolOffTheTooth) {
    hand_.setPressDepth(1);
    hand_.press(picture_, Vec2(500, 400));
    hand_.advance(0.1, hand_.pose().position, 0);
    const double pressed = hand_.pose().position.z();
    hand_.release();
    EXPECT_GT(hand_.pose().position.z(), pressed + 1);
    EXPECT_FALSE(hand_.isPressing());
}

TEST_F(MouseManipulatorTest, FromTheEndOfAPressABurMayCutOnlyWhenItIsClear) {
    const auto touchable = std::make_shared<const Surface>(surface_);
    const TriangleMesh bur = test::cylinder(Vec3::Zero(), 0.5, 10, 16);
    hand_.setSurroundings({touchable, std::make_shared<const ToolShape>(bur), surface_.base});
    hand_.aim(picture_, pixelOf(Vec3(1, 0, 5)), surface_);
    Vec3 tool = hand_.pose().position;
    const auto move = [&](int frames, double depth) {
        for (int i = 0; i < frames; ++i) {
            hand_.advance(0.016, tool, depth);
            tool = hand_.pose().position;
            tool.z() = std::max(tool.z(), 4.5);  // in a cavity
        }
    };
    EXPECT_TRUE(hand_.mayCut()) << "it hovers";
    move(100, 0);
    hand_.press(picture_, pixelOf(Vec3(1, 0, 5)));
    move(100, 0.2);
    EXPECT_TRUE(hand_.mayCut()) << "it is pressed";
    hand_.release();
    EXPECT_FALSE(hand_.mayCut()) << "at once";
    hand_.advance(0.016, tool, 0.2);
    EXPECT_FALSE(hand_.mayCut()) << "on its way out";
    move(60, 0);
    EXPECT_GT(tool.z(), 5.2);
    EXPECT_TRUE(hand_.mayCut()) << "outside";
}

TEST_F(MouseManipulatorTest, AWallSeenFromTheSideIsPressedFromTheSide) {
    lookFrom({std::numbers::pi / 2, 0});
    hand_.aim(picture_, pixelOf(Vec3(0, 5, 0)), surface_);
    EXPECT_NEAR(hand_.pressDirection().y(), -1, 1e-9);
    EXPECT_NEAR(hand_.pose().position.y(), 6.5, 1e-6);
}

TEST_F(MouseManipulatorTest, PressDepthStaysWithinWhatADeviceRenders) {
    hand_.setPressDepth(99);
    EXPECT_EQ(hand_.pressDepth(), MouseManipulator::kMaxPressDepth);
    hand_.setPressDepth(-1);
    EXPECT_EQ(hand_.pressDepth(), 0);
}

TEST_F(MouseManipulatorTest, LeaningKeepsTheTipAndStopsWhenTheShaftLiesDown) {
    const Vec3 tip = hand_.pose().position;
    for (int i = 0; i < 100; ++i) hand_.tilt(picture_, Vec2(50, 0));
    EXPECT_EQ(hand_.pose().position, tip);
    const double upright = (hand_.pose().rotation * Vec3::UnitZ()).z();
    EXPECT_LT(upright, 0.2);
    EXPECT_GT(upright, -0.05);
    hand_.resetOrientation();
    EXPECT_NEAR((hand_.pose().rotation * Vec3::UnitZ()).z(), 1, 1e-12);
}

TEST_F(MouseManipulatorTest, TheHandStaysNearTheTooth) {
    hand_.aim(picture_, Vec2(-300, 0), surface_);
    EXPECT_LE(hand_.pose().position.x(), kTooth.max().x() + 6);
    EXPECT_GE(hand_.pose().position.x(), kTooth.min().x() - 6);
}

TEST_F(MouseManipulatorTest, AToolCaughtInItsCavityIsDrawnOutAlongItsShaftBeforeItGoesToTheNextPlace) {
    hand_.aim(picture_, pixelOf(Vec3(2, 1, 5)), surface_);
    const Vec3 aimed = hand_.pose().position;
    Vec3 tool(-1, -1, 3);  // 2 mm below the top: it can only move along z
    double dearest = 0;
    int steps = 0;
    for (; steps < 100 && (hand_.pose().position != aimed || steps == 0); ++steps) {
        hand_.advance(0.016, tool, (hand_.pose().position - tool).norm());
        if (hand_.pose().position == aimed) break;
        dearest = std::max(dearest, (hand_.pose().position - tool).head<2>().norm());
        tool.z() = hand_.pose().position.z();
    }
    EXPECT_LT(steps, 20);
    EXPECT_LT(dearest, 1e-9);
    EXPECT_GT(tool.z(), 6);
    EXPECT_EQ(hand_.pose().position, aimed);
}

TEST_F(MouseManipulatorTest, APlaceThatCannotBeReachedIsTriedOnce) {
    hand_.aim(picture_, pixelOf(Vec3(2, 1, 5)), surface_);
    const Vec3 aimed = hand_.pose().position;
    hand_.advance(0.016, Vec3(0, 0, 8), 5);  // drawn out as far as need be
    for (int i = 0; i < 5; ++i) hand_.advance(0.016, Vec3(0, 0, 3), 5);
    EXPECT_EQ(hand_.pose().position, aimed);
}

/// A tooth as soft as butter, which the bur enters wherever the hand goes.
TEST_F(MouseManipulatorTest, APressToADepthEndsThereHoweverSoftTheToothIs) {
    hand_.setSurroundings({nullptr, nullptr, surface_.base});
    hand_.depthControl().setDepth(1.3);
    hand_.aim(picture_, pixelOf(Vec3(2, 1, 5)), surface_);
    hand_.press(picture_, pixelOf(Vec3(2, 1, 5)));
    double deepest = 5;
    for (int i = 0; i < 200; ++i) {
        hand_.advance(0.016, hand_.pose().position, 0);
        deepest = std::min(deepest, hand_.pose().position.z());
    }
    EXPECT_NEAR(hand_.pose().position.z(), 5 - 1.3, 1e-9);
    EXPECT_GT(deepest, 5 - 1.3 - 0.09) << "not even for a moment";
    EXPECT_NEAR(hand_.pose().position.x(), 2, 1e-6);
    hand_.depthControl().setDepth(1.5);
    for (int i = 0; i < 100; ++i) hand_.advance(0.016, hand_.pose().position, 0);
    EXPECT_NEAR(hand_.pose().position.z(), 5 - 1.5, 1e-9) << "the wheel sets another depth meanwhile";
    hand_.depthControl().setDepth(1);
    hand_.advance(0.016, hand_.pose().position, 0);
    EXPECT_NEAR(hand_.pose().position.z(), 4, 1e-9);
}

TEST_F(MouseManipulatorTest, ByForceNothingEndsThePress) {
    hand_.setSurroundings({nullptr, nullptr, surface_.base});
    hand_.setPressMode(PressMode::Force);
    hand_.press(picture_, pixelOf(Vec3(0, 0, 5)));
    for (int i = 0; i < 400; ++i) hand_.advance(0.016, hand_.pose().position, 0);
    EXPECT_LT(hand_.pose().position.z(), 0);
}

TEST_F(MouseManipulatorTest, ADragToADepthPutsTheTipBelowThePlaceUnderThePointer) {
    hand_.setSurroundings({nullptr, nullptr, surface_.base});
    hand_.depthControl().setDepth(1);
    hand_.press(picture_, pixelOf(Vec3(-2, 0, 5)));
    for (int i = 0; i <= 40; ++i) {
        hand_.drag(picture_, pixelOf(Vec3(-2 + 0.1 * i, 0.5, 5)));
        hand_.advance(0.016, hand_.pose().position, 0);
    }
    for (int i = 0; i < 100; ++i) hand_.advance(0.016, hand_.pose().position, 0);
    EXPECT_LT((hand_.pose().position - Vec3(2, 0.5, 4)).norm(), 1e-6);
}

TEST_F(MouseManipulatorTest, AHeldToolIsPulledNoHarderThanTheHandMay) {
    hand_.setSurroundings({nullptr, nullptr, surface_.base});
    hand_.setPressDepth(0.4);
    hand_.press(picture_, pixelOf(Vec3(-2, 0, 5)));
    hand_.drag(picture_, pixelOf(Vec3(3, 0, 5)));
    const Vec3 tool(-2, 0, 4.5);
    for (int i = 0; i < 50; ++i) hand_.advance(0.016, tool, 0);
    const Vec3 offset = hand_.pose().position - tool;
    EXPECT_NEAR(-offset.z(), 0.4, 1e-9);
    EXPECT_LE(offset.head<2>().norm(), 2 + 1e-9);
    EXPECT_GT(offset.x(), 0.5);
}

/// Beside the tooth there is no depth: the bur goes on at that of the last place.
TEST_F(MouseManipulatorTest, BesideTheToothTheToolSinksNoDeeper) {
    hand_.setSurroundings({nullptr, nullptr, surface_.base});
    hand_.depthControl().setDepth(1);
    hand_.press(picture_, pixelOf(Vec3(4.9, 0, 5)));
    for (int i = 0; i < 100; ++i) hand_.advance(0.016, hand_.pose().position, 0);
    for (int i = 0; i < 200; ++i) {
        hand_.drag(picture_, pixelOf(Vec3(4.9 + 0.01 * i, 0, 5)));
        hand_.advance(0.016, hand_.pose().position, 0);
        EXPECT_GT(hand_.pose().position.z(), 4 - 1e-6);
    }
}

TEST_F(MouseManipulatorTest, TheShaftStandsAsAnExerciseWantsIt) {
    const Vec3 outward = Vec3(0.1, 0.9, 0.2).normalized();
    hand_.alignShaft(outward);
    EXPECT_LT((hand_.pose().rotation * Vec3::UnitZ() - outward).norm(), 1e-12);
    hand_.alignShaft(Vec3::UnitZ());
    const Quat upright = hand_.pose().rotation;
    hand_.resetOrientation();
    EXPECT_LT(upright.angularDistance(hand_.pose().rotation), 1e-9);
}

TEST_F(MouseManipulatorTest, StartsAboveTheMiddleOfTheTooth) {
    EXPECT_EQ(hand_.pose().position.head<2>(), kTooth.center().head<2>());
    EXPECT_GT(hand_.pose().position.z(), kTooth.max().z());
    EXPECT_FALSE(hand_.isPressing());
}

TEST_F(MouseManipulatorTest, ReleasingAHandThatDoesNotPressMovesNothing) {
    const Pose before = hand_.pose();
    hand_.release();
    EXPECT_EQ(hand_.pose().position, before.position);
}

TEST_F(MouseManipulatorTest, TurningTheHandleKeepsTipAndShaft) {
    const Pose before = hand_.pose();
    hand_.rotateHandle(0.5);
    EXPECT_EQ(hand_.pose().position, before.position);
    EXPECT_LT((hand_.pose().rotation * Vec3::UnitZ() - Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_NEAR(hand_.pose().rotation.angularDistance(before.rotation), 0.5, 1e-12);
}

TEST_F(MouseManipulatorTest, OnTheOtherSideTheHandleLeavesTheOtherWay) {
    const MouseManipulator other(kTooth, -1);
    const Vec3 one = hand_.pose().rotation * Vec3::UnitX();
    const Vec3 opposite = other.pose().rotation * Vec3::UnitX();
    EXPECT_LT((opposite - Vec3(-one.x(), one.y(), one.z())).norm(), 1e-12);
}

}  // namespace
}  // namespace tactooth
