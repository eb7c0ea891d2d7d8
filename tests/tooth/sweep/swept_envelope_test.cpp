// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/sweep/swept_envelope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

double nearestOf(const std::vector<SweepStep>& steps, const Vec3& point) {
    double nearest = kNoBound;
    for (const SweepStep& step : steps) nearest = std::min(nearest, step.sample(point, kNoBound).distance);
    return nearest;
}

/// The smallest distance over many poses on the path.
double sampledDistance(const RevolutionEnvelope& envelope, const Pose& from, const Pose& to, const Vec3& point) {
    constexpr int kPoses = 4000;
    double nearest = kNoBound;
    for (int i = 0; i <= kPoses; ++i) {
        const double t = static_cast<double>(i) / kPoses;
        const Pose pose{(1 - t) * from.position + t * to.position, from.rotation.slerp(t, to.rotation)};
        nearest = std::min(nearest, envelope.signedDistance(pose.inverse() * point));
    }
    return nearest;
}

void expectSweepIsTheUnionOfItsPoses(const TriangleMesh& bur, const Pose& to) {
    const auto envelope = RevolutionEnvelope::make(bur);
    ASSERT_TRUE(envelope);
    const auto steps = sweepSteps(*envelope, Pose{}, to, 0, 0.05);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> side(-1, 1);
    for (int i = 0; i < 100; ++i) {
        const Vec3 point(side(random), side(random), 1 + 1.5 * side(random));
        ASSERT_NEAR(nearestOf(steps, point), sampledDistance(*envelope, Pose{}, to, point), 2e-4);
    }
}

TEST(SweptEnvelope, StraightSlantedMoveOfAFlatCylinder) {
    expectSweepIsTheUnionOfItsPoses(test::cylinder(Vec3::Zero(), 0.5, 2, 48), {Vec3(0.3, 0.1, 0.2), Quat::Identity()});
}

TEST(SweptEnvelope, TurningMoveOfAFlatCylinder) {
    const Quat turn(Eigen::AngleAxisd(0.2, Vec3(1, 2, 0.5).normalized()));
    expectSweepIsTheUnionOfItsPoses(test::cylinder(Vec3::Zero(), 0.5, 2, 48), {Vec3(0.1, -0.1, 0.05), turn});
}

TEST(SweptEnvelope, ABallThatMovesSweepsACapsule) {
    const auto envelope = RevolutionEnvelope::make(test::sphere(Vec3(0, 0, 0.5), 0.5, 256, 256));
    ASSERT_TRUE(envelope);
    const Vec3 move(1, 0.5, -0.25);
    const auto steps = sweepSteps(*envelope, Pose{}, {move, Quat::Identity()}, 0, 0.05);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> side(-1.5, 1.5);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 point(side(random), side(random), side(random));
        const Vec3 offset = point - Vec3(0, 0, 0.5);
        const double t = std::clamp(offset.dot(move) / move.squaredNorm(), 0.0, 1.0);
        const double expected = (offset - t * move).norm() - 0.5;
        if (expected < -0.3) continue;
        ASSERT_NEAR(nearestOf(steps, point), expected, 1e-3);
    }
}

TEST(SweptEnvelope, ClearanceWidensTheSweep) {
    const auto envelope = RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.5, 2, 48));
    ASSERT_TRUE(envelope);
    const Vec3 point(0.8, 0, 1);
    const auto exact = sweepSteps(*envelope, Pose{}, Pose{}, 0, 0.05);
    const auto wide = sweepSteps(*envelope, Pose{}, Pose{}, 0.01, 0.05);
    EXPECT_NEAR(nearestOf(exact, point) - nearestOf(wide, point), 0.01, 1e-12);
}

TEST(SweptEnvelope, LowerBoundAndBoxHoldTheSweep) {
    const auto envelope = RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.5, 2, 48));
    ASSERT_TRUE(envelope);
    const Quat turn(Eigen::AngleAxisd(0.4, Vec3::UnitX()));
    const auto steps = sweepSteps(*envelope, Pose{}, {Vec3(0.2, 0.3, 0.1), turn}, 0.01, 0.05);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(-1.5, 2.5);
    int inside = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 point(side(random), side(random), side(random));
        for (const SweepStep& step : steps) {
            const double distance = step.sample(point, kNoBound).distance;
            ASSERT_LE(step.lowerBound(point), distance + 1e-9);
            if (distance >= 0) continue;
            ++inside;
            ASSERT_TRUE(step.box().contains(point));
        }
    }
    EXPECT_GT(inside, 100);
}

TEST(SweptEnvelopeAsserts, PosesAreRigidAndStepsHaveALength) {
    const RevolutionEnvelope bur = *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.5, 4, 32));
    const Pose here;
    EXPECT_ASSERT(SweepStep(bur, here, {Vec3(0, std::nan(""), 0), Quat::Identity()}, 0));
    EXPECT_ASSERT(SweepStep(bur, here, {Vec3::Zero(), Quat(2, 0, 0, 0)}, 0));
    EXPECT_ASSERT(SweepStep(bur, here, here, -0.1));
    EXPECT_ASSERT(SweepStep(bur, here, here, 0, 0));
    EXPECT_ASSERT(static_cast<void>(sweepSteps(bur, here, here, 0, 0)));
}

}  // namespace
}  // namespace tactooth
