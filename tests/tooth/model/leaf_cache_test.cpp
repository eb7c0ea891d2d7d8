// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/leaf_cache.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(LeafCache, FindTheSamePointAsATraversalOfTheTree) {
    const SurfacePart ball(test::sphere(Vec3(0.1, -0.2, 0.3), 1, 96, 48));
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto direction = [&] { return Vec3(unit(random), unit(random), unit(random)); };
    int found = 0;
    for (int place = 0; place < 60; ++place) {
        const Vec3 centre = Vec3(0.1, -0.2, 0.3) + 1.1 * direction();
        constexpr double kReach = 0.3;
        const LeafCache near(ball, centre, kReach);
        for (int i = 0; i < 40; ++i) {
            const double within = 0.1 + 0.1 * std::abs(unit(random));
            const Vec3 query = centre + (kReach - within) / std::sqrt(3.0) * direction();
            const auto expected = closestPoint(ball, query, within);
            const auto point = near.closest(query, within);
            ASSERT_EQ(point.has_value(), expected.has_value());
            if (!point) continue;
            ++found;
            EXPECT_EQ(point->point, expected->point);
            EXPECT_EQ(point->distance, expected->distance);
            EXPECT_EQ(point->triangle, expected->triangle);
        }
    }
    EXPECT_GT(found, 300);
}

TEST(LeafCache, AreNoneFarFromTheSurface) {
    const SurfacePart box(test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1)));
    EXPECT_TRUE(LeafCache(box, Vec3(0, 0, 3), 1.5).empty());
    EXPECT_TRUE(LeafCache(SurfacePart(TriangleMesh{}), Vec3::Zero(), 1).empty());
    EXPECT_FALSE(LeafCache(box, Vec3(0, 0, 3), 2.5).empty());
}

TEST(LeafCacheAsserts, PointsAndDistancesAreNumbers) {
    const SurfacePart ball(test::sphere(Vec3::Zero(), 1, 16, 8));
    EXPECT_ASSERT(LeafCache(ball, Vec3::Constant(std::nan("")), 1));
    EXPECT_ASSERT(LeafCache(ball, Vec3::Zero(), -1));
    EXPECT_ASSERT(static_cast<void>(LeafCache(ball, Vec3::Zero(), 2).closest(Vec3::Zero(), -1)));
}

}  // namespace
}  // namespace tactooth
