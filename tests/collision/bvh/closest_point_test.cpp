// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/closest_point.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "collision/narrow/triangle_point.h"
#include "support/expect_assert.h"
#include "support/sanitizer.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

Vec3 randomPoint(std::mt19937& random, double reach) {
    std::uniform_real_distribution<double> coordinate(-reach, reach);
    const double x = coordinate(random);
    const double y = coordinate(random);
    return {x, y, coordinate(random)};
}

double bruteForceDistance(const TriangleMesh& mesh, const Vec3& query) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 point = closestOnTriangle(query, mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2));
        best = std::min(best, (point - query).norm());
    }
    return best;
}

}  // namespace

TEST(ClosestPoint, AgreesWithBruteForce) {
    const SurfacePart part(test::sphere(Vec3(0.5, -0.25, 1), 2, 60, 40));
    std::mt19937 random(7);
    for (int i = 0; i < test::cases(2000, 200); ++i) {
        const Vec3 query = randomPoint(random, 4);
        const auto closest = closestPoint(part, query);
        ASSERT_TRUE(closest.has_value());
        ASSERT_NEAR(closest->distance, bruteForceDistance(part.mesh(), query), 1e-12);
        ASSERT_NEAR((closest->point - query).norm(), closest->distance, 1e-15);
    }
}

TEST(ClosestPoint, FindsNothingBeyondItsLimit) {
    const SurfacePart part(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
    EXPECT_FALSE(closestPoint(part, Vec3(3, 0.5, 0.5), 1.9).has_value());
    EXPECT_DOUBLE_EQ(closestPoint(part, Vec3(3, 0.5, 0.5), 2.1)->distance, 2.0);
}

TEST(ClosestPoint, OnANeedleTriangleIsOnItsLongEdge) {
    const Vec3 point = closestOnTriangle(Vec3(0.5, 1, 0), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0, 0));
    EXPECT_EQ(point, Vec3(0.5, 0, 0));
}

TEST(Contains, AgreesWithTheClosedFormOfABoxForPointsThatHitEdgesToo) {
    const SurfacePart part(test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
    int inside = 0;
    for (int x = -6; x <= 6; ++x) {
        for (int y = -6; y <= 6; ++y) {
            for (int z = -6; z <= 6; ++z) {
                const Vec3 query = Vec3(x, y, z) * 0.249;
                const bool expected = query.cwiseAbs().maxCoeff() < 1;
                ASSERT_EQ(contains(part, query), expected) << query.transpose();
                inside += expected ? 1 : 0;
            }
        }
    }
    EXPECT_EQ(inside, 9 * 9 * 9);
}

TEST(Contains, AgreesWithTheRadiusForRandomPoints) {
    const SurfacePart part(test::sphere(Vec3::Zero(), 1, 200, 200));
    std::mt19937 random(11);
    int inside = 0;
    for (int i = 0; i < 10000; ++i) {
        const Vec3 query = randomPoint(random, 1.2);
        if (std::abs(query.norm() - 1) < 1e-3) continue;  // between the sphere and its facets
        ASSERT_EQ(contains(part, query), query.norm() < 1);
        inside += query.norm() < 1 ? 1 : 0;
    }
    EXPECT_GT(inside, 2500);  // the ball fills 30 % of the box
    EXPECT_LT(inside, 3500);
}

TEST(SignedDistance, IsNegativeInside) {
    const SurfacePart part(test::box(Vec3(0, 0, 0), Vec3(2, 2, 2)));
    EXPECT_DOUBLE_EQ(signedDistance(part, Vec3(1, 1, 0.25)), -0.25);
    EXPECT_DOUBLE_EQ(signedDistance(part, Vec3(1, 1, -0.25)), 0.25);
}

TEST(ClosestPoint, AssertsThatThePointIsFiniteAndTheReachNotNegative) {
    const SurfacePart part(test::box(Vec3(0, 0, 0), Vec3(2, 2, 2)));
    EXPECT_ASSERT((void)closestPoint(part, Vec3(0, 0, std::numeric_limits<double>::quiet_NaN())));
    EXPECT_ASSERT((void)closestPoint(part, Vec3(0, 0, 0), -1));
    EXPECT_ASSERT((void)signedDistance(SurfacePart(TriangleMesh{}), Vec3(0, 0, 0)));
}

}  // namespace tactooth
