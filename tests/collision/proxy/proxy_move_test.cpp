// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/proxy_move.h"

#include <gtest/gtest.h>

#include "collision/proxy/proxy_fixture.h"

namespace tactooth {
namespace {

/// The parts of a solver, and moves of either kind.
struct MoveScene {
    ProxyContext context;
    SweepCheck sweep;
    SettledState settled;

    explicit MoveScene(const Pose& start, Freedom freedom = Freedom::Translation)
        : context(test::sceneOf(test::smallBox(), test::floorBlock(), start, freedom)) {
        settled.placeAt(start);
    }
    MoveResult to(const Pose& goal) {
        if (context.state.rotates()) return ProxyMove<RotationConstraints>(context, sweep, settled, goal).run();
        return ProxyMove<TranslationConstraints>(context, sweep, settled, goal).run();
    }
};

constexpr Freedom kBoth[] = {Freedom::Translation, Freedom::TranslationAndRotation};

}  // namespace

TEST(ProxyMove, ReachesAFreeGoal) {
    for (const Freedom freedom : kBoth) {
        MoveScene scene(test::poseAt(0, 0, 1), freedom);
        const Pose goal{Vec3(0.2, 0.1, 0.9), Quat(Eigen::AngleAxisd(0.1, Vec3::UnitZ()))};
        EXPECT_EQ(scene.to(goal).status, MoveStatus::Reached);
        EXPECT_LT((scene.context.state.pose.position - goal.position).norm(), 1e-9);
        EXPECT_TRUE(scene.context.state.pose.rotation.isApprox(goal.rotation, 1e-9));
        EXPECT_TRUE(scene.settled.answers(goal));
    }
}

TEST(ProxyMove, EndsInContactOnTheFloor) {
    for (const Freedom freedom : kBoth) {
        MoveScene scene(test::poseAt(0, 0, 0.1), freedom);
        MoveResult result;
        for (int i = 0; i < 20; ++i) result = scene.to(test::poseAt(0.05, 0, -0.1));
        EXPECT_EQ(result.status, MoveStatus::InContact);
        EXPECT_GE(result.contactCount, 1);
        EXPECT_NEAR(scene.context.state.pose.position.z(), scene.context.state.margin, 1e-6);
        EXPECT_EQ(scene.context.contacts.count, result.contactCount);
    }
}

TEST(ProxyMove, LeavesAnOverlappingToolWhereItIs) {
    MoveScene scene(test::poseAt(0, 0, -0.1));
    EXPECT_EQ(scene.to(test::poseAt(0, 0, 0.1)).status, MoveStatus::Overlapping);
    EXPECT_EQ(scene.context.state.pose.position, Vec3(0, 0, -0.1));
}

TEST(ProxyMove, StopsWhenTheBudgetIsUsedUpAndContinuesInTheNextMove) {
    const Pose goal = test::poseAt(0.3, 0, -0.2);
    const Work whole = MoveScene(test::poseAt(0, 0, 0.1)).to(goal).work;
    MoveScene scene(test::poseAt(0, 0, 0.1));
    scene.context.budget.setLimit(whole / 4);
    EXPECT_EQ(scene.to(goal).status, MoveStatus::OutOfBudget);
    EXPECT_FALSE(scene.settled.answers(goal));
    for (int i = 0; i < 200; ++i) (void)scene.to(goal);
    EXPECT_NEAR((scene.context.state.pose.position - Vec3(0.3, 0, 0)).norm(), 0, 1e-5);
}

TEST(ProxyMove, CountsTheSamePoseForAStationaryTool) {
    MoveScene scene(test::poseAt(0, 0, 0.1));
    for (int i = 0; i < 20; ++i) (void)scene.to(test::poseAt(0, 0, -0.1));
    const std::uint64_t stamp = scene.context.state.poseStamp;
    const Vec3 position = scene.context.state.pose.position;
    EXPECT_EQ(scene.to(test::poseAt(0, 0, -0.1)).status, MoveStatus::InContact);
    EXPECT_EQ(scene.context.state.poseStamp, stamp);
    EXPECT_EQ(scene.context.state.pose.position, position);
}

TEST(ProxyMove, ScalesTheMarginWithTheToolAndTheDistanceFromTheOrigin) {
    for (const double away : {0.0, 1000.0}) {
        MoveScene scene(test::poseAt(away, 0, 1));
        (void)scene.to(test::poseAt(away, 0, 2));
        EXPECT_NEAR(scene.context.state.margin, 1e-7 * scene.context.state.tool->radius() + 1e-10 * std::max(away, 2.0),
                    1e-18);
    }
}

TEST(ProxyMove, WaitsAtTheEndOfAGivenListIfTheBudgetIsLimited) {
    const Pose start = test::poseAt(0, 0, 0.02);
    ProxyContext dense =
        test::sceneOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 100, 60), test::sphere(Vec3(0, 0, -2), 2, 300, 200), start);
    MoveScene scene(start);
    scene.context = std::move(dense);
    test::listAround(scene.context, 0.03);
    scene.context.budget.setLimit(1'000'000'000);
    const Pose far = test::poseAt(0.3, 0, -0.1);
    for (int move = 0; move < ListWait::kMaxWaits; ++move) {
        EXPECT_EQ(scene.to(far).status, MoveStatus::OutOfBudget);
        EXPECT_EQ(scene.context.horizon.ownRebuilds(), 0U);
    }
    (void)scene.to(far);
    EXPECT_EQ(scene.context.horizon.ownRebuilds(), 1U) << "no list has come";
}

}  // namespace tactooth
