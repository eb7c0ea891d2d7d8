// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/outline/flat_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tactooth {
namespace {

using Point = FlatOutline::Point;

/// A star around (1, 2): `corners` corners at random distances from it, 3 to 6 mm.
std::vector<Vec3> star(std::mt19937& random, int corners) {
    std::uniform_real_distribution<double> radius(3, 6), height(-2, 2);
    std::vector<Vec3> places;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        const double r = radius(random);
        places.emplace_back(1 + r * std::cos(angle), 2 + r * std::sin(angle), height(random));
    }
    return places;
}

TEST(FlatOutline, ContainsWhatItGoesAround) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> at(-6, 8);
    int inside = 0;
    for (int i = 0; i < 500; ++i) {
        const FlatOutline outline(star(random, 9), Vec3::UnitZ());
        const Point point = outline.flat(Vec3(at(random), at(random), 5));
        double turned = 0;  // the sum of the angles under which the edges are seen
        for (std::size_t k = 0; k < outline.corners().size(); ++k) {
            const Point a = outline.corners()[k] - point;
            const Point b = outline.corners()[(k + 1) % outline.corners().size()] - point;
            turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        }
        EXPECT_EQ(outline.contains(point), std::abs(turned) > std::numbers::pi);
        inside += outline.contains(point) ? 1 : 0;
    }
    EXPECT_GT(inside, 100);
    EXPECT_LT(inside, 400);
}

TEST(FlatOutline, IsSeenAlongItsDirection) {
    const std::vector<Vec3> corners = {{0, 3, 0}, {2, 4, 0}, {2, 5, 3}, {0, 3, 3}};  // 2 x 3 mm from the cheek
    const FlatOutline outline(corners, Vec3::UnitY());
    EXPECT_NEAR(std::abs(outline.signedArea()), 6, 1e-12);
    EXPECT_NEAR((outline.placeAt(outline.flat(corners[1]), 4) - corners[1]).norm(), 0, 1e-12);
    EXPECT_TRUE(outline.contains(outline.flat(Vec3(1, 9, 1))));
    EXPECT_NEAR(outline.distance(outline.flat(Vec3(1, 9, 1))), 1, 1e-12);
}

TEST(FlatOutline, NoticesThatItCrossesItself) {
    const auto crosses = [](std::vector<Vec3> corners) { return FlatOutline(corners, Vec3::UnitZ()).crossesItself(); };
    EXPECT_FALSE(crosses({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_TRUE(crosses({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_TRUE(crosses({{0, 0, 0}, {1, 0, 0}}));
    EXPECT_TRUE(crosses({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}));             // there and back again
    EXPECT_TRUE(crosses({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0, 0}, {0, 2, 0}}));  // a corner on an edge
    EXPECT_TRUE(crosses({{0, 0, 0}, {0, 0, 5}, {1, 1, 0}}));                        // two corners that look the same
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        std::vector<Vec3> corners = star(random, 8);
        EXPECT_FALSE(crosses(corners));
        std::swap(corners[2], corners[6]);
        EXPECT_TRUE(crosses(corners));
    }
}

TEST(FlatOutline, HasRoomForTheBurThatFitsInside) {
    const std::vector<Vec3> corners = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}};
    const FlatOutline outline(corners, Vec3::UnitZ());
    EXPECT_TRUE(outline.hasRoomFor(0.4));
    EXPECT_FALSE(outline.hasRoomFor(0.6));
}

TEST(FlatOutline, TakesANewCornerIntoTheEdgeBesideIt) {
    const std::vector<Vec3> corners = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    const FlatOutline outline(corners, Vec3::UnitZ());
    EXPECT_EQ(outline.edgeFor(outline.flat(Vec3(2, -0.5, 0))), 0U);
    EXPECT_EQ(outline.edgeFor(outline.flat(Vec3(4.5, 1, 0))), 1U);
    EXPECT_EQ(outline.edgeFor(outline.flat(Vec3(-1, 3, 0))), 3U);
}

}  // namespace
}  // namespace tactooth
