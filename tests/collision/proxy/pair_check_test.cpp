// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/pair_check.h"

#include <gtest/gtest.h>

#include "collision/proxy/constraint_set.h"
#include "collision/proxy/proxy_fixture.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

constexpr NearPair kPair{0, 0, 0};

struct PairScene {
    ProxyContext context;
    const SeparatingPlane* own = nullptr;
    WatchedPair violator{};

    Violation check(const CandidateStep& step) {
        own = nullptr;
        SweepQuery query{ConstraintSet<3>()};
        return PairCheck(context, step, query).checkPair(kPair, Vec3::Zero(), &own, violator);
    }
    Violation check(const Vec3& shift) { return check(test::stepBy(context, shift)); }
};

/// A triangle of the tool with its lowest corner over a large one of the tooth in the plane z = 0.
PairScene overTriangle(double height, Freedom freedom = Freedom::Translation) {
    return {test::sceneOf(test::oneTriangle({0, 0, 0}, {1, 0, 0.5F}, {0, 1, 0.5F}),
                          test::oneTriangle({-9, -9, 0}, {9, -9, 0}, {0, 9, 0}), test::poseAt(0, 0, height), freedom)};
}

}  // namespace

TEST(PairCheck, ProvesAStepBesideTheTriangleSafeAndKeepsItsPlane) {
    PairScene scene = overTriangle(0.5);
    EXPECT_EQ(scene.check(Vec3(0.3, 0, -0.4)), Violation::None);
    ASSERT_NE(scene.own, nullptr);
    for (const double share : {0.0, 0.5, 1.0}) {
        for (const Vec3& corner : scene.context.state.toolTriangle(kPair))
            EXPECT_GT(scene.own->normal.dot(corner + share * Vec3(0.3, 0, -0.4)), scene.own->offset);
    }
}

TEST(PairCheck, ReusesTheRememberedPlaneWithoutGjk) {
    PairScene scene = overTriangle(0.5);
    ASSERT_EQ(scene.check(Vec3(0, 0, -0.4)), Violation::None);
    scene.context.budget.beginMove();
    EXPECT_EQ(scene.check(Vec3(0.1, 0, -0.39)), Violation::None);
    EXPECT_EQ(scene.context.budget.distances(), 0);
}

TEST(PairCheck, FindsTheViolationWithThePlaneOfThePresentPose) {
    PairScene scene = overTriangle(0.5);
    EXPECT_EQ(scene.check(Vec3(0, 0, -0.6)), Violation::Found);
    EXPECT_EQ(scene.violator.pair, kPair);
    EXPECT_NEAR(scene.violator.plane.normal.z(), 1, 1e-9);
    EXPECT_EQ(scene.violator.plane.stamp, scene.context.state.poseStamp);
}

TEST(PairCheck, LeavesHalfAMargin) {
    PairScene scene = overTriangle(0.5);
    scene.context.state.margin = 0.01;
    EXPECT_EQ(scene.check(Vec3(0, 0, -0.494)), Violation::None);
    EXPECT_EQ(scene.check(Vec3(0, 0, -0.496)), Violation::Found);
}

TEST(PairCheck, AllowsAToolBelowTheMarginToStayAsNear) {
    PairScene scene = overTriangle(0.001);
    scene.context.state.margin = 0.01;
    EXPECT_EQ(scene.check(Vec3(0.2, 0, 0)), Violation::None);
    EXPECT_EQ(scene.check(Vec3(0, 0, -0.0001)), Violation::Found);
}

TEST(PairCheck, KnowsThatThePairOverlaps) {
    PairScene scene = overTriangle(-0.1);
    EXPECT_EQ(scene.check(Vec3(0, 0, 0.01)), Violation::Overlapping);
}

TEST(PairCheck, ProvesARockingToolSafeByARotatingPlaneOnlyIfItMayRotate) {
    // A flat triangle just above the edge of the tooth tips over it: its swept hull meets the edge.
    for (const Freedom freedom : {Freedom::Translation, Freedom::TranslationAndRotation}) {
        PairScene scene{test::sceneOf(test::oneTriangle({-1, -1, 0}, {1, -1, 0}, {0, 2, 0}),
                                      test::oneTriangle({0, -9, 0}, {0, 9, 0}, {0, 0, -9}), test::poseAt(0, 0, 1e-4),
                                      freedom)};
        const Quat tipped(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
        CandidateStep step;
        step.goal = {scene.context.state.pose.position, tipped};
        scene.context.state.pose.rotation = tipped.conjugate();
        step.rotateBy(scene.context.state.pose.rotation, 1);
        const Violation expected = freedom == Freedom::Translation ? Violation::Found : Violation::None;
        EXPECT_EQ(scene.check(step), expected);
        EXPECT_EQ(scene.context.budget.distances() > 2, freedom == Freedom::TranslationAndRotation);
    }
}

TEST(PairCheck, ChecksTheUncertainPairsOfACluster) {
    ProxyContext context = test::sceneOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 0.1));
    test::listAround(context, 0.5);
    NeighbourList& list = context.horizon.list();
    for (const double down : {0.05, 0.2}) {
        const CandidateStep step = test::stepBy(context, Vec3(0, 0, -down));
        const ToolMotion motion = list.motion(context.state.pose, step.end(context.state.pose), test::kMargin, {});
        int violations = 0;
        for (std::size_t cluster = 0; cluster < list.clusters(); ++cluster) {
            SweepQuery query{ConstraintSet<3>()};
            WatchedPair violator;
            PairCheck pairs(context, step, query);
            violations += pairs.checkCluster(cluster, motion, violator) == Violation::Found ? 1 : 0;
        }
        EXPECT_EQ(violations > 0, down > 0.1);
    }
    SweepQuery query{ConstraintSet<3>()};
    WatchedPair violator;
    const CandidateStep step = test::stepBy(context, Vec3::Zero());
    PairCheck pairs(context, step, query);
    EXPECT_ASSERT((void)pairs.checkCluster(list.clusters(), list.motion(context.state.pose, context.state.pose, 0, {}),
                                           violator));
}

}  // namespace tactooth
