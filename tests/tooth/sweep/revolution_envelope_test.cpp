// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/sweep/revolution_envelope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

Vec3 randomPoint(std::mt19937& random, double reach, double low, double high) {
    std::uniform_real_distribution<double> side(-reach, reach);
    std::uniform_real_distribution<double> height(low, high);
    return {side(random), side(random), height(random)};
}

TEST(RevolutionEnvelope, CylinderHasItsExactDistance) {
    const auto envelope = RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.6, 4, 48));
    ASSERT_TRUE(envelope);
    std::mt19937 random(2);
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 point = randomPoint(random, 1.5, -1, 5);
        const double side = std::hypot(point.x(), point.y()) - 0.6;
        const double end = std::max(-point.z(), point.z() - 4);
        const double expected =
            std::min(std::max(side, end), 0.0) + std::hypot(std::max(side, 0.0), std::max(end, 0.0));
        ASSERT_NEAR(envelope->signedDistance(point), expected, 1e-6);
    }
}

TEST(RevolutionEnvelope, HoldsEveryPointOfTheMeshWithinAMicrometre) {
    const TriangleMesh bur = test::sphere(Vec3(0, 0, 0.5), 0.5, 24, 16);
    const auto envelope = RevolutionEnvelope::make(bur);
    ASSERT_TRUE(envelope);
    for (std::size_t t = 0; t < bur.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 from = bur.corner(t, corner);
            const Vec3 to = bur.corner(t, (corner + 1) % 3);
            for (int i = 0; i <= 10; ++i) EXPECT_LE(envelope->signedDistance(from + 0.1 * i * (to - from)), 1e-9);
        }
        for (int corner = 0; corner < 3; ++corner) EXPECT_GE(envelope->signedDistance(bur.corner(t, corner)), -0.001);
    }
}

TEST(RevolutionEnvelope, TurningTheMeshAboutTheAxisDoesNotChangeTheDistance) {
    const TriangleMesh box = test::box(Vec3(-0.3, -0.3, 0), Vec3(0.3, 0.3, 2));
    const auto straight = RevolutionEnvelope::make(box);
    const Pose turn{Vec3::Zero(), Quat(Eigen::AngleAxisd(0.7, Vec3::UnitZ()))};
    const auto turned = RevolutionEnvelope::make(transformed(box, turn));
    ASSERT_TRUE(straight && turned);
    EXPECT_NEAR(straight->maxRadius(), 0.3 * std::sqrt(2.0), 1e-6);
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 point = randomPoint(random, 1, -0.5, 2.5);
        ASSERT_NEAR(straight->signedDistance(point), turned->signedDistance(point), 1e-6);
    }
}

TEST(RevolutionEnvelope, AFlatShoulderStaysFlat) {
    TriangleMesh stepped = test::cylinder(Vec3::Zero(), 0.4, 1, 64);
    append(stepped, test::cylinder(Vec3(0, 0, 1), 0.8, 1, 64));
    const auto envelope = RevolutionEnvelope::make(stepped);
    ASSERT_TRUE(envelope);
    EXPECT_NEAR(envelope->signedDistance(Vec3(0.6, 0, 0.9)), 0.1, 1e-6);
    EXPECT_NEAR(envelope->signedDistance(Vec3(0.6, 0, 1.1)), -0.1, 1e-6);
    EXPECT_NEAR(envelope->signedDistance(Vec3(0.5, 0, 0.5)), 0.1, 1e-6);
}

TEST(RevolutionEnvelope, GradientIsTheSlopeOfTheDistance) {
    const auto envelope = RevolutionEnvelope::make(test::sphere(Vec3(0, 0, 0.7), 0.7, 64, 40));
    ASSERT_TRUE(envelope);
    std::mt19937 random(4);
    constexpr double kStep = 1e-6;
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 point = randomPoint(random, 1.2, -0.5, 2);
        const FieldSample sample = envelope->sample(point);
        EXPECT_NEAR(sample.gradient.norm(), 1, 1e-9);
        const Vec3 ahead = point + kStep * sample.gradient;
        const double slope = (envelope->signedDistance(ahead) - sample.distance) / kStep;
        compared += std::abs(slope - 1) < 1e-3;
    }
    EXPECT_GE(compared, 1900);  // the others are at the inner ridge, where the nearest facet changes
}

TEST(RevolutionEnvelope, FarPointsTestTheWholeProfile) {
    const auto envelope = RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.5, 2, 48));
    ASSERT_TRUE(envelope);
    EXPECT_NEAR(envelope->signedDistance(Vec3(0, 0, -30)), 30, 1e-9);
    EXPECT_NEAR(envelope->signedDistance(Vec3(40.5, 0, 1)), 40, 1e-6);
}

TEST(RevolutionEnvelope, AFlatMeshIsRefused) {
    TriangleMesh flat;
    flat.vertices = {Vec3f(0, 0, 1), Vec3f(1, 0, 1), Vec3f(0, 1, 1)};
    flat.triangles = {{0, 1, 2}};
    const auto envelope = RevolutionEnvelope::make(flat);
    ASSERT_FALSE(envelope);
    EXPECT_NE(envelope.error().message().find("along its axis"), std::string::npos);
}

// A facet that rotates about an axis beside it makes a hollow band. It is less than half a micrometre deep and is
// bridged.
TEST(RevolutionEnvelope, TheShallowDentsOfAFacetedBallAreBridged) {
    const auto ball = RevolutionEnvelope::make(test::sphere(Vec3(0, 0, 0.5), 0.5, 24, 12));
    ASSERT_TRUE(ball);
    const auto& profile = ball->profile();
    EXPECT_LE(profile.size(), 13U) << "rings of vertices";
    for (std::size_t i = 1; i + 1 < profile.size(); ++i) {
        const double dr = profile[i].radius - profile[i - 1].radius;
        const double dz = profile[i].z - profile[i - 1].z;
        EXPECT_GE(dr * (profile[i + 1].z - profile[i].z), dz * (profile[i + 1].radius - profile[i].radius)) << i;
    }
    ProfilePart part;
    ASSERT_TRUE(ball->findPart(Vec3(0.5, 0, 0.5), 0, 0.2, part));
    EXPECT_TRUE(part.bulges);
}

TEST(RevolutionEnvelope, AWaistIsNoShallowDent) {
    TriangleMesh balls = test::sphere(Vec3(0, 0, 0.4), 0.4, 48, 16);
    const TriangleMesh upper = test::sphere(Vec3(0, 0, 1), 0.4, 48, 16);
    append(balls, upper);
    const auto envelope = RevolutionEnvelope::make(balls);
    ASSERT_TRUE(envelope);
    const Vec3 waist(std::sqrt(0.4 * 0.4 - 0.3 * 0.3), 0, 0.7);
    EXPECT_NEAR(envelope->signedDistance(waist), 0, 0.005);
    ProfilePart part;
    ASSERT_TRUE(envelope->findPart(waist, envelope->signedDistance(waist), 0.1, part));
    EXPECT_FALSE(part.bulges);
}

TEST(RevolutionEnvelopeAsserts, PointsAreFiniteAndAReachIsNotNegative) {
    const RevolutionEnvelope bur = *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), 0.5, 4, 32));
    EXPECT_ASSERT(static_cast<void>(bur.sample(Vec3(std::nan(""), 0, 0))));
    EXPECT_ASSERT(static_cast<void>(bur.signedDistance(Vec3(0, 0, std::nan("")))));
    ProfilePart part;
    EXPECT_ASSERT(static_cast<void>(bur.findPart(Vec3::Zero(), 0, -1, part)));
}

TEST(RevolutionEnvelope, KeepsItsInvariantsForEachShape) {
    for (const TriangleMesh& mesh : {test::cylinder(Vec3::Zero(), 0.5, 4, 32), test::sphere(Vec3(0, 0, 1), 1, 48, 24),
                                     test::box(Vec3(-1, -1, 0), Vec3(1, 1, 3))}) {
        RevolutionEnvelope::make(mesh).value().validate();
    }
}

}  // namespace
}  // namespace tactooth
