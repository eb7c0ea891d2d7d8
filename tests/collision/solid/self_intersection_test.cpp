// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/self_intersection.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/mesh/triangle_intersection.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

std::vector<std::uint32_t> selfIntersections(const TriangleMesh& mesh) {
    return selfIntersectingTriangles(SurfacePart(mesh)).value();
}

/// Oracle: tests all pairs of triangles.
std::vector<std::uint32_t> intersectionsByPairs(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t a = 0; a < mesh.triangles.size(); ++a) {
        for (std::uint32_t b = 0; b < mesh.triangles.size(); ++b) {
            if (a != b && trianglesIntersect(mesh, std::min(a, b), std::max(a, b))) {
                found.push_back(a);
                break;
            }
        }
    }
    return found;
}

/// Oracle: where the line through `from` and `to` meets the triangle's plane, as fractions of the segment and of the
/// triangle's sides.
bool segmentMeets(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b, const Vec3& c) {
    Mat3 system;
    system << from - to, b - a, c - a;
    const Vec3 at = system.inverse() * (from - a);
    return at.x() >= 0 && at.x() <= 1 && at.y() >= 0 && at.z() >= 0 && at.y() + at.z() <= 1;
}

/// Whether an edge of one of the two triangles of `mesh` passes through the other one. Edges that end in a common
/// corner are left out.
bool anEdgePassesThrough(const TriangleMesh& mesh) {
    const auto passes = [&](std::size_t one, std::size_t other) {
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
    return passes(0, 1) || passes(1, 0);
}

/// Compares ten thousand pairs of triangles with `common` common corners with the oracle. Returns the fraction that
/// intersects.
double intersectingFraction(std::uint32_t common) {
    std::mt19937 random(7 + common);
    std::uniform_real_distribution<float> place(-1, 1);
    constexpr int kPairs = 10000;
    int intersecting = 0;
    for (int i = 0; i < kPairs; ++i) {
        TriangleMesh mesh;
        for (std::uint32_t v = 0; v < 6 - common; ++v) {
            const float x = place(random), y = place(random), z = place(random);
            mesh.vertices.emplace_back(x, y, z);
        }
        mesh.triangles = {{0, 1, 2}, common == 0 ? Triangle{3, 4, 5} : Triangle{3, 0, 4}};
        const bool intersects = anEdgePassesThrough(mesh);
        EXPECT_EQ(selfIntersections(mesh).size(), intersects ? 2u : 0u) << i;
        intersecting += intersects ? 1 : 0;
    }
    return intersecting / double{kPairs};
}

TEST(SelfIntersection, AgreesWithBruteForce) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(-3, 3), radius(0.1, 2);
    std::size_t intersecting = 0, clean = 0;
    for (int i = 0; i < 25; ++i) {
        TriangleMesh mesh;
        for (int body = 0; body < 4; ++body) {
            const Vec3 middle(place(random), place(random), place(random));
            append(mesh, body % 2 == 0 ? test::sphere(middle, radius(random), 12, 8)
                                       : test::cylinder(middle, radius(random), 3, 9));
        }
        const auto expected = intersectionsByPairs(mesh);
        const auto found = selfIntersectingTriangles(SurfacePart(mesh));
        ASSERT_TRUE(found);
        EXPECT_EQ(*found, expected) << i;
        ++(expected.empty() ? clean : intersecting);
    }
    EXPECT_GT(intersecting, 8u);
    EXPECT_GT(clean, 0u);
}

TEST(SelfIntersection, HandlesTrianglesOfVeryDifferentSizes) {
    TriangleMesh mesh = test::box(Vec3(-50, -50, -1), Vec3(50, 50, 0));
    append(mesh, test::sphere(Vec3(0, 0, 1), 0.9, 200, 150));
    EXPECT_TRUE(selfIntersectingTriangles(SurfacePart(mesh)).value().empty());
    append(mesh, test::sphere(Vec3(20, 0, 0), 0.01, 12, 8));
    EXPECT_FALSE(selfIntersectingTriangles(SurfacePart(mesh)).value().empty());
}

TEST(SelfIntersection, ListsPairsInWhichAnEdgePassesThroughTheOtherTriangle) {
    const double fraction = intersectingFraction(0);
    EXPECT_GT(fraction, 0.1);
    EXPECT_LT(fraction, 0.7);
}

TEST(SelfIntersection, IgnoresTheCommonCornerOfTwoTriangles) {
    const double fraction = intersectingFraction(1);
    EXPECT_GT(fraction, 0.1);
    EXPECT_LT(fraction, 0.7);
}

TEST(SelfIntersection, FindsNoneInClosedBodies) {
    EXPECT_TRUE(selfIntersections(test::box(Vec3(0, 0, 0), Vec3(1, 2, 3))).empty());
    EXPECT_TRUE(selfIntersections(test::sphere(Vec3(3, -2, 1), 4, 40, 30)).empty());
    EXPECT_TRUE(selfIntersections(test::cylinder(Vec3(0, 0, 0), 1, 5, 30)).empty());
    EXPECT_TRUE(selfIntersections({}).empty());
}

TEST(SelfIntersection, FindsThoseOfTwoBodiesAlongTheirIntersectionCurve) {
    TriangleMesh both = test::sphere(Vec3(0, 0, 0), 1, 40, 30);
    append(both, test::sphere(Vec3(1, 0, 0), 1, 40, 30));
    const auto intersecting = selfIntersections(both);
    EXPECT_FALSE(intersecting.empty());
    constexpr double kTriangle = 0.25;  // longer than any edge
    for (const std::uint32_t t : intersecting) EXPECT_NEAR(both.corner(t, 0).x(), 0.5, kTriangle);
}

TEST(SelfIntersection, DistinguishesAFoldedPairFromAFlatOne) {
    TriangleMesh pair;
    pair.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5F, -1, 0}, {0.5F, 0.5F, 0}};
    pair.triangles = {{0, 1, 2}, {1, 0, 3}};
    EXPECT_TRUE(selfIntersections(pair).empty());
    pair.triangles = {{0, 1, 2}, {1, 0, 4}};
    EXPECT_EQ(selfIntersections(pair).size(), 2u);
}

TEST(SelfIntersection, GivesUpOnATangle) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-10, 10);
    TriangleMesh mesh;
    for (std::uint32_t v = 0; v < 60000; ++v) mesh.vertices.emplace_back(place(random), place(random), place(random));
    for (std::uint32_t v = 0; v < 60000; v += 3) mesh.triangles.push_back({v, v + 1, v + 2});
    EXPECT_FALSE(selfIntersectingTriangles(SurfacePart(mesh), 1'000'000));
}

}  // namespace
}  // namespace tactooth
