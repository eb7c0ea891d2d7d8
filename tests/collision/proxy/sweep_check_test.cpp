// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/sweep_check.h"

#include <gtest/gtest.h>

#include "collision/narrow/gjk.h"
#include "collision/proxy/constraint_set.h"
#include "collision/proxy/proxy_fixture.h"
#include "support/exact_intersection.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

struct Found {
    Violation violation;
    WatchedPair violator{};
};

Found checkOf(SweepCheck& sweep, ProxyContext& context, const CandidateStep& step) {
    SweepQuery query{ConstraintSet<3>()};
    Found found;
    found.violation = sweep.check(context, step, query, found.violator);
    return found;
}

Found checkShift(ProxyContext& context, const Vec3& shift) {
    SweepCheck sweep;
    return checkOf(sweep, context, test::stepBy(context, shift));
}

}  // namespace

TEST(SweepCheck, FindsNothingInAStepAwayFromTheTooth) {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 0.1));
    test::listAround(context, 0.5);
    EXPECT_EQ(checkShift(context, Vec3(0.1, 0.1, 0.3)).violation, Violation::None);
    EXPECT_EQ(checkShift(context, Vec3(0.1, 0.1, -0.099)).violation, Violation::None);
}

TEST(SweepCheck, FindsThePairThatAStepBringsTogether) {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 0.1));
    test::listAround(context, 0.5);
    const Found found = checkShift(context, Vec3(0.1, 0.1, -0.101));
    ASSERT_EQ(found.violation, Violation::Found);
    EXPECT_NEAR(found.violator.plane.normal.z(), 1, 1e-9);
    EXPECT_NEAR(found.violator.plane.offset, 0, 1e-9);
    EXPECT_EQ(found.violator.plane.stamp, context.scene.poseStamp);
}

TEST(SweepCheck, FindsAThinWallBetweenTwoFreePoses) {
    ProxyContext context = test::contextOf(test::sphere(Vec3::Zero(), 0.05, 12, 8),
                                           test::box(Vec3(-9, -9, 0), Vec3(9, 9, 0.001)), test::poseAt(0, 0, 0.2));
    test::listAround(context, 1);
    EXPECT_EQ(checkShift(context, Vec3(0, 0, -0.4)).violation, Violation::Found);
    EXPECT_EQ(checkShift(context, Vec3(0.4, 0, 0)).violation, Violation::None);
}

TEST(SweepCheck, KnowsThatTheToolOverlapsAtTheStart) {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, -0.1));
    test::listAround(context, 0.5);
    EXPECT_EQ(checkShift(context, Vec3(0.1, 0, 0)).violation, Violation::Overlapping);
}

TEST(SweepCheck, EndsWhenTheAllowanceIsUsedUp) {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 0.1));
    test::listAround(context, 0.5);
    context.budget.setLimit(1);
    context.budget.beginMove();
    EXPECT_EQ(checkShift(context, Vec3(0, 0, -0.2)).violation, Violation::OutOfBudget);
    EXPECT_EQ(checkShift(context, Vec3(0, 0, 0.2)).violation, Violation::None) << "no cluster is uncertain";
}

TEST(SweepCheck, AgreesWithAnExactTestAlongRandomSteps) {
    const TriangleMesh tooth = test::sphere(Vec3(0, 0, -2), 2, 60, 40);
    const TriangleMesh tool = test::cylinder(Vec3(0, 0, 0), 0.3, 1, 8);
    const test::ExactIntersection oracle(tooth, tool);
    std::mt19937 random(11);
    int safe = 0, blocked = 0;
    for (int i = 0; i < 150; ++i) {
        const Pose start = test::poseAt(0.01 * i - 0.75, 0.1, 0.05);
        if (oracle.at(start)) continue;
        ProxyContext context = test::contextOf(tool, tooth, start);
        test::listAround(context, 0.6);
        SweepCheck sweep;
        const CandidateStep step = test::stepBy(context, 0.15 * test::randomVector(random));
        if (!context.horizon.coversPosition(step.end(start).position, 0)) continue;
        bool meets = false;
        for (int k = 1; k <= 40 && !meets; ++k)
            meets = oracle.at({start.position + k / 40.0 * step.shift, start.rotation});
        const Violation violation = checkOf(sweep, context, step).violation;
        if (meets) {
            EXPECT_EQ(violation, Violation::Found) << i;
        }
        ++(meets ? blocked : safe);
    }
    EXPECT_GT(safe, 20);
    EXPECT_GT(blocked, 20);
}

TEST(SweepCheck, BeginsWithThePairsThatBlockedTheLastSteps) {
    ProxyContext context = test::contextOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 40, 20),
                                           test::sphere(Vec3(0, 0, -2), 2, 100, 80), test::poseAt(0, 0, 0.02));
    test::listAround(context, 0.2);
    SweepCheck sweep;
    const CandidateStep step = test::stepBy(context, Vec3(0.02, 0, -0.1));
    const Found first = checkOf(sweep, context, step);
    ASSERT_EQ(first.violation, Violation::Found);
    sweep.addRecent(first.violator.pair);
    context.budget.beginMove();
    const Found again = checkOf(sweep, context, step);
    EXPECT_EQ(again.violation, Violation::Found);
    EXPECT_EQ(again.violator.pair, first.violator.pair);
    EXPECT_LE(context.budget.work(), cost::kDistance) << "no cluster was opened";
    sweep.clearRecent();
    context.budget.beginMove();
    EXPECT_EQ(checkOf(sweep, context, step).violation, Violation::Found);
    EXPECT_GT(context.budget.work(), 0);
}

TEST(SweepCheck, AssertsThatThereIsAList) {
    ProxyContext context = test::contextOf(test::smallBox(), test::floorBlock(), test::poseAt(0, 0, 0.1));
    EXPECT_ASSERT((void)checkShift(context, Vec3::Zero()));
}

}  // namespace tactooth
