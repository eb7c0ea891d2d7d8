// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/sweep_query.h"

#include <gtest/gtest.h>

#include "collision/proxy/constraint_set.h"
#include "collision/proxy/proxy_fixture.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

/// The active set of a tool that stands on planes with these normals.
ConstraintSet<3> activeSet(std::initializer_list<Vec3> normals) {
    ConstraintSet<3> set;
    Qp3Result answer;
    answer.feasible = true;
    for (const Vec3& normal : normals) {
        WatchedPair watched{{0, 0, 0}, {normal, 0, 2}};
        answer.active[answer.activeCount++] = set.add(watched, {normal, 0});
    }
    set.setActive(answer);
    return set;
}

Vec3 tilted(double angle) { return {std::sin(angle), 0, std::cos(angle)}; }

}  // namespace

TEST(SweepQuery, BeginsWithTheNormalsOfTheActiveConstraints) {
    const SweepQuery query(activeSet({Vec3::UnitZ(), Vec3::UnitX()}));
    ASSERT_EQ(query.normals().size(), 2U);
    EXPECT_EQ(query.normals()[1], Vec3::UnitX());
    EXPECT_EQ(query.activeNormals().size(), 2U);
}

TEST(SweepQuery, TakesAPlaneThatSeparatesTwoSuccessivePairsNarrowly) {
    SweepQuery query(activeSet({Vec3::UnitX()}));
    query.addNarrow(tilted(0.1));
    query.addNarrow(tilted(0.2));
    EXPECT_EQ(query.normals().size(), 1U);
    query.addNarrow(tilted(0.2));
    ASSERT_EQ(query.normals().size(), 2U);
    EXPECT_EQ(query.normals()[1], tilted(0.2));
    EXPECT_EQ(query.activeNormals().size(), 1U) << "it is none of the active ones";
}

TEST(SweepQuery, TakesNoMoreNormalsThanItHasRoomFor) {
    SweepQuery query(activeSet({}));
    for (int i = 0; i < 40; ++i) query.addNarrow(tilted(0.1 * (i / 2)));
    EXPECT_EQ(query.normals().size(), static_cast<std::size_t>(kMaxQueryNormals));
}

TEST(SweepQuery, SweepsATriangleFromItsStartToItsEnd) {
    ProxyContext context =
        test::contextOf(test::sphere(Vec3::Zero(), 0.5, 12, 8), test::floorBlock(), test::poseAt(1, 2, 3));
    context.scene.pose.rotation = Quat(Eigen::AngleAxisd(0.3, Vec3(0.6, 0.8, 0)));
    CandidateStep step;
    step.goal.rotation = Quat(Eigen::AngleAxisd(0.5, Vec3(0, 0.6, 0.8)));
    step.rotateBy(context.scene.pose.rotation, 1);
    step.shift = Vec3(0.1, -0.2, 0.3);
    SweepQuery query(activeSet({Vec3(0.6, 0, 0.8)}));
    for (const std::uint32_t triangle : {0U, 40U, 72U, 40U, 0U}) {  // 40 and 72 share a place of the table
        const SweptTool& swept = query.sweep(context.scene, step, triangle);
        const Triangle3 start = context.scene.tool->cornersAt(context.scene.pose, triangle);
        const Triangle3 end = context.scene.tool->cornersAt(step.end(context.scene.pose), triangle);
        for (int i = 0; i < 3; ++i) {
            EXPECT_LT((swept.corners[i] - start[i]).norm(), 1e-12);
            EXPECT_LT((swept.corners[i + 3] - end[i]).norm(), 1e-12);
        }
        EXPECT_NEAR(swept.startLow[0], lowestAlong(start, Vec3(0.6, 0, 0.8)), 1e-12);
        EXPECT_NEAR(swept.endLow[0], lowestAlong(end, Vec3(0.6, 0, 0.8)), 1e-12);
    }
}

TEST(SweepQuery, MeasuresANewNormalOfATriangleThatItKnows) {
    const ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 1));
    const CandidateStep step = test::stepBy(context, Vec3(0, 0, -0.5));
    SweepQuery query(activeSet({}));
    EXPECT_EQ(query.sweep(context.scene, step, 0).measured, 0);
    query.addNarrow(Vec3::UnitZ());
    query.addNarrow(Vec3::UnitZ());
    const SweptTool& swept = query.sweep(context.scene, step, 0);
    ASSERT_EQ(swept.measured, 1);
    EXPECT_EQ(swept.startLow[0], swept.lowAtStart(Vec3::UnitZ()));
    EXPECT_EQ(swept.endLow[0], swept.lowAtEnd(Vec3::UnitZ()));
}

TEST(SweepQuery, SeparatesWithHalfAMarginLeftAtTheEnd) {
    SweptTool swept;
    swept.startLow[0] = 1;
    swept.endLow[0] = 0.5;
    EXPECT_TRUE(SweepQuery::separates(0, swept, 0, 1.0));
    EXPECT_FALSE(SweepQuery::separates(0, swept, 0, 1.1));
    EXPECT_FALSE(SweepQuery::separates(1, swept, 0, 0.0)) << "it touches at the start";
}

TEST(SweepQuery, SeparatesClustersWhoseLeafWasMeasured) {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 0.1));
    test::listAround(context, 0.3);
    const NeighbourList& list = context.horizon.list();
    ASSERT_GT(list.clusters(), 0U);
    for (const double down : {0.05, 0.15}) {
        const CandidateStep step = test::stepBy(context, Vec3(0.01, 0, -down));
        SweepQuery query(activeSet({Vec3::UnitZ()}));
        for (std::size_t cluster = 0; cluster < list.clusters(); ++cluster) {
            SweepQuery fresh(activeSet({Vec3::UnitZ()}));
            EXPECT_FALSE(fresh.separatesCluster(context.scene, step, list, cluster)) << "not measured yet";
            query.measureLeaf(context.scene, list, cluster);
            double top = -1e9;  // of the leaf's triangles
            const NearLeaf& leaf = list.leaf(list.leafOf(cluster));
            for (std::uint32_t rest = leaf.present; rest != 0; rest &= rest - 1)
                top = std::max(top, highestAlong(cornersOf(context.scene.surface->base->mesh(),
                                                           leaf.triangle[std::countr_zero(rest)]),
                                                 Vec3::UnitZ()));
            const Triangle3 end = context.scene.tool->cornersAt(step.end(context.scene.pose), list.toolOf(cluster));
            EXPECT_EQ(query.separatesCluster(context.scene, step, list, cluster),
                      lowestAlong(end, Vec3::UnitZ()) - top >= test::kMargin / 2);
        }
    }
}

TEST(SweepQuery, AssertsThatNormalsAreUnit) {
    SweepQuery query(activeSet({}));
    EXPECT_ASSERT(query.addNarrow(Vec3(0, 0, 1.1)));
}

}  // namespace tactooth
