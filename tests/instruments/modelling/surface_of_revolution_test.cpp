// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/modelling/surface_of_revolution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "instruments/mesh_checks.h"
#include "support/mesh_checks.h"

namespace tactooth {
namespace {

TEST(SurfaceOfRevolution, TurnsACylinderOfTheVolumeOfItsPrism) {
    constexpr OutlinePoint kOutline[] = {{0, 0}, {2, 0}, {2, 3}, {0, 3}};
    const TriangleMesh body = revolved(kOutline, 24);
    EXPECT_EQ(test::unpairedEdges(body), 0);
    const double prism = 0.5 * 24 * 4 * std::sin(2 * std::numbers::pi / 24) * 3;
    EXPECT_NEAR(test::volumeOf(body), prism, 1e-5);
}

TEST(SurfaceOfRevolution, TurnsARecess) {
    constexpr OutlinePoint kOutline[] = {{0, 0}, {2, 0}, {2, 3}, {1, 3}, {1, 2}, {0, 2}};
    const TriangleMesh body = revolved(kOutline, 12);
    EXPECT_EQ(test::unpairedEdges(body), 0);
    EXPECT_FALSE(test::selfIntersects(body));
    EXPECT_LT(test::windingNumber(body, Vec3(0, 0, 2.5)), 0.5);
    EXPECT_GT(test::windingNumber(body, Vec3(0, 0, 1.5)), 0.5);
}

}  // namespace
}  // namespace tactooth
