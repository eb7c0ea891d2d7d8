// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/brick_sampler.h"

#include <gtest/gtest.h>

#include <random>

#include "collision/bvh/closest_point.h"
#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;
constexpr double kRadius = 1.0;

const LayeredTooth& ball() {
    static const LayeredTooth tooth = [] {
        const TriangleMesh outer = test::sphere(Vec3::Zero(), kRadius, 96, 72);
        const TriangleMesh inner = test::sphere(Vec3::Zero(), 0.7, 96, 64);
        return *LayeredTooth::make(outer, {{"enamel", test::kEnamel, outer}, {"dentin", test::kDentin, inner}});
    }();
    return tooth;
}

Vec3 nodePosition(const Lattice& lattice, const BrickKey& key, int node) {
    return lattice.corner(key) + kVoxel * Vec3(node % 8, node / 8 % 8, node / 64);
}

TEST(BrickSampler, DistancesAreThoseOfTheSurfaceWithinTheBand) {
    const LayeredTooth& tooth = ball();
    const Lattice lattice(kVoxel);
    const double band = kToothBand * kVoxel;
    for (const BrickKey& key : lattice.bricksTouching(Box3(Vec3(0.3, 0.3, 0.3), Vec3(0.9, 0.9, 0.9)))) {
        const auto brick = sampleBrick(tooth, lattice, key);
        if (!brick) continue;
        for (int node = 0; node < kBrickNodes; ++node) {
            const Vec3 point = nodePosition(lattice, key, node);
            const double expected = std::clamp(point.norm() - kRadius, -band, band);
            ASSERT_NEAR(brick->tooth[node], expected, 2e-3);
            if (std::abs(expected) > 0.01 && std::abs(expected) < band - 0.01) {
                ASSERT_GT(brick->toothNormal[node].unpack().dot(point.normalized()), 0.99);
            }
        }
    }
}

TEST(BrickSampler, MaterialsFollowTheLayers) {
    const LayeredTooth& tooth = ball();
    const Lattice lattice(kVoxel);
    int compared = 0;
    for (const BrickKey& key : lattice.bricksTouching(Box3(Vec3(0.2, 0, 0), Vec3(1, 0.2, 0.2)))) {
        const auto brick = sampleBrick(tooth, lattice, key);
        if (!brick) continue;
        for (int node = 0; node < kBrickNodes; ++node) {
            const double radius = nodePosition(lattice, key, node).norm();
            if (radius > 0.99 || std::abs(radius - 0.7) < 0.005) continue;
            ++compared;
            ASSERT_EQ(brick->material[node], radius < 0.7 ? test::kDentin : test::kEnamel);
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST(BrickSampler, NoBrickIsMadeInTheAir) {
    const Lattice lattice(kVoxel);
    EXPECT_EQ(sampleBrick(ball(), lattice, lattice.brickAt(Vec3(2, 2, 2))), nullptr);
    EXPECT_NE(sampleBrick(ball(), lattice, lattice.brickAt(Vec3(0.1, 0.2, 0.1))), nullptr);
}

TEST(Brick, APackedDirectionKeepsItsDirection) {
    std::mt19937 random(40);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
        ASSERT_LT((OctahedralNormal(direction).unpack() - direction).norm(), 1e-4);
    }
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
        EXPECT_LT((OctahedralNormal(axis).unpack() - axis).norm(), 1e-12);
    }
}

TEST(BrickSampler, OverlappingBodiesHaveTheSidesOfARayTest) {
    TriangleMesh outer = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    const auto first = static_cast<std::uint32_t>(outer.triangles.size());
    append(outer, test::box(Vec3(0.5, -0.6, -0.7), Vec3(2, 0.8, 0.9)));  // inside the first one, and out of it
    const auto tooth = LayeredTooth::make(outer, {}, test::kDentin, {.firstAdjacent = first});
    ASSERT_TRUE(tooth);
    EXPECT_TRUE(tooth->bodiesOverlap());
    const Lattice lattice(kVoxel);
    int inside = 0, shared = 0;
    for (const BrickKey& key : lattice.bricksTouching(Box3(Vec3(0.2, -1.2, -1.2), Vec3(1.4, 1.2, 1.2)))) {
        const auto brick = sampleBrick(*tooth, lattice, key);
        if (!brick) continue;
        for (int node = 0; node < kBrickNodes; ++node) {
            const Vec3 point = nodePosition(lattice, key, node);
            if (std::abs(brick->tooth[node]) < 1e-4) continue;
            const bool isInside = contains(*tooth->outer(), point);
            ASSERT_EQ(brick->tooth[node] < 0, isInside) << point.transpose();
            inside += isInside;
            shared += !isInside && point.cwiseAbs().maxCoeff() < 1 && point.x() > 0.5;
        }
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(shared, 100);
}

TEST(BrickSampler, BodiesThatStandApartAreNoOverlap) {
    TriangleMesh outer = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
    const auto first = static_cast<std::uint32_t>(outer.triangles.size());
    append(outer, test::box(Vec3(1.01, -1, -1), Vec3(2, 1, 1)));
    EXPECT_FALSE(LayeredTooth::make(outer, {}, test::kDentin, {.firstAdjacent = first}).value().bodiesOverlap());
}

}  // namespace
}  // namespace tactooth
