// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/instrument_poses.h"

#include <gtest/gtest.h>

#include <random>

namespace tactooth {
namespace {

const Box3 kTooth(Vec3(-5, -6, -15), Vec3(5, 6, 7));

Vec3 mirrored(const Vec3& v) { return {-v.x(), v.y(), v.z()}; }

TEST(UprightGrip, TheHandleLeavesMesiallyAndTowardTheTongue) {
    EXPECT_LT((uprightGrip(1, 0) * Vec3::UnitX() - Vec3::UnitX()).norm(), 1e-12);
    EXPECT_LT((uprightGrip(-1, 0) * Vec3::UnitX() + Vec3::UnitX()).norm(), 1e-12);
    for (const double mesialX : {1.0, -1.0}) EXPECT_LT((uprightGrip(mesialX, 0.4) * Vec3::UnitX()).y(), -0.3);
    EXPECT_LT((uprightGrip(1, 0.4) * Vec3::UnitZ() - Vec3::UnitZ()).norm(), 1e-12);
}

TEST(ParkedMirror, TheGlassSendsTheLineOfSightToTheLingualSideOfTheCrown) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 100; ++i) {
        const Vec3 eye = Vec3(uniform(random), 1 + uniform(random) * 0.3, 0.8).normalized();
        const Pose pose = parkedMirror(kTooth, eye, i % 2 == 0 ? 1 : -1);
        const Vec3 centre = pose.position, normal = pose.rotation * Vec3::UnitZ();
        const Vec3 reflected = (2 * normal.dot(eye) * normal - eye).normalized();
        const Vec3 lingual(0, kTooth.min().y(), kTooth.max().z() - 3.5);
        EXPECT_LT(((lingual - centre).normalized() - reflected).norm(), 1e-9);
    }
}

TEST(ParkedSuction, IsDistalAndBuccalOfTheCrown) {
    for (const double mesialX : {1.0, -1.0}) {
        const Pose tube = parkedSuction(kTooth, mesialX);
        EXPECT_LT(mesialX * tube.position.x(), -5);
        EXPECT_GT(tube.position.y(), 0);
        EXPECT_LT(tube.position.z(), kTooth.max().z());
    }
}

TEST(ParkedSuction, OfTheOtherSideIsTheMirrorImage) {
    const Pose right = parkedSuction(kTooth, 1), left = parkedSuction(kTooth, -1);
    EXPECT_LT((mirrored(right.position) - left.position).norm(), 1e-12);
    EXPECT_LT((mirrored(right.rotation * Vec3::UnitZ()) - left.rotation * Vec3::UnitZ()).norm(), 1e-12);
}

TEST(DentistView, LooksFromBuccalAndAboveAtATooth) {
    const Vec3 eye = directionToEye(dentistView(1));
    EXPECT_NEAR(eye.norm(), 1, 1e-12);
    EXPECT_GT(eye.y(), 0.5);
    EXPECT_GT(eye.z(), 0.3);
}

TEST(DentistView, OfTheOtherSideIsTheMirrorImage) {
    EXPECT_LT((mirrored(directionToEye(dentistView(1))) - directionToEye(dentistView(-1))).norm(), 1e-12);
}

TEST(DirectionToEye, FollowsAzimuthAndElevation) {
    constexpr double kRight = 1.5707963267948966;
    EXPECT_LT((directionToEye({0, 0}) - Vec3::UnitX()).norm(), 1e-12);
    EXPECT_LT((directionToEye({kRight, 0}) - Vec3::UnitY()).norm(), 1e-12);
    EXPECT_LT((directionToEye({0.3, kRight}) - Vec3::UnitZ()).norm(), 1e-12);
}

}  // namespace
}  // namespace tactooth
