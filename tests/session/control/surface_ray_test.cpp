// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/control/surface_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

Surface ball() {
    Surface surface;
    surface.base = std::make_shared<const SurfacePart>(test::sphere(Vec3(1, 2, 3), 2, 128, 64));
    return surface;
}

/// Closed form: a ray against a sphere. The faceted ball lies up to 2 * (1 - cos(pi / 64)) = 0.0024 mm inside it.
TEST(SurfaceRay, FindsTheNearSideOfABall) {
    const Surface surface = ball();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 origin = Vec3(1, 2, 3) + 9 * Vec3(uniform(random), uniform(random), uniform(random)).normalized();
        const Vec3 goal = Vec3(1, 2, 3) + 2.8 * Vec3(uniform(random), uniform(random), uniform(random));
        const Ray ray{origin, (goal - origin).normalized()};
        const double along = (Vec3(1, 2, 3) - origin).dot(ray.direction);
        const double aside = (origin + along * ray.direction - Vec3(1, 2, 3)).norm();
        if (std::abs(aside - 2) < 0.05) continue;  // grazing: facets and sphere differ
        const auto hit = firstHit(surface, ray);
        ASSERT_EQ(hit.has_value(), aside < 2) << i;
        EXPECT_EQ(meetsAny(surface, ray), aside < 2) << i;
        if (!hit) continue;
        ++hits;
        EXPECT_NEAR(*hit, along - std::sqrt(4 - aside * aside), 0.03) << i;
    }
    EXPECT_GT(hits, 600);
    EXPECT_LT(hits, 1700);
}

TEST(SurfaceRay, AnEyeInsideAClosedBodySeesThroughIt) {
    Surface surface;
    TriangleMesh mesh = test::sphere(Vec3(0, 0, 20), 5, 64, 32);
    append(mesh, test::box(Vec3(-3, -3, -3), Vec3(3, 3, 3)));
    surface.base = std::make_shared<const SurfacePart>(std::move(mesh));
    for (const double height : {18.0, 20.0, 22.0}) {
        const Ray down{Vec3(0.1, 0.2, height), -Vec3::UnitZ()};
        EXPECT_NEAR(firstHit(surface, down).value(), height - 15, 0.05);
        const SurfaceHit seen = firstSeen(surface, down).value();
        EXPECT_NEAR(seen.distance, height - 3, 1e-9);
        EXPECT_NEAR(seen.normal.z(), 1, 1e-9);
    }
    EXPECT_NEAR(firstSeen(surface, {Vec3(0.1, 0.2, 30), -Vec3::UnitZ()}).value().distance, 5, 0.05);
    surface.closed = false;  // an open surface is drawn from both sides
    EXPECT_NEAR(firstSeen(surface, {Vec3(0.1, 0.2, 20), -Vec3::UnitZ()}).value().distance, 5, 0.05);
}

TEST(SurfaceRay, LooksThroughWhatWasCutAwayAndSeesThePatches) {
    Surface surface = ball();
    const Ray down{Vec3(1.01, 2.02, 10), -Vec3::UnitZ()};
    ASSERT_NEAR(firstHit(surface, down).value(), 5, 0.01);
    surface.hidden = std::make_shared<const TriangleMask>(
        TriangleMask((surface.base->mesh().triangles.size() + 63) / 64, ~std::uint64_t{0}));
    EXPECT_FALSE(firstHit(surface, down).has_value());
    EXPECT_FALSE(meetsAny(surface, down));
    surface.patches.push_back(std::make_shared<const SurfacePart>(test::box(Vec3(0, 0, 0), Vec3(4, 4, 4))));
    EXPECT_NEAR(firstHit(surface, down).value(), 6, 1e-6);
    EXPECT_TRUE(meetsAny(surface, down));
}

TEST(SurfaceRay, WhatIsBehindIsNotHit) {
    EXPECT_FALSE(firstHit(ball(), Ray{Vec3(1, 2, 10), Vec3::UnitZ()}).has_value());
}

/// Closed form: a place inside a ball, and the way out of it.
/// Rays in the sides of the boxes of the tree, where nothing is to be divided by: all numbers here are exact.
TEST(SurfaceRay, ARayAlongTheSideOfABoxMeetsWhatIsThere) {
    constexpr int kCells = 16;
    constexpr float kPitch = 0.25F;
    TriangleMesh floor;
    for (int y = 0; y <= kCells; ++y) {
        for (int x = 0; x <= kCells; ++x) {
            floor.vertices.emplace_back(kPitch * static_cast<float>(x), kPitch * static_cast<float>(y), 0);
        }
    }
    for (int y = 0; y < kCells; ++y) {
        for (int x = 0; x < kCells; ++x) {
            const auto corner = static_cast<std::uint32_t>(y * (kCells + 1) + x);
            floor.triangles.push_back({corner, corner + 1, corner + kCells + 2});
            floor.triangles.push_back({corner, corner + kCells + 2, corner + kCells + 1});
        }
    }
    Surface surface;
    surface.base = std::make_shared<const SurfacePart>(std::move(floor));
    for (int y = 0; y <= 2 * kCells; ++y) {
        for (int x = 0; x <= 2 * kCells; ++x) {
            const Vec3 place(0.125 * x, 0.125 * y, 2);
            for (const double zero : {0.0, -0.0}) {
                EXPECT_EQ(firstHit(surface, {place, Vec3(zero, zero, -1)}), 2) << place.transpose();
            }
        }
    }
    for (const double beside : {-0.001, 4.001}) {
        EXPECT_FALSE(firstHit(surface, {Vec3(beside, 2, 2), -Vec3::UnitZ()}));
        EXPECT_FALSE(firstHit(surface, {Vec3(2, beside, 2), -Vec3::UnitZ()}));
    }
}

TEST(SurfaceRay, DepthInsideABallIsTheDistanceToItsSurface) {
    const Surface surface = ball();
    std::mt19937 random(8);
    std::uniform_real_distribution<double> uniform(-1, 1);
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 fromCentre = 3 * Vec3(uniform(random), uniform(random), uniform(random));
        const Vec3 up = Vec3(uniform(random), uniform(random), uniform(random)).normalized();
        if (std::abs(fromCentre.norm() - 2) < 0.01) continue;  // between facets and sphere
        const double depth = depthInside(*surface.base, Vec3(1, 2, 3) + fromCentre, up);
        if (fromCentre.norm() > 2) {
            EXPECT_EQ(depth, 0) << i;
            continue;
        }
        ++inside;
        const double along = -fromCentre.dot(up);
        EXPECT_NEAR(depth, along + std::sqrt(along * along + 4 - fromCentre.squaredNorm()), 0.03) << i;
    }
    EXPECT_GT(inside, 200);
}

}  // namespace
}  // namespace tactooth
