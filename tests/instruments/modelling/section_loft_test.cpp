// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/modelling/section_loft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tactooth {
namespace {

TEST(SectionLoft, EqualCirclesMakeACylinderWithItsExactDistance) {
    constexpr Section kCylinder[] = {circle(0, 2, 0.5, -1), circle(5, 2, 0.5, -1)};
    const SectionLoft loft(kCylinder);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(-6, 6);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p(coordinate(random), coordinate(random), coordinate(random));
        EXPECT_NEAR(loft(p), std::hypot(p.x() - 0.5, p.y() + 1) - 2, 1e-12);
    }
}

TEST(SectionLoft, ReachesEachHalfAxisOfASection) {
    const std::vector<Section> sections = {{0, 1, 2, 3, 4, 2.5, 0.2, -0.3}, {1, 1.5, 2.5, 3.5, 4.5, 2.5, 0.2, -0.3}};
    const SectionLoft loft(sections);
    EXPECT_NEAR(loft(Vec3(0.2 + 1, -0.3, 0)), 0, 1e-12);
    EXPECT_NEAR(loft(Vec3(0.2 - 2, -0.3, 0)), 0, 1e-12);
    EXPECT_NEAR(loft(Vec3(0.2, -0.3 + 3, 0)), 0, 1e-12);
    EXPECT_NEAR(loft(Vec3(0.2, -0.3 - 4, 0)), 0, 1e-12);
}

TEST(SectionLoft, EstimateNearTheSurfaceOfAConeIsItsDistance) {
    constexpr Section kCone[] = {circle(0, 1), circle(5, 6), circle(10, 11)};  // 45 degrees
    const SectionLoft loft(kCone);
    for (const double away : {-0.05, 0.02, 0.05}) {
        const Vec3 onSurface(6, 0, 5), normal = Vec3(1, 0, -1).normalized();
        EXPECT_NEAR(loft(onSurface + away * normal), away, 0.02 * std::abs(away));
    }
}

TEST(SectionLoft, FarPointsStayFarBesideAThinEnd) {
    constexpr Section kPoint[] = {circle(0, 0.2), circle(0.2, 0.8), circle(2, 2)};  // 72 degrees at the end
    const SectionLoft loft(kPoint);
    for (double z = -0.5; z < 1; z += 0.05) EXPECT_GT(loft(Vec3(5, 0, z)), 1.0) << z;
}

TEST(SectionLoft, NeverOvershootsItsSections) {
    constexpr Section kSteps[] = {circle(0, 1), circle(1, 1), circle(2, 3), circle(3, 3)};
    const SectionLoft loft(kSteps);
    for (double z = -1; z <= 4; z += 0.01) {
        EXPECT_GE(loft.at(z).plusX, 1.0);
        EXPECT_LE(loft.at(z).plusX, 3.0);
    }
    EXPECT_DOUBLE_EQ(loft.at(2).plusX, 3.0);
}

}  // namespace
}  // namespace tactooth
