// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/candidate_step.h"

#include <gtest/gtest.h>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

Quat rolledBy(double angle) { return Quat(Eigen::AngleAxisd(angle, Vec3::UnitY())); }

CandidateStep stepOf(double fraction) {
    CandidateStep step;
    step.goal.rotation = rolledBy(0.8);
    step.rotateBy(rolledBy(0.2), fraction);
    return step;
}

}  // namespace

TEST(CandidateStep, WithoutRotationEndsInTheSameOrientationBitForBit) {
    const CandidateStep step = stepOf(0);
    EXPECT_EQ(step.rotation.coeffs(), rolledBy(0.2).coeffs());
    EXPECT_EQ(step.matrix, step.startMatrix);
}

TEST(CandidateStep, WithTheWholeRotationEndsInThatOfTheGoalBitForBit) {
    EXPECT_EQ(stepOf(1).rotation.coeffs(), rolledBy(0.8).coeffs());
    EXPECT_EQ(stepOf(1.5).rotation.coeffs(), rolledBy(0.8).coeffs());
}

TEST(CandidateStep, RotatesByAShareOfTheAngle) {
    for (const double share : {0.1, 0.25, 0.9})
        EXPECT_TRUE(stepOf(share).rotation.isApprox(rolledBy(0.2 + share * 0.6), 1e-12)) << share;
}

TEST(CandidateStep, KeepsItsMatricesInStepWithTheOrientations) {
    const CandidateStep step = stepOf(0.3);
    EXPECT_TRUE(step.matrix.isApprox(step.rotation.toRotationMatrix(), 1e-15));
    EXPECT_TRUE(step.startMatrix.isApprox(rolledBy(0.2).toRotationMatrix(), 1e-15));
}

TEST(CandidateStep, EndsAtTheShiftedPose) {
    CandidateStep step = stepOf(0.3);
    step.shift = Vec3(1, 2, 3);
    const Pose end = step.end({Vec3(10, 0, 0), rolledBy(0.2)});
    EXPECT_EQ(end.position, Vec3(11, 2, 3));
    EXPECT_EQ(end.rotation.coeffs(), step.rotation.coeffs());
}

TEST(CandidateStep, AssertsThatItDoesNotRotateBackward) {
    CandidateStep step;
    EXPECT_ASSERT(step.rotateBy(Quat::Identity(), -0.1));
}

}  // namespace tactooth
