// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/rotation_constraints.h"

#include <gtest/gtest.h>

#include <limits>

#include "collision/proxy/proxy_fixture.h"

namespace tactooth {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr NearPair kPair{0, 0, 0};

/// A triangle of the tool over a large one of the tooth in the plane z = 0, with a wide list. Its corner 0 is lowest.
ProxyContext overTriangle(double height) {
    ProxyContext context = test::contextOf(test::oneTriangle({-1, 0, 0}, {1, 1, 0.5F}, {1, -1, 0.5F}),
                                           test::oneTriangle({-9, -9, 0}, {9, -9, 0}, {0, 9, 0}),
                                           test::poseAt(0, 0, height), Freedom::TranslationAndRotation);
    test::listAround(context, 2, 1);
    return context;
}

CandidateStep stepTo(const ProxyContext& context, const Pose& goal) {
    CandidateStep step;
    step.goal = goal;
    step.rotateBy(context.scene.pose.rotation, 0);
    step.limits = {100, 0.9, kInfinity};
    return step;
}

WatchedPair planeOf(ProxyContext& context) {
    WatchedPair watched = context.planes.watch(context.scene, kPair, Vec3::Zero());
    EXPECT_TRUE(context.ensurePlane(watched));
    return watched;
}

Quat rolledBy(double angle) { return Quat(Eigen::AngleAxisd(angle, Vec3(0, 0.6, 0.8))); }

}  // namespace

TEST(RotationConstraints, StepToTheGoalWithoutConstraints) {
    ProxyContext context = overTriangle(0.5);
    const Pose goal{Vec3(0.1, -0.2, 0.4), rolledBy(0.3)};
    CandidateStep step = stepTo(context, goal);
    RotationConstraints constraints;
    constraints.restart(context, step);
    ASSERT_TRUE(constraints.solve(context, step));
    const Pose end = step.end(context.scene.pose);
    EXPECT_LT((end.position - goal.position).norm(), 1e-12);
    EXPECT_TRUE(end.rotation.isApprox(goal.rotation, 1e-12));
    EXPECT_FALSE(step.clipping.isClipped);
    EXPECT_FALSE(step.clipping.isByList);
}

TEST(RotationConstraints, RestartEndsTheStepWhereItBegins) {
    ProxyContext context = overTriangle(0.5);
    CandidateStep step = stepTo(context, {Vec3(1, 1, 1), rolledBy(0.3)});
    RotationConstraints constraints;
    constraints.restart(context, step);
    EXPECT_EQ(step.shift, Vec3(0, 0, 0));
    EXPECT_TRUE(step.matrix.isApprox(Mat3::Identity(), 1e-15));
    EXPECT_EQ(constraints.set().count(), 0);
}

TEST(RotationConstraints, KeepTheCornerThatTheGoalWouldBringBelowThePlane) {
    ProxyContext context = overTriangle(1e-5);
    CandidateStep step = stepTo(context, {Vec3(0, 0, -0.01), Quat::Identity()});
    RotationConstraints constraints;
    constraints.restart(context, step);
    ASSERT_TRUE(constraints.solve(context, step));
    constraints.add(context, step, planeOf(context));
    ASSERT_TRUE(constraints.solve(context, step));
    const Triangle3 tool = context.scene.tool->cornersAt(step.end(context.scene.pose), 0);
    EXPECT_NEAR(tool[0].z(), test::kMargin, 1e-4) << "to the second order of the rotation";
    EXPECT_NE(step.matrix, Mat3(Mat3::Identity())) << "the tool gives way by rotation";
}

TEST(RotationConstraints, ObeyGaussPrincipleOfLeastConstraint) {
    // One contact: length^2 * turn = share * lever x normal, and shift of the centre = share * normal.
    ProxyContext context = overTriangle(1e-5);
    const Pose goal{Vec3(0, 0, -0.001), Quat::Identity()};
    CandidateStep step = stepTo(context, goal);
    RotationConstraints constraints;
    constraints.restart(context, step);
    ASSERT_TRUE(constraints.solve(context, step));
    constraints.add(context, step, planeOf(context));
    ASSERT_TRUE(constraints.solve(context, step));
    MoveResult result;
    constraints.storeContacts(context, result);
    ASSERT_EQ(result.contactCount, 1);
    const Vec3 centre = context.scene.tool->centre();
    const Pose end = step.end(context.scene.pose);
    const Vec3 shift = end * centre - goal * centre;
    const Vec3 normal = result.contacts[0].normal;
    EXPECT_LT((shift - result.contacts[0].multiplier * normal).norm(), 1e-9);
    const Eigen::AngleAxisd turn(end.rotation * goal.rotation.conjugate());
    const double length = context.scene.characteristicLength();
    const Vec3 lever = result.contacts[0].point - end * centre;
    EXPECT_LT(
        (length * length * turn.angle() * turn.axis() - result.contacts[0].multiplier * lever.cross(normal)).norm(),
        1e-5);
}

TEST(RotationConstraints, ShortenTheStepToItsAllowance) {
    ProxyContext context = overTriangle(0.5);
    CandidateStep step = stepTo(context, {Vec3(0.3, 0, 0.5), Quat::Identity()});
    step.limits.allowance = 0.1;
    RotationConstraints constraints;
    constraints.restart(context, step);
    ASSERT_TRUE(constraints.solve(context, step));
    EXPECT_NEAR(step.shift.x(), 0.1, 1e-12);
    EXPECT_TRUE(step.clipping.isClipped);
    EXPECT_FALSE(step.clipping.isByList);
}

TEST(RotationConstraints, ShortenTheRotationToItsBoundAndToTheList) {
    ProxyContext context = overTriangle(0.5);
    CandidateStep step = stepTo(context, {Vec3(0, 0, 0.5), rolledBy(0.4)});
    step.limits.rotationBound = 0.1;
    RotationConstraints constraints;
    constraints.restart(context, step);
    ASSERT_TRUE(constraints.solve(context, step));
    EXPECT_NEAR(chordBetween(step.rotation, Quat::Identity()), 2 * std::sin(0.05), 1e-9);
    EXPECT_FALSE(step.clipping.isByList);
    step.limits = {100, 0.2, kInfinity};
    ASSERT_TRUE(constraints.solve(context, step));
    EXPECT_LE(chordBetween(step.rotation, Quat::Identity()), 0.2);
    EXPECT_GT(chordBetween(step.rotation, Quat::Identity()), 0.199);
    EXPECT_TRUE(step.clipping.isByList);
}

TEST(RotationConstraints, PredictShiftAndRotation) {
    ProxyContext context = overTriangle(0.5);
    CandidateStep step = stepTo(context, {Vec3(0.1, 0, 0.7), rolledBy(0.2)});
    double turn = 0;
    RotationConstraints constraints;
    EXPECT_LT((constraints.predictShift(context, step, turn) - Vec3(0.1, 0, 0.2)).norm(), 1e-12);
    EXPECT_NEAR(turn, 2 * std::sin(0.1), 1e-12);
}

TEST(RotationConstraints, RestartWithFeaturesThatStillTouchOnly) {
    ProxyContext context = overTriangle(1e-5);
    CandidateStep step = stepTo(context, {Vec3(0, 0, -0.01), Quat::Identity()});
    RotationConstraints constraints;
    constraints.restart(context, step);
    ASSERT_TRUE(constraints.solve(context, step));
    constraints.add(context, step, planeOf(context));
    ASSERT_TRUE(constraints.solve(context, step));
    MoveResult result;
    constraints.storeContacts(context, result);
    ASSERT_EQ(context.contacts.count, 1);
    constraints.restart(context, step);
    EXPECT_EQ(constraints.set().count(), 1);
    context.contacts.features[0].kind = FeaturePair::Kind::EdgeOverEdge;  // as if it had slid off
    context.contacts.features[0].tooth = 0;
    constraints.restart(context, step);
    EXPECT_EQ(constraints.set().count(), 0);
}

}  // namespace tactooth
