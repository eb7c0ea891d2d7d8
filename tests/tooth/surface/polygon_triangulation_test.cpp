// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/polygon_triangulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

using Points = std::vector<Vec2>;

double coveredArea(const Points& points, const std::vector<Triangle>& triangles, bool& allForward) {
    double sum = 0;
    allForward = true;
    for (const auto& [a, b, c] : triangles) {
        const double area = 0.5 * doubledArea(points, {a, b, c});
        allForward = allForward && area >= -1e-12;
        sum += area;
    }
    return sum;
}

/// Adds the points of a star-shaped ring and returns their numbers.
PolygonLoop addStar(Points& points, const Vec2& centre, double radius, int count, std::mt19937& random) {
    std::uniform_real_distribution<double> share(0.4, 1);
    PolygonLoop loop;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        loop.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(centre + radius * share(random) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return loop;
}

TEST(PolygonTriangulation, RandomStarsAreCoveredOnceByTrianglesThatFaceForward) {
    std::mt19937 random(30);
    for (int count = 3; count < 60; ++count) {
        Points points;
        const PolygonLoop star = addStar(points, {1, 2}, 3, count, random);
        const auto triangles = triangulate(points, star, {});
        bool forward = false;
        EXPECT_EQ(triangles.size(), star.size() - 2);
        EXPECT_NEAR(coveredArea(points, triangles, forward), 0.5 * doubledArea(points, star), 1e-9);
        EXPECT_TRUE(forward);
    }
}

TEST(PolygonTriangulation, ThreeCornersOnOneLineAreNeverATriangle) {
    const double tiny = 1e-15;
    for (const double bend : {-tiny, 0.0, tiny}) {
        const Points points = {{0, 0}, {0.5, bend}, {1, -bend}, {2, 0}, {2, 2}, {1, 2 + bend}, {0, 2}};
        for (std::size_t first = 0; first < points.size(); ++first) {
            PolygonLoop loop;
            for (std::size_t i = 0; i < points.size(); ++i)
                loop.push_back(static_cast<std::uint32_t>((first + i) % points.size()));
            const auto triangles = triangulate(points, loop, {});
            ASSERT_EQ(triangles.size(), 5U);
            for (const auto& [a, b, c] : triangles) EXPECT_GT(doubledArea(points, {a, b, c}), 0.1);
        }
    }
}

TEST(PolygonTriangulation, HolesAreLeftOut) {
    std::mt19937 random(31);
    Points points = {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
    std::vector<PolygonLoop> holes;
    double expected = 400;
    std::size_t corners = 4;
    for (const auto& [x, y] : {std::pair{-5, -5}, {5, -4}, {0, 0}, {-4, 5}, {5, 5}}) {
        PolygonLoop hole = addStar(points, {x, y}, 2, 17, random);
        expected -= 0.5 * doubledArea(points, hole);
        corners += hole.size() + 2;
        holes.emplace_back(hole.rbegin(), hole.rend());
    }
    const auto triangles = triangulate(points, {0, 1, 2, 3}, holes);
    bool forward = false;
    EXPECT_NEAR(coveredArea(points, triangles, forward), expected, 1e-9);
    EXPECT_TRUE(forward);
    EXPECT_EQ(triangles.size(), corners - 2);
}

TEST(PolygonTriangulation, APolygonWithoutAreaStillGetsItsTriangles) {
    const Points points = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 0}};
    EXPECT_EQ(triangulate(points, {0, 1, 2, 3, 4}, {}).size(), 3U);
}

TEST(PolygonTriangulation, APointIsWithinALoopOrNot) {
    const Points points = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
    const PolygonLoop loop = {0, 1, 2, 3, 4};
    EXPECT_TRUE(isWithin(points, loop, {0.5, 2}));
    EXPECT_FALSE(isWithin(points, loop, {2, 2}));
    EXPECT_FALSE(isWithin(points, loop, {5, 1}));
}

TEST(PolygonTriangulationAsserts, AnOutlineHasThreeCornersAndSoHasAHole) {
    const Points points = {{0, 0}, {1, 0}, {0, 1}, {0.1, 0.1}, {0.2, 0.1}};
    EXPECT_ASSERT(static_cast<void>(triangulate(points, {0, 1}, {})));
    EXPECT_ASSERT(static_cast<void>(triangulate(points, {0, 1, 2}, {{3, 4}})));
}

}  // namespace
}  // namespace tactooth
