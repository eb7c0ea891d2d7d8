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

struct PairFixture {
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
PairFixture overTriangle(double height, Freedom freedom = Freedom::Translation) {
    return {test::contextOf(test::oneTriangle({0, 0, 0}, {1, 0, 0.5F}, {0, 1, 0.5F}),
                            test::oneTriangle({-9, -9, 0}, {9, -9, 0}, {0, 9, 0}), test::poseAt(0, 0, height),
                            freedom)};
}

}  // namespace

TEST(PairCheck, ProvesAStepBesideTheTriangleSafeAndKeepsItsPlane) {
    PairFixture fixture = overTriangle(0.5);
    EXPECT_EQ(fixture.check(Vec3(0.3, 0, -0.4)), Violation::None);
    ASSERT_NE(fixture.own, nullptr);
    for (const double share : {0.0, 0.5, 1.0}) {
        for (const Vec3& corner : fixture.context.scene.toolTriangle(kPair))
            EXPECT_GT(fixture.own->normal.dot(corner + share * Vec3(0.3, 0, -0.4)), fixture.own->offset);
    }
}

TEST(PairCheck, ReusesTheRememberedPlaneWithoutGjk) {
    PairFixture fixture = overTriangle(0.5);
    ASSERT_EQ(fixture.check(Vec3(0, 0, -0.4)), Violation::None);
    fixture.context.budget.beginMove();
    EXPECT_EQ(fixture.check(Vec3(0.1, 0, -0.39)), Violation::None);
    EXPECT_EQ(fixture.context.budget.distances(), 0);
}

TEST(PairCheck, FindsTheViolationWithThePlaneOfThePresentPose) {
    PairFixture fixture = overTriangle(0.5);
    EXPECT_EQ(fixture.check(Vec3(0, 0, -0.6)), Violation::Found);
    EXPECT_EQ(fixture.violator.pair, kPair);
    EXPECT_NEAR(fixture.violator.plane.normal.z(), 1, 1e-9);
    EXPECT_EQ(fixture.violator.plane.stamp, fixture.context.scene.poseStamp);
}

TEST(PairCheck, LeavesHalfAMargin) {
    PairFixture fixture = overTriangle(0.5);
    fixture.context.scene.margin = 0.01;
    EXPECT_EQ(fixture.check(Vec3(0, 0, -0.494)), Violation::None);
    EXPECT_EQ(fixture.check(Vec3(0, 0, -0.496)), Violation::Found);
}

TEST(PairCheck, AllowsAToolBelowTheMarginToStayAsNear) {
    PairFixture fixture = overTriangle(0.001);
    fixture.context.scene.margin = 0.01;
    EXPECT_EQ(fixture.check(Vec3(0.2, 0, 0)), Violation::None);
    EXPECT_EQ(fixture.check(Vec3(0, 0, -0.0001)), Violation::Found);
}

TEST(PairCheck, KnowsThatThePairOverlaps) {
    PairFixture fixture = overTriangle(-0.1);
    EXPECT_EQ(fixture.check(Vec3(0, 0, 0.01)), Violation::Overlapping);
}

TEST(PairCheck, ProvesARockingToolSafeByARotatingPlaneOnlyIfItMayRotate) {
    // A flat triangle just above the edge of the tooth tips over it: its swept hull meets the edge.
    for (const Freedom freedom : {Freedom::Translation, Freedom::TranslationAndRotation}) {
        PairFixture fixture{test::contextOf(test::oneTriangle({-1, -1, 0}, {1, -1, 0}, {0, 2, 0}),
                                            test::oneTriangle({0, -9, 0}, {0, 9, 0}, {0, 0, -9}),
                                            test::poseAt(0, 0, 1e-4), freedom)};
        const Quat tipped(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
        CandidateStep step;
        step.goal = {fixture.context.scene.pose.position, tipped};
        fixture.context.scene.pose.rotation = tipped.conjugate();
        step.rotateBy(fixture.context.scene.pose.rotation, 1);
        const Violation expected = freedom == Freedom::Translation ? Violation::Found : Violation::None;
        EXPECT_EQ(fixture.check(step), expected);
        EXPECT_EQ(fixture.context.budget.distances() > 2, freedom == Freedom::TranslationAndRotation);
    }
}

TEST(PairCheck, ChecksTheUncertainPairsOfACluster) {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 0.1));
    test::listAround(context, 0.5);
    NeighbourList& list = context.horizon.list();
    for (const double down : {0.05, 0.2}) {
        const CandidateStep step = test::stepBy(context, Vec3(0, 0, -down));
        const ToolMotion motion = list.motion(context.scene.pose, step.end(context.scene.pose), test::kMargin, {});
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
    EXPECT_ASSERT((void)pairs.checkCluster(list.clusters(), list.motion(context.scene.pose, context.scene.pose, 0, {}),
                                           violator));
}

}  // namespace tactooth
