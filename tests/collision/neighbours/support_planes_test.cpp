// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/neighbours/support_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/util/pose.h"
#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

/// Rounding error of single precision for lengths of a few millimetres.
constexpr float kRounding = 1e-5F;

float lowestAlong(const TriangleMesh& mesh, const Vec3f& direction) {
    float lowest = direction.dot(mesh.vertices[0]);
    for (const Vec3f& vertex : mesh.vertices) lowest = std::min(lowest, direction.dot(vertex));
    return lowest;
}

Vec3 randomUnit(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double x = normal(random);
    const double y = normal(random);
    return Vec3(x, y, normal(random)).normalized();
}

TriangleMesh rotated(TriangleMesh mesh, const Vec3& axis, double chord) {
    const Mat3 rotation = Eigen::AngleAxisd(2 * std::asin(chord / 2), axis).toRotationMatrix();
    for (Vec3f& vertex : mesh.vertices) vertex = (rotation * vertex.cast<double>()).cast<float>();
    return mesh;
}

/// A ball on its pole, two boxes, and a mesh with more faces than there can be planes.
std::vector<TriangleMesh> tools() {
    return {test::sphere(Vec3(0, 0, 0.6), 0.6, 16, 10), test::box(Vec3(-0.1, -0.4, 0), Vec3(0.2, 0.4, 3)),
            test::box(Vec3(1, 1, 1), Vec3(2, 3, 4)), test::sphere(Vec3(0.3, 0, 2), 1.5, 100, 50)};
}

}  // namespace

TEST(SupportPlanes, EachGivesHowFarTheToolReaches) {
    for (const TriangleMesh& mesh : tools()) {
        const SupportPlanes planes(mesh);
        ASSERT_GT(planes.size(), 100U);
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const SupportPlanes::Plane& plane = planes[static_cast<SupportPlanes::Number>(i)];
            EXPECT_NEAR(plane.inward.norm(), 1, 1e-6);
            EXPECT_NEAR(plane.low, lowestAlong(mesh, plane.inward), kRounding);
        }
    }
}

TEST(SupportPlanes, ThereIsOneInEveryDirection) {
    std::mt19937 random(3);
    for (const TriangleMesh& mesh : tools()) {
        const SupportPlanes planes(mesh);
        for (int i = 0; i < 500; ++i) {
            const Vec3f direction = randomUnit(random).cast<float>();
            float nearest = -1;
            for (std::size_t k = 0; k < planes.size(); ++k)
                nearest = std::max(nearest, direction.dot(planes[static_cast<SupportPlanes::Number>(k)].inward));
            EXPECT_GT(nearest, std::cos(0.3)) << "17 degrees";
        }
    }
}

TEST(SupportPlanes, ARotationMovesTheToolNoFurtherThanTheLoss) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const TriangleMesh& mesh : tools()) {
        const SupportPlanes planes(mesh);
        for (int i = 0; i < 200; ++i) {
            const double most = std::pow(10, -3 * unit(random));
            const double chord = most * unit(random);
            const TriangleMesh moved = rotated(mesh, randomUnit(random), chord);
            const std::span<const float> losses = planes.losses(most);
            for (std::size_t k = 0; k < planes.size(); ++k) {
                const SupportPlanes::Plane& plane = planes[static_cast<SupportPlanes::Number>(k)];
                EXPECT_GE(lowestAlong(moved, plane.inward) + kRounding,
                          plane.low - losses[k] * static_cast<float>(chord));
            }
            const Vec3f direction = randomUnit(random).cast<float>();
            const SupportPlanes::Reach reach = planes.across(direction, static_cast<float>(most));
            EXPECT_NEAR(reach.plane.low, lowestAlong(mesh, direction), kRounding);
            EXPECT_GE(lowestAlong(moved, direction) + kRounding,
                      reach.plane.low - reach.loss * static_cast<float>(chord));
        }
    }
}

TEST(SupportPlanes, TheNeighboursOfAPlaneHaveSimilarDirections) {
    const SupportPlanes planes(test::sphere(Vec3::Zero(), 1, 16, 10));
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const auto number = static_cast<SupportPlanes::Number>(i);
        EXPECT_EQ(planes.similarTo(number)[0], number);
        for (const SupportPlanes::Number other : planes.similarTo(number))
            EXPECT_GT(planes[number].inward.dot(planes[other].inward), 0.5F);
    }
}

TEST(SupportPlanes, ThePlaneThatFacesAPointIsTheOneItIsFurthestBeyond) {
    const TriangleMesh mesh = test::box(Vec3(-1, -1, 0), Vec3(1, 1, 3));
    const SupportPlanes planes(mesh);
    EXPECT_GT(planes[planes.facing(Vec3f(0, 0, -1))].inward.z(), 0.99F);
    EXPECT_LT(planes[planes.facing(Vec3f(2, 0, 1))].inward.x(), -0.99F);
}

TEST(SupportPlanes, AssertThatDirectionsAreUnitAndChordsInRange) {
    const SupportPlanes planes(tools()[0]);
    EXPECT_ASSERT((void)planes.across(Vec3f(0, 0, 2), 0.1F));
    EXPECT_ASSERT((void)planes.losses(-0.1));
    EXPECT_ASSERT((void)planes[static_cast<SupportPlanes::Number>(planes.size())]);
    EXPECT_ASSERT((void)SupportPlanes(TriangleMesh{}).facing(Vec3f::Zero()));
}

}  // namespace tactooth
