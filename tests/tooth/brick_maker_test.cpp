// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/brick_maker.h"

#include <gtest/gtest.h>

#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;
constexpr double kRadius = 1.0;

const LayeredTooth& ball() {
    static const LayeredTooth tooth = [] {
        const TriangleMesh outer = test::sphere(Vec3::Zero(), kRadius, 96, 72);
        const TriangleMesh inner = test::sphere(Vec3::Zero(), 0.7, 96, 64);
        return *LayeredTooth::make(outer,
                                   {{"enamel", MaterialId::Enamel, outer}, {"dentin", MaterialId::Dentin, inner}});
    }();
    return tooth;
}

Vec3 nodePosition(const Lattice& lattice, const BrickKey& key, int node) {
    return lattice.corner(key) + kVoxel * Vec3(node % 8, node / 8 % 8, node / 64);
}

TEST(BrickMaker, DistancesAreThoseOfTheSurfaceWithinTheBand) {
    const LayeredTooth& tooth = ball();
    const Lattice lattice(kVoxel);
    const double band = kToothBand * kVoxel;
    for (const BrickKey& key : lattice.bricksTouching(Box3(Vec3(0.3, 0.3, 0.3), Vec3(0.9, 0.9, 0.9)))) {
        const auto brick = makeBrick(tooth, lattice, key);
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

TEST(BrickMaker, MaterialsFollowTheLayers) {
    const LayeredTooth& tooth = ball();
    const Lattice lattice(kVoxel);
    int compared = 0;
    for (const BrickKey& key : lattice.bricksTouching(Box3(Vec3(0.2, 0, 0), Vec3(1, 0.2, 0.2)))) {
        const auto brick = makeBrick(tooth, lattice, key);
        if (!brick) continue;
        for (int node = 0; node < kBrickNodes; ++node) {
            const double radius = nodePosition(lattice, key, node).norm();
            if (radius > 0.99 || std::abs(radius - 0.7) < 0.005) continue;
            ++compared;
            ASSERT_EQ(brick->material[node], radius < 0.7 ? MaterialId::Dentin : MaterialId::Enamel);
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST(BrickMaker, NoBrickIsMadeInTheAir) {
    const Lattice lattice(kVoxel);
    EXPECT_EQ(makeBrick(ball(), lattice, lattice.brickAt(Vec3(2, 2, 2))), nullptr);
    EXPECT_NE(makeBrick(ball(), lattice, lattice.brickAt(Vec3(0.1, 0.2, 0.1))), nullptr);
}

TEST(Brick, APackedDirectionKeepsItsDirection) {
    std::mt19937 random(40);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
        ASSERT_LT((PackedDirection(direction).unpack() - direction).norm(), 1e-4);
    }
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
        EXPECT_LT((PackedDirection(axis).unpack() - axis).norm(), 1e-12);
    }
}

}  // namespace
}  // namespace tactooth
