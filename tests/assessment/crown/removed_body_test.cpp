// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/removed_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/util/degree.h"

namespace tactooth {
namespace {

/// What lies over the plane through the origin with this normal.
RemovedBody::Depth over(const Vec3& normal, const Vec3& place) { return {normal.dot(place), normal}; }

TEST(UnitedRound, RoundsTheEdgeOfTwoPlanesAsACylinder) {
    constexpr double kWanted = 0.3;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> inBox(-1, 1);
    int round = 0, flat = 0;
    for (const double between : {40.0, 90.0, 130.0}) {  // of the normals: the edge is sharper, the larger it is
        const double half = between / 2 * kDegree;
        const double radius = kWanted * std::min(1.0, 1 + std::cos(between * kDegree));
        const Vec3 a(std::sin(half), 0, std::cos(half)), b(-std::sin(half), 0, std::cos(half));
        const Vec3 centre(0, 0, -radius / std::cos(half));  // of the cylinder that touches both planes
        for (int i = 0; i < 2000; ++i) {
            const Vec3 place(inBox(random), inBox(random), inBox(random));
            const RemovedBody::Depth found = unitedRound(over(a, place), over(b, place), kWanted);
            Vec3 from = place - centre;
            from.y() = 0;
            const double sideways = std::abs(std::atan2(from.x(), from.z()));
            if (sideways < half) {
                ++round;
                EXPECT_NEAR(found.value, from.norm() - radius, 1e-9);
                EXPECT_NEAR((found.gradient - from.normalized()).norm(), 0, 1e-9);
            } else {
                ++flat;
                EXPECT_NEAR(found.value, std::max(a.dot(place), b.dot(place)), 1e-9);
            }
        }
    }
    EXPECT_GT(round, 1000);
    EXPECT_GT(flat, 1000);
}

TEST(UnitedRound, LeavesAThinBlade) {
    // Two planes 0.2 mm apart, nearly parallel.
    const Vec3 a = Vec3(1, 0, 0.05).normalized(), b = Vec3(-1, 0, 0.05).normalized();
    const Vec3 middle(0, 0, -2);
    EXPECT_NEAR(unitedRound(over(a, middle), over(b, middle), 0.3).value, a.dot(middle), 0.01);
}

TEST(UnitedRound, IsSharpWithoutARadiusAndFlatInOnePlane) {
    const Vec3 place(0.1, 0, -0.1);
    EXPECT_EQ(unitedRound(over(Vec3::UnitX(), place), over(Vec3::UnitZ(), place), 0).value, 0.1);
    EXPECT_EQ(unitedRound(over(Vec3::UnitX(), place), over(Vec3::UnitX(), place), 0.3).value, 0.1);
}

}  // namespace
}  // namespace tactooth
