// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/sweep_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "collision/narrow/gjk.h"
#include "collision/proxy/constraint_set.h"
#include "collision/proxy/proxy_fixture.h"
#include "support/exact_intersection.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

/// Steps that touch or miss by less are left out, mm: far above the margin, the rounding of meshes and of closed forms.
constexpr double kUnclear = 1e-4;

struct CheckResult {
    Violation violation;
    WatchedPair violator{};
};

CheckResult checkOf(SweepCheck& sweep, ProxyContext& context, const CandidateStep& step) {
    SweepQuery query{ConstraintSet<3>()};
    CheckResult result;
    result.violation = sweep.check(context, step, query, result.violator);
    return result;
}

CheckResult checkShift(ProxyContext& context, const Vec3& shift) {
    SweepCheck sweep;
    return checkOf(sweep, context, test::stepBy(context, shift));
}

/// Puts the tool of a context at another pose, with a list around it.
void placeAt(ProxyContext& context, const Pose& pose, double around, double turn) {
    context.scene.pose = pose;
    ++context.scene.poseStamp;
    test::listAround(context, around, turn);
}

Vec3 randomPointIn(const Box3& box, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = box.min()[axis] + unit(random) * box.sizes()[axis];
    return point;
}

Box3 grown(const Box3& box, double by) {
    return {Vec3(box.min() - Vec3::Constant(by)), Vec3(box.max() + Vec3::Constant(by))};
}

/// Whether the segment from `start` to `end` meets a box (Ericson, Real-Time Collision Detection, 5.3.3).
bool segmentMeets(const Box3& box, const Vec3& start, const Vec3& end) {
    double enter = 0, leave = 1;  // fractions of the segment
    for (int axis = 0; axis < 3; ++axis) {
        const double length = end[axis] - start[axis];
        const double low = (box.min()[axis] - start[axis]) / length, high = (box.max()[axis] - start[axis]) / length;
        enter = std::max(enter, std::min(low, high));
        leave = std::min(leave, std::max(low, high));
    }
    return enter <= leave;
}

/// The gap between a triangle of the tooth and the hull of a triangle of the tool at both ends of a step, mm.
double sweptGap(const ProxyContext& context, const CandidateStep& step, const NearPair& pair) {
    std::vector<Vec3> swept;
    for (const Pose& pose : {context.scene.pose, step.end(context.scene.pose)}) {
        for (const Vec3& corner : context.scene.tool->cornersAt(pose, pair.tool)) swept.push_back(corner);
    }
    return distanceBetween(context.scene.toothTriangle(pair), swept, Vec3::UnitZ()).gap;
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
    const CheckResult found = checkShift(context, Vec3(0.1, 0.1, -0.101));
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

// A box that is shifted touches another one when its origin enters their Minkowski difference. A check of both ends of
// a step alone would miss the steps that pass through; a check of its bounding box would find more than there is.
TEST(SweepCheck, AgreesWithTheClosedFormOfTwoBoxes) {
    const Box3 tooth(Vec3(-0.2, -0.15, -0.1), Vec3(0.2, 0.15, 0.1)), tool(Vec3::Constant(-0.1), Vec3::Constant(0.1));
    const Box3 difference(Vec3(tooth.min() - tool.max()), Vec3(tooth.max() - tool.min()));
    const Box3 starts(Vec3::Constant(-0.6), Vec3::Constant(0.6));
    ProxyContext context = test::contextOf(test::box(tool.min(), tool.max()), test::box(tooth.min(), tooth.max()), {});
    std::mt19937 random(21);
    int endInside = 0, passThrough = 0, narrowMisses = 0, farMisses = 0;
    for (int i = 0; i < 600; ++i) {
        const Vec3 start = randomPointIn(starts, random), end = randomPointIn(starts, random);
        if ((end - start).norm() > 1 || grown(difference, kUnclear).contains(start)) continue;
        const bool touches = segmentMeets(grown(difference, -kUnclear), start, end);
        if (touches != segmentMeets(grown(difference, kUnclear), start, end)) continue;
        placeAt(context, test::poseAt(start.x(), start.y(), start.z()), 1.2, 0.01);
        EXPECT_EQ(checkShift(context, end - start).violation, touches ? Violation::Found : Violation::None) << i;
        if (touches) {
            ++(difference.contains(end) ? endInside : passThrough);
        } else {
            Box3 path(start);
            ++(difference.intersects(path.extend(end)) ? narrowMisses : farMisses);
        }
    }
    EXPECT_GT(endInside, 15);
    EXPECT_GT(passThrough, 50);
    EXPECT_GT(narrowMisses, 20);
    EXPECT_GT(farMisses, 100);
}

// A step takes the corners of the tool along straight lines, so a tool that starts above a plane meets it if a corner
// ends below it.
TEST(SweepCheck, AgreesWithTheClosedFormOfARodThatTiltsOverAPlane) {
    const TriangleMesh rod = test::box(Vec3(-2, -0.1, 0), Vec3(2, 0.1, 0.2));
    ProxyContext context = test::contextOf(rod, test::floorBlock(), {});
    std::mt19937 random(22);
    std::uniform_real_distribution<double> height(0.02, 0.3), rise(-0.1, 0.1), angle(-0.15, 0.15), azimuth(-3.14, 3.14);
    int touching = 0, touchingByRotation = 0, missing = 0;
    for (int i = 0; i < 300; ++i) {
        placeAt(context, test::poseAt(0, 0, height(random)), 0.2, 0.2);
        CandidateStep step = test::stepBy(context, Vec3(0, 0, rise(random)));
        const double direction = azimuth(random);
        const Vec3 axis(std::cos(direction), std::sin(direction), 0);
        step.goal.rotation = Quat(Eigen::AngleAxisd(angle(random), axis));
        step.rotateBy(Quat::Identity(), 1);
        const Pose end = step.end(context.scene.pose);
        double lowest = end.position.z() + 1;
        for (const Vec3f& corner : rod.vertices) lowest = std::min(lowest, (end * corner.cast<double>()).z());
        if (std::abs(lowest) < kUnclear) continue;
        SweepCheck sweep;
        EXPECT_EQ(checkOf(sweep, context, step).violation, lowest < 0 ? Violation::Found : Violation::None) << i;
        ++(lowest < 0 ? touching : missing);
        touchingByRotation += lowest < 0 && end.position.z() > 0 ? 1 : 0;
    }
    EXPECT_GT(touching, 50);
    EXPECT_GT(touchingByRotation, 40);
    EXPECT_GT(missing, 100);
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
        const CheckResult result = checkOf(sweep, context, step);
        if (meets) {
            EXPECT_EQ(result.violation, Violation::Found) << i;
        }
        if (result.violation == Violation::Found) {
            EXPECT_LT(sweptGap(context, step, result.violator.pair), test::kMargin) << i << ": no pair meets";
        } else {
            EXPECT_EQ(result.violation, Violation::None) << i;
        }
        ++(result.violation == Violation::Found ? blocked : safe);
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
    const CheckResult first = checkOf(sweep, context, step);
    ASSERT_EQ(first.violation, Violation::Found);
    sweep.addRecent(first.violator.pair);
    context.budget.beginMove();
    const CheckResult again = checkOf(sweep, context, step);
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
