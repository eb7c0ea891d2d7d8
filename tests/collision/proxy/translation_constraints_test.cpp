// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/translation_constraints.h"

#include <gtest/gtest.h>

#include "collision/proxy/proxy_fixture.h"

namespace tactooth {
namespace {

constexpr double kHeight = 0.1;

/// A cube over a floor, with a list of half a millimetre.
ProxyContext overFloor() {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, kHeight));
    test::listAround(context, 0.5);
    return context;
}

/// Some pair of a lower triangle of the cube with an upper one of the floor, with its plane.
WatchedPair floorPair(ProxyContext& context) {
    for (std::uint32_t tooth = 0; tooth < 12; ++tooth) {
        for (std::uint32_t tool = 0; tool < 12; ++tool) {
            WatchedPair watched = context.planes.watch(context.scene, {0, tooth, tool}, Vec3::Zero());
            if (!context.ensurePlane(watched)) continue;
            const double gap = gapAt(*context.scene.tool, watched, Mat3::Identity(), context.scene.pose.position);
            if (watched.plane.normal.z() > 0.999 && std::abs(gap - context.scene.pose.position.z()) < 1e-9)
                return watched;
        }
    }
    ADD_FAILURE() << "no such pair";
    return {};
}

}  // namespace

TEST(TranslationConstraints, StepToTheGoalWithoutConstraints) {
    const ProxyContext context = overFloor();
    CandidateStep step = test::stepBy(context, Vec3(0.1, 0.2, -0.3));
    TranslationConstraints constraints;
    ASSERT_TRUE(constraints.solve(context, step));
    EXPECT_EQ(step.shift, Vec3(step.goal.position - context.scene.pose.position));
    EXPECT_FALSE(step.clipping.isClipped);
    EXPECT_FALSE(step.clipping.isByList);
}

TEST(TranslationConstraints, SlideAlongAPlaneAtTheMargin) {
    ProxyContext context = overFloor();
    CandidateStep step = test::stepBy(context, Vec3(0.1, 0.2, -0.3));
    TranslationConstraints constraints;
    constraints.add(context, step, floorPair(context));
    ASSERT_TRUE(constraints.solve(context, step));
    EXPECT_LT((step.shift - Vec3(0.1, 0.2, test::kMargin - kHeight)).norm(), 1e-8);
    EXPECT_EQ(constraints.set().activeCount(), 1);
    EXPECT_NEAR(constraints.set().multiplier(0), 0.3 - kHeight, 2e-6);
}

TEST(TranslationConstraints, ShortenTheStepToItsAllowance) {
    const ProxyContext context = overFloor();
    CandidateStep step = test::stepBy(context, Vec3(0.3, 0, 0));
    step.limits.allowance = 0.1;
    TranslationConstraints constraints;
    ASSERT_TRUE(constraints.solve(context, step));
    EXPECT_NEAR(step.shift.x(), 0.09, 1e-12) << "nine tenths of the allowance";
    EXPECT_TRUE(step.clipping.isClipped);
    EXPECT_FALSE(step.clipping.isByList);
}

TEST(TranslationConstraints, ShortenTheStepToTheList) {
    const ProxyContext context = overFloor();
    CandidateStep step = test::stepBy(context, Vec3(2, 0, 0));
    TranslationConstraints constraints;
    ASSERT_TRUE(constraints.solve(context, step));
    EXPECT_TRUE(context.horizon.coversPosition(context.scene.pose.position + step.shift, test::kMargin));
    EXPECT_NEAR(step.shift.x(), 0.9 * 0.95 * 0.5, 0.001);
    EXPECT_TRUE(step.clipping.isClipped);
    EXPECT_TRUE(step.clipping.isByList);
}

TEST(TranslationConstraints, HaveNoStepBetweenPlanesThatCloseOnEachOther) {
    ProxyContext context = overFloor();
    CandidateStep step = test::stepBy(context, Vec3(0.1, 0, 0));
    step.rotationFraction = 1;  // else to stay is always allowed
    WatchedPair ceiling = floorPair(context);
    ceiling.plane.normal = -ceiling.plane.normal;
    ceiling.plane.offset = 0.1;
    TranslationConstraints constraints;
    constraints.add(context, step, floorPair(context));
    constraints.add(context, step, ceiling);
    step.clipping.isRotationByList = true;
    EXPECT_FALSE(constraints.solve(context, step));
    EXPECT_FALSE(step.clipping.isRotationByList) << "it is the contacts that end the rotation";
}

TEST(TranslationConstraints, AlwaysAllowToStayWithoutRotation) {
    ProxyContext context = overFloor();
    context.scene.margin = 2 * kHeight;  // the tool stands nearer than the margin
    CandidateStep step = test::stepBy(context, Vec3(0, 0, -0.3));
    TranslationConstraints constraints;
    constraints.add(context, step, floorPair(context));
    EXPECT_EQ(constraints.set().spaces()[0].offset, 0);
    step.rotationFraction = 0.5;
    constraints.add(context, step, floorPair(context));
    EXPECT_NEAR(constraints.set().spaces()[1].offset, kHeight, 1e-9);
}

TEST(TranslationConstraints, AreStationaryIfTheActivePlanesLeaveNoDisplacement) {
    ProxyContext context = overFloor();
    context.scene.pose = test::poseAt(0, 0, test::kMargin);
    CandidateStep step = test::stepBy(context, Vec3(0, 0, -0.3));
    TranslationConstraints constraints;
    constraints.add(context, step, floorPair(context));
    ASSERT_TRUE(constraints.solve(context, step));
    EXPECT_TRUE(constraints.isStationary(context, step));
    CandidateStep aside = test::stepBy(context, Vec3(0.1, 0, -0.3));
    ASSERT_TRUE(constraints.solve(context, aside));
    EXPECT_FALSE(constraints.isStationary(context, aside));
    step.rotationFraction = 0.1;
    EXPECT_FALSE(constraints.isStationary(context, step)) << "a rotation moves the tool";
}

TEST(TranslationConstraints, StoreTheActivePairsAsContacts) {
    ProxyContext context = overFloor();
    context.scene.pose = test::poseAt(0, 0, test::kMargin);
    CandidateStep step = test::stepBy(context, Vec3(0, 0, -0.3));
    TranslationConstraints constraints;
    const WatchedPair pair = floorPair(context);
    constraints.add(context, step, pair);
    ASSERT_TRUE(constraints.solve(context, step));
    MoveResult result;
    constraints.storeContacts(context, result);
    ASSERT_EQ(result.contactCount, 1);
    ASSERT_EQ(context.contacts.count, 1);
    EXPECT_EQ(context.contacts.pairs[0].pair, pair.pair);
    EXPECT_EQ(result.contacts[0].tooth, pair.pair.tooth);
    EXPECT_NEAR(result.contacts[0].normal.z(), 1, 1e-9);
    EXPECT_NEAR(result.contacts[0].point.z(), test::kMargin, 1e-9) << "the lowest corner of the tool's triangle";
    EXPECT_NEAR(result.contacts[0].multiplier, 0.3, 1e-5);
}

TEST(TranslationConstraints, RestartWithTheContactsOfTheIterationBefore) {
    ProxyContext context = overFloor();
    const CandidateStep step = test::stepBy(context, Vec3(0, 0, -0.3));
    context.contacts.pairs[0] = floorPair(context);
    context.contacts.count = 1;
    TranslationConstraints constraints;
    constraints.add(context, step, context.contacts.pairs[0]);
    constraints.add(context, step, context.contacts.pairs[0]);
    constraints.restart(context, step);
    ASSERT_EQ(constraints.set().count(), 1);
    EXPECT_EQ(constraints.set().watched(0).pair, context.contacts.pairs[0].pair);
}

TEST(TranslationConstraints, PredictTheShiftThatTheContactsAllow) {
    ProxyContext context = overFloor();
    context.scene.pose = test::poseAt(0, 0, 0);
    const CandidateStep step = test::stepBy(context, Vec3(0.1, 0.2, -0.3));
    double turn = 0.5;
    TranslationConstraints constraints;
    EXPECT_EQ(constraints.predictShift(context, step, turn), Vec3(0.1, 0.2, -0.3));
    context.scene.pose = test::poseAt(0, 0, kHeight);
    const CandidateStep down = test::stepBy(context, Vec3(0.1, 0.2, -0.3));
    context.contacts.pairs[0] = floorPair(context);
    context.contacts.count = 1;
    EXPECT_LT((constraints.predictShift(context, down, turn) - Vec3(0.1, 0.2, -kHeight)).norm(), 1e-8);
    EXPECT_EQ(turn, 0.5);
}

TEST(TranslationConstraints, WarmStartWithTheInactivePairsThatTheIterationMet) {
    // One triangle whose lowest corner stands on a large one: no other plane separates them.
    ProxyContext context =
        test::contextOf(test::oneTriangle({0, 0, 0}, {1, 0, 0.5F}, {0, 1, 0.5F}),
                        test::oneTriangle({-9, -9, 0}, {9, -9, 0}, {0, 9, 0}), test::poseAt(0, 0, test::kMargin));
    test::listAround(context, 0.5);
    const Pose goal = test::poseAt(0, 0, -0.3);
    CandidateStep step = test::stepBy(context, Vec3(0, 0, -0.3));
    TranslationConstraints constraints;
    WatchedPair pair = context.planes.watch(context.scene, {0, 0, 0}, Vec3::Zero());
    ASSERT_TRUE(context.ensurePlane(pair));
    constraints.add(context, step, pair);
    WatchedPair other = pair;
    other.plane.normal = Vec3::UnitX();
    other.plane.offset = -10;
    constraints.add(context, step, other);
    WatchedPair old = other;
    --old.plane.stamp;
    constraints.add(context, step, old);
    ASSERT_TRUE(constraints.solve(context, step));
    MoveResult result;
    constraints.storeContacts(context, result);
    EXPECT_FALSE(constraints.switchPlanes(context, goal)) << "the floor leaves no other way";
    ASSERT_EQ(constraints.warmStart().size(), 1U) << "neither the active pair nor the one of an old pose";
    EXPECT_EQ(constraints.warmStart()[0].plane.normal, Vec3::UnitX());
    constraints.restart(context, step);
    EXPECT_EQ(constraints.set().count(), 2);
    constraints.clearWarmStart();
    EXPECT_TRUE(constraints.warmStart().empty());
}

}  // namespace tactooth
