// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/distance_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "collision/bvh/closest_point.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(DistanceGrid, HoldsTheDistancesToABall) {
    const SurfacePart ball(test::sphere(Vec3(1, 2, 3), 2, 200, 100));
    const DistanceGrid grid = sampleDistances(ball, Box3(Vec3(-2, -1, 0), Vec3(4, 5, 5)), 13);
    EXPECT_EQ(grid.counts.x(), 13);
    EXPECT_EQ(grid.counts.z(), 11);
    std::size_t place = 0;
    for (int z = 0; z < grid.counts.z(); ++z) {
        for (int y = 0; y < grid.counts.y(); ++y) {
            for (int x = 0; x < grid.counts.x(); ++x, ++place) {
                const Vec3 point = grid.low + grid.spacing * Vec3(x, y, z);
                EXPECT_NEAR(grid.values[place], (point - Vec3(1, 2, 3)).norm() - 2, 2e-3);
            }
        }
    }
}

/// Thin walls that lie between two samples, and gaps beside them: each sample has the distance of its own point.
TEST(DistanceGrid, HoldsWhatEachPointWouldGive) {
    TriangleMesh walls = test::box(Vec3(0, 0, 0), Vec3(0.1, 4, 4));
    append(walls, test::box(Vec3(0.35, 0.5, 0), Vec3(0.5, 3, 2)));
    append(walls, test::box(Vec3(3, 1, 1), Vec3(5, 3, 3)));
    const SurfacePart target(std::move(walls));
    const DistanceGrid grid = sampleDistances(target, Box3(Vec3(-2, -1, -0.5), Vec3(6, 4.3, 4.7)), 30);
    std::size_t place = 0, inside = 0;
    for (int z = 0; z < grid.counts.z(); ++z) {
        for (int y = 0; y < grid.counts.y(); ++y) {
            for (int x = 0; x < grid.counts.x(); ++x, ++place) {
                const double distance = signedDistance(target, grid.low + grid.spacing * Vec3(x, y, z));
                inside += distance < 0 ? 1 : 0;
                ASSERT_EQ(grid.values[place], static_cast<float>(distance)) << x << ' ' << y << ' ' << z;
            }
        }
    }
    EXPECT_GT(inside, 100U);
}

/// A linear field is kept exactly, with its gradient.
TEST(DistanceGrid, IsLinearBetweenItsSamples) {
    const Vec3 slope(0.3, -0.5, 0.7);
    DistanceGrid grid{.low = Vec3(-1, 2, 0.5), .spacing = 0.25, .counts = {4, 5, 6}, .values = {}};
    for (int z = 0; z < 6; ++z) {
        for (int y = 0; y < 5; ++y) {
            for (int x = 0; x < 4; ++x)
                grid.values.push_back(static_cast<float>(1 + slope.dot(grid.low + grid.spacing * Vec3(x, y, z))));
        }
    }
    for (const Vec3& place : {Vec3(-0.9, 2.1, 0.6), Vec3(-0.3, 2.95, 1.7), Vec3(-1, 2, 0.5)}) {
        const auto sample = grid.at(place);
        ASSERT_TRUE(sample);
        EXPECT_NEAR(sample->distance, 1 + slope.dot(place), 1e-6);
        EXPECT_LT((sample->gradient - slope).norm(), 1e-5);
    }
    EXPECT_FALSE(grid.at(Vec3(-1.01, 2.1, 0.6)));
    EXPECT_FALSE(grid.at(Vec3(-0.9, 3.01, 0.6)));
    EXPECT_FALSE(grid.at(Vec3(-0.9, 2.1, std::numeric_limits<double>::quiet_NaN())));
    EXPECT_FALSE(grid.at(Vec3(1e300, 2.1, 0.6)));
}

}  // namespace
}  // namespace tactooth
