// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/plane_finder.h"

#include <gtest/gtest.h>

#include "collision/proxy/proxy_fixture.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

constexpr NearPair kPair{0, 0, 0};

/// A triangle of the tool over a large one of the tooth in the plane z = 0.
ProxyContext overTriangle(double height) {
    return test::contextOf(test::oneTriangle({0, 0, 0}, {1, 0, 0.5F}, {0, 1, 0.5F}),
                           test::oneTriangle({-9, -9, 0}, {9, -9, 0}, {0, 9, 0}), test::poseAt(0, 0, height));
}

WatchedPair planeOf(ProxyContext& context) {
    WatchedPair watched = context.planes.watch(context.scene, kPair, Vec3::Zero());
    EXPECT_TRUE(context.ensurePlane(watched));
    return watched;
}

}  // namespace

TEST(PlaneFinder, FindsThePlaneBetweenACornerAndAFace) {
    for (const double height : {2.0, 0.1, 3e-6}) {
        ProxyContext context = overTriangle(height);
        const WatchedPair watched = planeOf(context);
        EXPECT_NEAR(watched.plane.normal.z(), 1, 1e-9);
        EXPECT_NEAR(watched.plane.offset, 0, 1e-9);
        EXPECT_NEAR(gapAt(*context.scene.tool, watched, Mat3::Identity(), context.scene.pose.position), height, 1e-9);
    }
}

TEST(PlaneFinder, FindsNoPlaneBetweenTrianglesThatMeet) {
    ProxyContext context = overTriangle(-0.1);
    WatchedPair watched = context.planes.watch(context.scene, kPair, Vec3::Zero());
    EXPECT_FALSE(context.ensurePlane(watched));
}

TEST(PlaneFinder, SeparatesRandomTrianglesWithEveryCornerOnItsSide) {
    std::mt19937 random(5);
    int separated = 0;
    for (int i = 0; i < 500; ++i) {
        const auto corner = [&] { return Vec3f(test::randomVector(random).cast<float>()); };
        ProxyContext context = test::contextOf(test::oneTriangle(corner(), corner(), corner()),
                                               test::oneTriangle(corner(), corner(), corner()),
                                               {1.5 * test::randomVector(random), Quat::Identity()});
        WatchedPair watched = context.planes.watch(context.scene, kPair, Vec3::Zero());
        if (!context.ensurePlane(watched)) continue;
        ++separated;
        for (const Vec3& p : context.scene.toothTriangle(kPair))
            EXPECT_LE(watched.plane.normal.dot(p), watched.plane.offset + 1e-12);
        for (const Vec3& p : context.scene.toolTriangle(kPair))
            EXPECT_GT(watched.plane.normal.dot(p), watched.plane.offset);
    }
    EXPECT_GT(separated, 100);
    EXPECT_LT(separated, 500);
}

TEST(PlaneFinder, UsesAPlaneOfThePresentPoseWithoutGjk) {
    ProxyContext context = overTriangle(0.5);
    WatchedPair watched = planeOf(context);
    EXPECT_EQ(context.budget.distances(), 1);
    EXPECT_TRUE(context.ensurePlane(watched));
    EXPECT_EQ(context.budget.distances(), 1);
    ++context.scene.poseStamp;
    EXPECT_TRUE(context.ensurePlane(watched));
    EXPECT_EQ(context.budget.distances(), 2);
    EXPECT_EQ(watched.plane.stamp, context.scene.poseStamp);
}

TEST(PlaneFinder, RemembersThePlaneOfAPairUntilItIsCleared) {
    ProxyContext context = overTriangle(0.5);
    const WatchedPair found = planeOf(context);
    const Vec3 guess = Vec3::UnitX();
    EXPECT_EQ(context.planes.watch(context.scene, kPair, guess).plane.normal, found.plane.normal);
    context.planes.clear();
    const WatchedPair forgotten = context.planes.watch(context.scene, kPair, guess);
    EXPECT_EQ(forgotten.plane.normal, guess);
    EXPECT_NE(forgotten.plane.stamp, context.scene.poseStamp);
}

TEST(PlaneFinder, PrefersThePlaneOfAFaceWhereTheTrianglesTouch) {
    // The tool's corner stands beside the corner of the tooth and above it: GJK's plane is tilted, and that of the face
    // leaves nearly as much.
    ProxyContext context =
        test::contextOf(test::oneTriangle({0, 0, 0}, {1, 1, 3}, {1, -1, 3}),
                        test::oneTriangle({-9, -9, 0}, {0, 0, 0}, {-9, 9, 0}), test::poseAt(0.3e-6, 0, 1.5e-6));
    const WatchedPair watched = planeOf(context);
    EXPECT_NEAR(watched.plane.normal.z(), 1, 1e-12);
    EXPECT_NEAR(watched.plane.offset, 0, 1e-12);
}

TEST(PlaneFinder, ReplacesThePlaneByOneThatTouchesTheTooth) {
    ProxyContext context = overTriangle(0.5);
    WatchedPair watched = planeOf(context);
    const Vec3 normal(0.6, 0, 0.8);
    const Triangle3 tooth = context.scene.toothTriangle(kPair);
    context.planes.replace(context.scene, tooth, normal, watched);
    EXPECT_EQ(watched.plane.normal, normal);
    EXPECT_EQ(watched.plane.offset, highestAlong(tooth, normal));
    EXPECT_EQ(context.planes.watch(context.scene, kPair, Vec3::Zero()).plane.normal, normal);
}

TEST(PlaneFinder, MeasuresTheGapOfTheLowestCornerAtAnyPose) {
    ProxyContext context = overTriangle(0.5);
    const WatchedPair watched = planeOf(context);
    std::mt19937 random(9);
    for (int i = 0; i < 100; ++i) {
        const Pose pose{test::randomVector(random),
                        Quat(Eigen::AngleAxisd(i, test::randomVector(random).normalized()))};
        double lowest = 1e9;
        for (const Vec3& corner : context.scene.tool->cornersAt(pose, 0))
            lowest = std::min(lowest, watched.plane.normal.dot(corner) - watched.plane.offset);
        EXPECT_NEAR(gapAt(*context.scene.tool, watched, pose.rotation.toRotationMatrix(), pose.position), lowest,
                    1e-12);
    }
}

TEST(PlaneFinder, AssertsThatNormalsAreUnit) {
    ProxyContext context = overTriangle(0.5);
    WatchedPair watched = planeOf(context);
    EXPECT_ASSERT(context.planes.storeOfStep(1, kPair, Vec3(0, 0, 2), 0));
    EXPECT_ASSERT(context.planes.replace(context.scene, context.scene.toothTriangle(kPair), Vec3::Zero(), watched));
    watched.plane.normal = Vec3(0, 0, 0.5);
    EXPECT_ASSERT((void)gapAt(*context.scene.tool, watched, Mat3::Identity(), Vec3::Zero()));
}

}  // namespace tactooth
