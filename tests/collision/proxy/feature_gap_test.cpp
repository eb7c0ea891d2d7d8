// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/feature_gap.h"

#include <gtest/gtest.h>

#include "collision/proxy/proxy_fixture.h"
#include "support/expect_assert.h"

namespace tactooth {
namespace {

using Kind = FeaturePair::Kind;

/// A triangle of the tool, corner 0 lowest, over a large one of the tooth in the plane z = 0; and their plane.
struct FeatureFixture {
    ProxyContext context;
    WatchedPair watched{{0, 0, 0}, {Vec3::UnitZ(), 0, 2}};

    explicit FeatureFixture(double height)
        : context(test::contextOf(test::oneTriangle({0, 0, 0}, {1, 1, 0.5F}, {1, -1, 0.5F}),
                                  test::oneTriangle({-9, -9, 0}, {9, -9, 0}, {0, 9, 0}), test::poseAt(0, 0, height),
                                  Freedom::TranslationAndRotation)) {}
};

}  // namespace

TEST(FeatureGap, OfACornerOverAFaceIsItsHeight) {
    const FeatureFixture fixture(0.3);
    for (int corner = 0; corner < 3; ++corner) {
        const FeatureGap gap = gapOf(fixture.context.scene, fixture.watched, {Kind::CornerOverFace, 0, corner},
                                     test::poseAt(0.2, 0.1, 0.7));
        EXPECT_NEAR(gap.gap, corner == 0 ? 0.7 : 1.2, 1e-12);
        EXPECT_NEAR(gap.normal.z(), 1, 1e-12);
    }
}

TEST(FeatureGap, OfFeaturesWithoutANormalIsThatOfTheCornerOverThePlane) {
    FeatureFixture fixture(0.3);
    fixture.watched.plane = {Vec3(0.6, 0, 0.8), 0.05, 2};
    const FeatureGap gap =
        gapOf(fixture.context.scene, fixture.watched, {Kind::CornerOverPlane, 0, 0}, test::poseAt(0.1, 0, 0.3));
    EXPECT_NEAR(gap.gap, 0.06 + 0.24 - 0.05, 1e-12);
    EXPECT_EQ(gap.normal, Vec3(0.6, 0, 0.8));
    EXPECT_LT((gap.point - Vec3(0.1, 0, 0.3)).norm(), 1e-12);
}

TEST(FeatureGap, TheLowestCornerIsThatOfTheRotatedTool) {
    const FeatureFixture fixture(0.3);
    CandidateStep step = test::stepBy(fixture.context, Vec3::Zero());
    EXPECT_EQ(lowestCorner(fixture.context.scene, step, fixture.watched).tool, 0);
    step.matrix = Eigen::AngleAxisd(1.2, Vec3::UnitX()).toRotationMatrix();
    EXPECT_EQ(lowestCorner(fixture.context.scene, step, fixture.watched).tool, 2);
    step.matrix = Eigen::AngleAxisd(-1.2, Vec3::UnitX()).toRotationMatrix();
    EXPECT_EQ(lowestCorner(fixture.context.scene, step, fixture.watched).tool, 1);
}

TEST(FeatureGap, FindsTheFeaturesThatBlockAStep) {
    const FeatureFixture fixture(0.3);
    EXPECT_FALSE(
        blockingFeatures(fixture.context.scene, test::stepBy(fixture.context, Vec3(0, 0, -0.2)), fixture.watched));
    const auto blocking =
        blockingFeatures(fixture.context.scene, test::stepBy(fixture.context, Vec3(0, 0, -0.4)), fixture.watched);
    ASSERT_TRUE(blocking);
    EXPECT_EQ(*blocking, (FeaturePair{Kind::CornerOverFace, 0, 0}));
}

TEST(FeatureGap, FeaturesTouchAsLongAsTheyStandOverEachOther) {
    FeatureFixture fixture(1e-6);
    const FeaturePair corner{Kind::CornerOverFace, 0, 0};
    EXPECT_TRUE(stillTouch(fixture.context.scene, fixture.watched, corner));
    fixture.context.scene.pose.position.x() = 30;
    EXPECT_FALSE(stillTouch(fixture.context.scene, fixture.watched, corner)) << "the corner has left the face";
    fixture.context.scene.pose.position.x() = 0;
    EXPECT_FALSE(stillTouch(fixture.context.scene, fixture.watched, {Kind::FaceOverCorner, 1, 0}));
}

TEST(FeatureGap, AssertsThatFeaturesAreOfATriangle) {
    FeatureFixture fixture(0.3);
    EXPECT_ASSERT(
        (void)gapOf(fixture.context.scene, fixture.watched, {Kind::CornerOverFace, 0, 3}, test::poseAt(0, 0, 1)));
    fixture.watched.plane.normal.setZero();
    EXPECT_ASSERT(
        (void)gapOf(fixture.context.scene, fixture.watched, {Kind::CornerOverFace, 0, 0}, test::poseAt(0, 0, 1)));
}

}  // namespace tactooth
