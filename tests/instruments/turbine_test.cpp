// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/turbine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "collision/bvh/closest_point.h"
#include "instruments/bur_shape.h"
#include "instruments/mesh_checks.h"
#include "support/mesh_checks.h"

namespace tactooth {
namespace {

const TriangleMesh& turbine() {
    static const TriangleMesh mesh = makeTurbine();
    return mesh;
}

TEST(Turbine, IsOneClosedBodyThatDoesNotIntersectItself) {
    EXPECT_EQ(test::unpairedEdges(turbine()), 0);
    EXPECT_GT(test::volumeOf(turbine()), 1000);
    EXPECT_FALSE(test::selfIntersects(turbine()));
    EXPECT_EQ(static_cast<int>(turbine().vertices.size()) - static_cast<int>(turbine().triangles.size() / 2), 2);
}

TEST(Turbine, HasAsManyTrianglesAsAskedFor) {
    EXPECT_NEAR(static_cast<double>(turbine().triangles.size()), 16000, 10);
    const TriangleMesh coarse = makeTurbine(6000);
    EXPECT_NEAR(static_cast<double>(coarse.triangles.size()), 6000, 10);
    EXPECT_EQ(test::unpairedEdges(coarse), 0);
}

TEST(Turbine, HeadHasTheSizeOfARealOneAndLetsTheBurProtrude) {
    double radius = 0, top = 0;
    for (const Vec3f& v : turbine().vertices) {
        if (v.x() > 0) continue;  // the half away from the handle
        radius = std::max(radius, static_cast<double>(std::hypot(v.x(), v.y())));
        top = std::max(top, static_cast<double>(v.z()));
    }
    const double bottom = boundingBox(turbine()).min().z();
    EXPECT_GE(2 * radius, 10);
    EXPECT_LE(2 * radius, 11);
    EXPECT_GE(top - bottom, 12);
    EXPECT_LE(top - bottom, 13.5);
    EXPECT_GE(bottom, 8);
    EXPECT_LE(bottom, 10);
}

/// Also around the groove below the push button, where a coarse grid makes a jagged edge.
TEST(Turbine, HeadIsAsRoundAsIfTurned) {
    const SurfacePart head(turbine());
    constexpr int kDirections = 48;
    for (double z = 10.5; z < 22; z += 0.1) {
        double least = 1e9, most = -1e9;
        for (int i = 0; i < kDirections; ++i) {  // away from the handle and its fillet
            const double angle = std::numbers::pi * (0.7 + 0.6 * (i + 0.5) / kDirections);
            const double outside = signedDistance(head, Vec3(5 * std::cos(angle), 5 * std::sin(angle), z));
            least = std::min(least, outside);
            most = std::max(most, outside);
        }
        EXPECT_LT(most - least, 0.07) << "at " << z << " mm";
    }
}

TEST(Turbine, HoldsEveryBurByItsShank) {
    for (const BurSpec& spec : burCatalogue()) {
        const double end = boundingBox(makeBur(spec).surface).max().z();
        EXPECT_GT(test::windingNumber(turbine(), Vec3(0, 0, end)), 0.5) << spec.number;
    }
}

TEST(Turbine, HandleLeavesTowardXAndRises) {
    const Box3 box = boundingBox(turbine());
    EXPECT_GT(box.max().x(), 60);
    EXPECT_LT(box.min().x(), -5);
    EXPECT_GT(box.max().z(), 28);
}

TEST(Turbine, IsTheSameEachTime) { EXPECT_TRUE(test::areBitEqual(turbine(), makeTurbine())); }

}  // namespace
}  // namespace tactooth
