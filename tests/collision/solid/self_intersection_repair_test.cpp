// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/self_intersection_repair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "collision/solid/self_intersection.h"
#include "geometry/field/isosurface.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

std::vector<std::uint32_t> selfIntersections(const TriangleMesh& mesh) {
    return selfIntersectingTriangles(SurfacePart(mesh)).value();
}

/// Oracle: where the line through `from` and `to` meets the triangle's plane, in shares of the segment and of the
/// triangle's sides.
bool segmentMeets(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b, const Vec3& c) {
    Mat3 system;
    system << from - to, b - a, c - a;
    const Vec3 share = system.inverse() * (from - a);
    return share.x() >= 0 && share.x() <= 1 && share.y() >= 0 && share.z() >= 0 && share.y() + share.z() <= 1;
}

/// Whether an edge of one of the two triangles of `mesh` goes through the other one; edges that end in a common corner
/// are left out.
bool anEdgeGoesThrough(const TriangleMesh& mesh) {
    const auto goes = [&](std::size_t one, std::size_t other) {
        const Triangle &edges = mesh.triangles[one], &face = mesh.triangles[other];
        const auto isCommon = [&](std::uint32_t v) { return v == face[0] || v == face[1] || v == face[2]; };
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t from = edges[i], to = edges[(i + 1) % 3];
            if (isCommon(from) || isCommon(to)) continue;
            if (segmentMeets(mesh.vertices[from].cast<double>(), mesh.vertices[to].cast<double>(),
                             mesh.corner(other, 0), mesh.corner(other, 1), mesh.corner(other, 2))) {
                return true;
            }
        }
        return false;
    };
    return goes(0, 1) || goes(1, 0);
}

/// Ten thousand pairs of triangles with `common` corners in common, judged by the oracle; the share that cross.
double shareOfIntersectingPairs(std::uint32_t common) {
    std::mt19937 random(7 + common);
    std::uniform_real_distribution<float> place(-1, 1);
    constexpr int kPairs = 10000;
    int crossing = 0;
    for (int i = 0; i < kPairs; ++i) {
        TriangleMesh mesh;
        for (std::uint32_t v = 0; v < 6 - common; ++v) {
            const float x = place(random), y = place(random), z = place(random);
            mesh.vertices.emplace_back(x, y, z);
        }
        mesh.triangles = {{0, 1, 2}, common == 0 ? Triangle{3, 4, 5} : Triangle{3, 0, 4}};
        const bool crosses = anEdgeGoesThrough(mesh);
        EXPECT_EQ(selfIntersections(mesh).size(), crosses ? 2u : 0u) << i;
        crossing += crosses ? 1 : 0;
    }
    return crossing / double{kPairs};
}

TEST(SelfIntersections, AreThePairsThatAnEdgeOfOneGoesThroughTheOther) {
    const double share = shareOfIntersectingPairs(0);
    EXPECT_GT(share, 0.1);
    EXPECT_LT(share, 0.7);
}

TEST(SelfIntersections, OfTrianglesWithACommonCornerAreThoseElsewhere) {
    const double share = shareOfIntersectingPairs(1);
    EXPECT_GT(share, 0.1);
    EXPECT_LT(share, 0.7);
}

TEST(SelfIntersections, ClosedBodiesHaveNone) {
    EXPECT_TRUE(selfIntersections(test::box(Vec3(0, 0, 0), Vec3(1, 2, 3))).empty());
    EXPECT_TRUE(selfIntersections(test::sphere(Vec3(3, -2, 1), 4, 40, 30)).empty());
    EXPECT_TRUE(selfIntersections(test::cylinder(Vec3(0, 0, 0), 1, 5, 30)).empty());
    EXPECT_TRUE(selfIntersections({}).empty());
}

TEST(SelfIntersections, OfTwoBodiesAreThoseAlongTheirSeam) {
    TriangleMesh both = test::sphere(Vec3(0, 0, 0), 1, 40, 30);
    const TriangleMesh other = test::sphere(Vec3(1, 0, 0), 1, 40, 30);
    const auto first = static_cast<std::uint32_t>(both.vertices.size());
    both.vertices.insert(both.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles) both.triangles.push_back({a + first, b + first, c + first});
    const auto crossing = selfIntersections(both);
    EXPECT_FALSE(crossing.empty());
    constexpr double kTriangle = 0.25;  // longer than any edge
    for (const std::uint32_t t : crossing) EXPECT_NEAR(both.corner(t, 0).x(), 0.5, kTriangle);
}

TEST(SelfIntersections, TellAFoldedPairFromAFlatOne) {
    TriangleMesh pair;
    pair.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5F, -1, 0}, {0.5F, 0.5F, 0}};
    pair.triangles = {{0, 1, 2}, {1, 0, 3}};
    EXPECT_TRUE(selfIntersections(pair).empty());
    pair.triangles = {{0, 1, 2}, {1, 0, 4}};
    EXPECT_EQ(selfIntersections(pair).size(), 2u);
}

/// A wall that is thinner than a cell, round a tube, and wavy.
double thinWall(const Vec3& p) {
    const double radius = std::hypot(p.x(), p.y()) - 1.2 - 0.1 * std::sin(5 * p.z());
    return std::max(std::abs(radius) - 0.07, std::abs(p.z()) - 1.5);
}

TEST(SelfIntersectionRepair, TakesACrossingSurfaceBackToWhereItDoesNotCross) {
    const Box3 box(Vec3(-2, -2, -2), Vec3(2, 2, 2));
    RelaxedSurface surface = relaxedIsosurface(thinWall, box, {.cellSize = 0.21});
    ASSERT_EQ(surface.restPositions.size(), surface.mesh.vertices.size());
    ASSERT_FALSE(selfIntersections(surface.mesh).empty());
    const TriangleMesh before = surface.mesh;
    EXPECT_TRUE(repairSelfIntersections(surface.mesh, surface.restPositions));
    EXPECT_TRUE(selfIntersections(surface.mesh).empty());
    EXPECT_EQ(test::unpairedEdges(surface.mesh), 0);
    for (std::size_t i = 0; i < surface.restPositions.size(); ++i) {
        EXPECT_TRUE(surface.mesh.vertices[i] == before.vertices[i] || surface.mesh.vertices[i] == surface.restPositions[i]);
    }
}

TEST(SelfIntersectionRepair, LeavesASurfaceThatDoesNotCrossAsItIs) {
    const TriangleMesh ball = test::sphere(Vec3(0, 0, 0), 1, 20, 15);
    TriangleMesh same = ball;
    EXPECT_TRUE(repairSelfIntersections(same, std::vector<Vec3f>(ball.vertices.size(), Vec3f(9, 9, 9))));
    EXPECT_TRUE(test::areBitEqual(same, ball));
}

TEST(SelfIntersectionRepair, SaysWhenEvenTheWayBackCrosses) {
    TriangleMesh pair;
    pair.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2F, 0.2F, -1}, {0.2F, 0.2F, 1}, {2, 2, 0}};
    pair.triangles = {{0, 1, 2}, {3, 4, 5}};
    const std::vector<Vec3f> home = pair.vertices;
    EXPECT_FALSE(repairSelfIntersections(pair, home));
}

}  // namespace
}  // namespace tactooth
