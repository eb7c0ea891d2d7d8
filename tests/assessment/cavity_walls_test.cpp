// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cavity_walls.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <random>

#include "geometry/util/parallel_for.h"
#include "session/block_with_cavity.h"
#include "support/materials.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::blockWithCavity;

const TriangleMesh kBlock = test::box(Vec3(-5, -5, -5), Vec3(5, 5, 5));

double areaOf(const TriangleMesh& mesh) {
    double area = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) area += mesh.areaVector(i).norm() / 2;
    return area;
}

CavityWalls wallsOf(const TriangleMesh& target, const TriangleMesh& tooth = kBlock) {
    return cavityWalls(target, SurfacePart(tooth));
}

double rimLength(const CavityWalls& walls) {
    double length = 0;
    for (const auto& [from, to] : walls.rim) {
        length += (walls.mesh.vertices[from] - walls.mesh.vertices[to]).cast<double>().norm();
    }
    return length;
}

TEST(CavityWalls, OfABlockWithABoxAreItsWallsAndFloor) {
    const CavityWalls walls = wallsOf(blockWithCavity(Vec3(-2, -1.5, 3), Vec3(2, 1.5, 5)));
    // A floor of 4 x 3 mm and walls all around it, 2 mm high but for the depth where they end.
    EXPECT_NEAR(areaOf(walls.mesh), 12 + 14 * (2 - kCavityDepth), 1e-4);
    EXPECT_NEAR(rimLength(walls), 14, 1e-4);
    for (std::size_t i = 0; i < walls.mesh.triangles.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 place = walls.mesh.corner(i, corner);
            EXPECT_LT(place.z(), 5 - kCavityDepth + 1e-6);
            const double toWall = std::min(2 - std::abs(place.x()), 1.5 - std::abs(place.y()));
            EXPECT_NEAR(std::min(toWall, place.z() - 3), 0, 1e-6);
        }
    }
}

TEST(CavityWalls, FaceIntoTheCavity) {
    const Vec3 middle(0, 0, 4);
    const CavityWalls walls = wallsOf(blockWithCavity(Vec3(-2, -1.5, 3), Vec3(2, 1.5, 5)));
    for (std::size_t i = 0; i < walls.mesh.triangles.size(); ++i) {
        EXPECT_GT(walls.mesh.areaVector(i).dot(middle - walls.mesh.corner(i, 0)), 0);
    }
}

TEST(CavityWalls, HaveShortEdgesAndNoGapsButTheRim) {
    const CavityWalls walls = wallsOf(blockWithCavity(Vec3(-2, -1.5, 3), Vec3(2, 1.5, 5)));
    std::map<std::array<std::uint32_t, 2>, int> open;  // directed edges without a partner
    for (const Triangle& t : walls.mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = t[i], to = t[(i + 1) % 3];
            EXPECT_LE((walls.mesh.vertices[from] - walls.mesh.vertices[to]).norm(), kCavityEdge + 1e-6);
            ++open[{from, to}];
            --open[{to, from}];
        }
    }
    std::erase_if(open, [](const auto& edge) { return edge.second <= 0; });
    for (const auto& edge : walls.rim) EXPECT_EQ(open.erase(edge), 1U);
    EXPECT_TRUE(open.empty());
}

TEST(CavityWalls, OfTheToothItselfAreNone) {
    EXPECT_TRUE(wallsOf(kBlock).mesh.empty());
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 5, 60, 40);
    EXPECT_TRUE(wallsOf(ball, ball).mesh.empty());
}

TEST(CavityWalls, OfTheSameSurfaceFromOtherTrianglesAreNone) {
    // Its chords lie up to 8 um inside the finer one.
    const TriangleMesh fine = test::sphere(Vec3::Zero(), 5, 240, 160), coarse = test::sphere(Vec3::Zero(), 5, 120, 80);
    EXPECT_TRUE(wallsOf(coarse, fine).mesh.empty());
    EXPECT_TRUE(wallsOf(fine, coarse).mesh.empty());
}

TEST(CavityWalls, OfATargetOutsideTheToothAreNone) {
    EXPECT_TRUE(wallsOf(test::box(Vec3(6, 6, 6), Vec3(9, 9, 9))).mesh.empty());
    EXPECT_TRUE(wallsOf(test::box(Vec3(-6, -6, -6), Vec3(6, 6, 6))).mesh.empty());
}

TEST(CavityWalls, OfATargetPartlyOutsideAreWhatIsInside) {
    // A box that stands 1 mm deep in the block's top.
    const CavityWalls walls = wallsOf(test::box(Vec3(-1, -2, 4), Vec3(1, 2, 9)));
    EXPECT_NEAR(areaOf(walls.mesh), 8 + 12 * (1 - kCavityDepth), 1e-4);
    EXPECT_NEAR(rimLength(walls), 12, 1e-4);
}

TEST(CavityWalls, OfATargetWhollyInsideAreAllOfIt) {
    const CavityWalls walls = wallsOf(test::box(Vec3(-3, -3, -3), Vec3(3, 3, 3)));
    EXPECT_NEAR(areaOf(walls.mesh), 6 * 36, 1e-3);
    EXPECT_TRUE(walls.rim.empty());
    EXPECT_EQ(test::unpairedEdges(walls.mesh), 0);
}

TEST(CavityWalls, OfBallsAreCaps) {
    std::mt19937 random(20261122);
    std::uniform_real_distribution<double> height(2.5, 5.5);
    for (int i = 0; i < 8; ++i) {
        const double z = height(random);
        const CavityWalls walls = wallsOf(test::sphere(Vec3(0, 0, z), 2, 96, 64));
        const double below = std::clamp(5 - kCavityDepth - (z - 2), 0.0, 4.0);        // height of the part inside
        EXPECT_NEAR(areaOf(walls.mesh), 2 * std::numbers::pi * 2 * below, 0.1) << z;  // its chords are 0.2 % less
    }
}

TEST(CavityWalls, KeepTheirDistanceFromThePulpOrOpenIt) {
    const auto withPulpUpTo = [](double z) {
        std::vector<LayerMesh> layers = {{"pulp", test::kPulp, test::box(Vec3(-1, -1, -3), Vec3(1, 1, z))}};
        return *LayeredTooth::make(kBlock, std::move(layers));
    };
    const CavityWalls walls = wallsOf(blockWithCavity(Vec3(-2, -1.5, 3), Vec3(2, 1.5, 5)));
    EXPECT_NEAR(*leastToPulp(walls, withPulpUpTo(2.25)), 0.75, 1e-6);
    EXPECT_LT(*leastToPulp(walls, withPulpUpTo(3.5)), 0);
    EXPECT_FALSE(leastToPulp(walls, *LayeredTooth::make(kBlock)));
    EXPECT_FALSE(leastToPulp({}, withPulpUpTo(2.25)));
}

TEST(CavityWalls, AreTheSameOnOneThread) {
    const TriangleMesh target = blockWithCavity(Vec3(-2, -1.5, 3), Vec3(2, 1.5, 5));
    const CavityWalls walls = wallsOf(target);
    const ThreadLimit alone(1);
    const CavityWalls again = wallsOf(target);
    EXPECT_TRUE(test::areBitEqual(walls.mesh, again.mesh));
    EXPECT_EQ(walls.rim, again.rim);
}

}  // namespace
}  // namespace tactooth
