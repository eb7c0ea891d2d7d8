// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/distance_grid.h"

#include <gtest/gtest.h>

#include "collision/bvh/closest_point.h"
#include "support/shapes.h"
#include "view/scene/appearance.h"

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

/// The colour that a colour-blind eye sees, in linear light: the plane of colours that protanopes and deuteranopes
/// confuse. F. Vienot, H. Brettel, J. Mollon, Digital video colourmaps for checking the legibility of displays by
/// dichromats, Color Research and Application 24(4), 1999.
Vec3f seenBy(const Vec3f& srgb, bool protanope) {
    const Vec3f c = linearColour(srgb);
    const float red = protanope ? 0.11238F * c.x() + 0.88762F * c.y() : 0.29275F * c.x() + 0.70725F * c.y();
    const float blue = protanope ? 0.00401F * (c.x() - c.y()) + c.z() : -0.02234F * (c.x() - c.y()) + c.z();
    return {red, red, blue};
}

TEST(DistanceColour, TooDeepAndStillToCutDifferForColourBlindEyes) {
    for (const bool protanope : {true, false}) {
        for (double share = 0.25; share <= 1; share += 0.25) {
            const Vec3f deep = seenBy(distanceColour(-share), protanope);
            const Vec3f left = seenBy(distanceColour(share), protanope);
            // The share of blue in the light distinguishes the sides, whatever their lightness.
            EXPECT_LT(deep.z() / deep.x(), 0.75F * left.z() / left.x()) << share;
        }
    }
}

TEST(DistanceScale, RunsEvenlyWithoutATolerance) {
    const DistanceScale scale{0.5};
    EXPECT_DOUBLE_EQ(scale.shareOf(0.25), 0.5);
    EXPECT_DOUBLE_EQ(scale.shareOf(-0.125), -0.25);
    EXPECT_DOUBLE_EQ(scale.shareOf(7), 1);
}

TEST(DistanceScale, HasAnEdgeAtTheTolerance) {
    const DistanceScale scale{0.5, 0.1};
    for (const double within : {0.0, 0.05, -0.05, 0.1, -0.1}) EXPECT_EQ(scale.shareOf(within), 0);
    EXPECT_NEAR(scale.shareOf(0.1 + 1e-9), kToleranceStep, 1e-6);
    EXPECT_NEAR(scale.shareOf(-0.1 - 1e-9), -kToleranceStep, 1e-6);
    EXPECT_NEAR(scale.shareOf(0.3), (1 + kToleranceStep) / 2, 1e-12);
    EXPECT_DOUBLE_EQ(scale.shareOf(-0.5), -1);
    EXPECT_DOUBLE_EQ(scale.shareOf(-3), -1);
}

TEST(DistanceColour, GetsDarkerToBothEnds) {
    const auto lightness = [](double share) {
        const Vec3f c = linearColour(distanceColour(share));
        return 0.2126F * c.x() + 0.7152F * c.y() + 0.0722F * c.z();
    };
    for (double share = 0; share < 0.99; share += 0.05) {
        EXPECT_GT(lightness(share), lightness(share + 0.05));
        EXPECT_GT(lightness(-share), lightness(-share - 0.05));
    }
    EXPECT_EQ(distanceColour(-7), distanceColour(-1));
}

}  // namespace
}  // namespace tactooth
