// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/neighbour_horizon.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision/proxy/proxy_fixture.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

constexpr double kAround = 0.1;
constexpr double kTurn = 0.02;
constexpr double kTrusted = 0.95;

Quat turnedBy(double angle) { return Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())); }

/// A ball over a fine ball: a list of it is long.
ProxyContext denseContext() {
    ProxyContext context = test::contextOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 100, 60),
                                           test::sphere(Vec3(0, 0, -2), 2, 300, 200), test::poseAt(0, 0, 0.02));
    return context;
}

ProxyContext listedContext() {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 0.2));
    test::listAround(context, kAround, kTurn);
    return context;
}

}  // namespace

TEST(NeighbourHorizon, CoversNothingBeforeTheFirstList) {
    const ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 1));
    EXPECT_FALSE(context.horizon.covers(context.scene.pose, 0));
    EXPECT_FALSE(context.horizon.isFresh(context.scene.pose));
}

TEST(NeighbourHorizon, CoversPositionsWithinTheTrustedPartOfTheMargin) {
    const ProxyContext context = listedContext();
    const Vec3 start = context.scene.pose.position;
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(0.6, 0.8, 0)}) {
        EXPECT_TRUE(context.horizon.coversPosition(start + 0.999 * kTrusted * kAround * direction, 0));
        EXPECT_FALSE(context.horizon.coversPosition(start + 1.001 * kTrusted * kAround * direction, 0));
        EXPECT_TRUE(context.horizon.coversPosition(start + 0.05 * direction, 0.044));
        EXPECT_FALSE(context.horizon.coversPosition(start + 0.05 * direction, 0.046)) << "the margin counts";
    }
}

TEST(NeighbourHorizon, CoversPosesRotatedWithinTheTrustedPartOfTheMargin) {
    const ProxyContext context = listedContext();
    const Vec3 start = context.scene.pose.position;
    EXPECT_TRUE(context.horizon.covers({start, turnedBy(0.018)}, 0));
    EXPECT_FALSE(context.horizon.covers({start, turnedBy(0.0195)}, 0));
    EXPECT_FALSE(context.horizon.covers({start + Vec3(0.2, 0, 0), turnedBy(0.001)}, 0));
}

TEST(NeighbourHorizon, ReturnsTheRotationLeftAsAChord) {
    const ProxyContext context = listedContext();
    for (const double angle : {0.0, 0.005, 0.3, 3.0})
        EXPECT_NEAR(context.horizon.rotationLeft(turnedBy(angle)), kTrusted * kTurn - 2 * std::sin(angle / 2), 1e-12);
}

TEST(NeighbourHorizon, ReturnsTheShareOfAStepThatTheListCovers) {
    const ProxyContext context = listedContext();
    EXPECT_EQ(context.horizon.coveredShare(context.scene, Vec3(0.05, 0, 0)), 1);
    for (const double length : {0.12, 0.19, 0.95}) {
        const double exact = kTrusted * kAround / length;
        const double share = context.horizon.coveredShare(context.scene, Vec3(0, length, 0));
        EXPECT_LE(share, exact);
        EXPECT_NEAR(share, exact, 2.1 * exact / 1024) << "ten bisections";
    }
}

TEST(NeighbourHorizon, RebuildsForTheDisplacementExpected) {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 0.2));
    const Vec3 displacement(0.1, 0.05, 0);
    context.horizon.beginMove(displacement.norm(), 0.001);
    context.horizon.rebuild(context.scene, displacement, 0.001);
    const Pose end{context.scene.pose.position + displacement, turnedBy(0.001)};
    EXPECT_TRUE(context.horizon.covers(end, test::kMargin));
    EXPECT_FALSE(context.horizon.isExhausted(context.scene.pose, displacement, 0.001, false));
    EXPECT_EQ(context.horizon.rebuilds(), 1);
    EXPECT_EQ(context.horizon.ownRebuilds(), 1U);
}

TEST(NeighbourHorizon, IsExhaustedBeforeTheEndOfTheList) {
    ProxyContext context = listedContext();
    const Pose& pose = context.scene.pose;
    context.horizon.beginMove(1, 1);
    EXPECT_FALSE(context.horizon.isExhausted(pose, Vec3(0.09, 0, 0), 0.01, false));
    EXPECT_TRUE(context.horizon.isExhausted(pose, Vec3(0.1, 0, 0), 0.01, false));
    EXPECT_TRUE(context.horizon.isExhausted(pose, Vec3::Zero(), 0.03, false));
    context.horizon.beginMove(0.01, 0.01);
    EXPECT_FALSE(context.horizon.isExhausted(pose, Vec3(0.1, 0, 0), 0.03, false))
        << "no further than twice the shift of the goal, no more than its rotation";
}

TEST(NeighbourHorizon, KeepsALongFreshListIfTheBudgetIsLimited) {
    ProxyContext context = denseContext();
    test::listAround(context, 0.05);
    context.horizon.beginMove(1, 1);
    ASSERT_TRUE(context.horizon.isFresh(context.scene.pose));
    EXPECT_TRUE(context.horizon.isExhausted(context.scene.pose, Vec3(1, 0, 0), 1, false));
    EXPECT_FALSE(context.horizon.isExhausted(context.scene.pose, Vec3(1, 0, 0), 1, true));
    const Pose nearEnd = test::poseAt(0.044, 0, 0.02);
    EXPECT_FALSE(context.horizon.isFresh(nearEnd)) << "85 % of the margin are used up";
    EXPECT_TRUE(context.horizon.isExhausted(nearEnd, Vec3(1, 0, 0), 1, true));
}

TEST(NeighbourHorizon, WaitsOnlyWithALimitedBudgetAndAGivenLongList) {
    ProxyContext context = denseContext();
    test::listAround(context, 0.05);
    EXPECT_TRUE(context.horizon.mayWait(context.scene.pose, true));
    EXPECT_FALSE(context.horizon.mayWait(context.scene.pose, false));
    context.horizon.beginMove(0.01, 0);
    context.horizon.rebuild(context.scene, Vec3(0.01, 0, 0), 0);
    EXPECT_FALSE(context.horizon.mayWait(context.scene.pose, true)) << "its own list";
    ProxyContext sparse = listedContext();
    EXPECT_FALSE(sparse.horizon.mayWait(sparse.scene.pose, true)) << "a short list";
}

TEST(NeighbourHorizon, BuildsFortyListsInAMoveAndFewerAfterAJump) {
    ProxyContext context = listedContext();
    const double radius = context.scene.tool->radius();
    for (const auto& [shift, most] : {std::pair(0.49 * radius, 40), std::pair(0.51 * radius, 28)}) {
        context.horizon.beginMove(shift, 0);
        int lists = 0;
        for (; context.horizon.mayRebuild(radius); ++lists) context.horizon.rebuild(context.scene, Vec3(1e-3, 0, 0), 0);
        EXPECT_EQ(lists, most);
        context.horizon.discountRebuild();
        EXPECT_TRUE(context.horizon.mayRebuild(radius));
    }
}

TEST(NeighbourHorizon, LaterListsOfAMoveCoverTwiceAsMuch) {
    ProxyContext context = listedContext();
    context.horizon.beginMove(0.001, 0);
    std::vector<double> around;
    for (int i = 0; i < 11; ++i) {
        context.horizon.rebuild(context.scene, Vec3(1, 0, 0), 0);
        around.push_back(context.horizon.list().contactMargin().around);
    }
    for (int i = 1; i < 8; ++i) EXPECT_EQ(around[i], around[0]) << i;
    for (int i = 8; i < 11; ++i) EXPECT_NEAR(around[i], 2 * around[i - 1], 1e-9) << i;
}

TEST(NeighbourHorizon, SwapsAGivenListWithItsOwn) {
    ProxyContext context = listedContext();
    NeighbourList other(*context.scene.tool);
    other.buildAll(*context.scene.surface, context.scene.pose, ContactMargin{Vec3::Zero(), 0.5, 0.1});
    context.horizon.take(other);
    EXPECT_EQ(context.horizon.list().contactMargin().around, 0.5);
    EXPECT_EQ(other.contactMargin().around, kAround);
}

TEST(NeighbourHorizon, AssertsThatItsArgumentsMakeSense) {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 1));
    EXPECT_ASSERT(context.horizon.beginMove(-1, 0));
    EXPECT_ASSERT(context.horizon.beginMove(0, std::nan("")));
    EXPECT_ASSERT((void)context.horizon.isExhausted(context.scene.pose, Vec3::Zero(), 0, false));
    EXPECT_ASSERT((void)context.horizon.coversPosition(Vec3::Zero(), -1));
}

}  // namespace tactooth
