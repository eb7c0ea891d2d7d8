// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/proxy_move.h"

#include <gtest/gtest.h>

#include "collision/proxy/proxy_fixture.h"

namespace tactooth {
namespace {

/// The parts of a solver, and moves of either kind.
struct MoveFixture {
    ProxyContext context;
    SweepCheck sweep;
    SettledState settled;

    explicit MoveFixture(const Pose& start, Freedom freedom = Freedom::Translation)
        : context(test::contextOf(test::smallBox(), test::floorBlock(), start, freedom)) {
        settled.placeAt(start);
    }
    MoveResult to(const Pose& goal) {
        if (context.scene.rotates()) return ProxyMove<RotationConstraints>(context, sweep, settled, goal).run();
        return ProxyMove<TranslationConstraints>(context, sweep, settled, goal).run();
    }
};

constexpr Freedom kBoth[] = {Freedom::Translation, Freedom::TranslationAndRotation};

}  // namespace

TEST(ProxyMove, ReachesAFreeGoal) {
    for (const Freedom freedom : kBoth) {
        MoveFixture fixture(test::poseAt(0, 0, 1), freedom);
        const Pose goal{Vec3(0.2, 0.1, 0.9), Quat(Eigen::AngleAxisd(0.1, Vec3::UnitZ()))};
        EXPECT_EQ(fixture.to(goal).status, MoveStatus::Reached);
        EXPECT_LT((fixture.context.scene.pose.position - goal.position).norm(), 1e-9);
        EXPECT_TRUE(fixture.context.scene.pose.rotation.isApprox(goal.rotation, 1e-9));
        EXPECT_TRUE(fixture.settled.answers(goal));
    }
}

TEST(ProxyMove, EndsInContactOnTheFloor) {
    for (const Freedom freedom : kBoth) {
        MoveFixture fixture(test::poseAt(0, 0, 0.1), freedom);
        MoveResult result;
        for (int i = 0; i < 20; ++i) result = fixture.to(test::poseAt(0.05, 0, -0.1));
        EXPECT_EQ(result.status, MoveStatus::InContact);
        EXPECT_GE(result.contactCount, 1);
        EXPECT_NEAR(fixture.context.scene.pose.position.z(), fixture.context.scene.margin, 1e-6);
        EXPECT_EQ(fixture.context.contacts.count, result.contactCount);
    }
}

TEST(ProxyMove, LeavesAnOverlappingToolWhereItIs) {
    MoveFixture fixture(test::poseAt(0, 0, -0.1));
    EXPECT_EQ(fixture.to(test::poseAt(0, 0, 0.1)).status, MoveStatus::Overlapping);
    EXPECT_EQ(fixture.context.scene.pose.position, Vec3(0, 0, -0.1));
}

TEST(ProxyMove, StopsWhenTheBudgetIsUsedUpAndContinuesInTheNextMove) {
    const Pose goal = test::poseAt(0.3, 0, -0.2);
    const Work whole = MoveFixture(test::poseAt(0, 0, 0.1)).to(goal).work;
    MoveFixture fixture(test::poseAt(0, 0, 0.1));
    fixture.context.budget.setLimit(whole / 4);
    EXPECT_EQ(fixture.to(goal).status, MoveStatus::OutOfBudget);
    EXPECT_FALSE(fixture.settled.answers(goal));
    for (int i = 0; i < 200; ++i) (void)fixture.to(goal);
    EXPECT_NEAR((fixture.context.scene.pose.position - Vec3(0.3, 0, 0)).norm(), 0, 1e-5);
}

TEST(ProxyMove, CountsTheSamePoseForAStationaryTool) {
    MoveFixture fixture(test::poseAt(0, 0, 0.1));
    for (int i = 0; i < 20; ++i) (void)fixture.to(test::poseAt(0, 0, -0.1));
    const std::uint64_t stamp = fixture.context.scene.poseStamp;
    const Vec3 position = fixture.context.scene.pose.position;
    EXPECT_EQ(fixture.to(test::poseAt(0, 0, -0.1)).status, MoveStatus::InContact);
    EXPECT_EQ(fixture.context.scene.poseStamp, stamp);
    EXPECT_EQ(fixture.context.scene.pose.position, position);
}

TEST(ProxyMove, ScalesTheMarginWithTheToolAndTheDistanceFromTheOrigin) {
    for (const double away : {0.0, 1000.0}) {
        MoveFixture fixture(test::poseAt(away, 0, 1));
        (void)fixture.to(test::poseAt(away, 0, 2));
        EXPECT_NEAR(fixture.context.scene.margin,
                    1e-7 * fixture.context.scene.tool->radius() + 1e-10 * std::max(away, 2.0), 1e-18);
    }
}

TEST(ProxyMove, WaitsAtTheEndOfAGivenListIfTheBudgetIsLimited) {
    const Pose start = test::poseAt(0, 0, 0.02);
    ProxyContext dense =
        test::contextOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 100, 60), test::sphere(Vec3(0, 0, -2), 2, 300, 200), start);
    MoveFixture fixture(start);
    fixture.context = std::move(dense);
    test::listAround(fixture.context, 0.03);
    fixture.context.budget.setLimit(1'000'000'000);
    const Pose far = test::poseAt(0.3, 0, -0.1);
    for (int move = 0; move < ListWait::kMaxWaits; ++move) {
        EXPECT_EQ(fixture.to(far).status, MoveStatus::OutOfBudget);
        EXPECT_EQ(fixture.context.horizon.ownRebuilds(), 0U);
    }
    (void)fixture.to(far);
    EXPECT_EQ(fixture.context.horizon.ownRebuilds(), 1U) << "no list has come";
}

}  // namespace tactooth
