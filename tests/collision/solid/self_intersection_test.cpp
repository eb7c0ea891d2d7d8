// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/self_intersection.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/mesh/triangle_intersection.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

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

TEST(SelfIntersection, AgreesWithBruteForce) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> place(-3, 3), radius(0.1, 2);
    std::size_t crossing = 0, sound = 0;
    for (int round = 0; round < 25; ++round) {
        TriangleMesh mesh;
        for (int body = 0; body < 4; ++body) {
            const Vec3 middle(place(random), place(random), place(random));
            append(mesh, body % 2 == 0 ? test::sphere(middle, radius(random), 12, 8)
                                       : test::cylinder(middle, radius(random), 3, 9));
        }
        const auto expected = intersectionsByPairs(mesh);
        const auto found = selfIntersectingTriangles(SurfacePart(mesh));
        ASSERT_TRUE(found);
        EXPECT_EQ(*found, expected) << round;
        ++(expected.empty() ? sound : crossing);
    }
    EXPECT_GT(crossing, 8u);
    EXPECT_GT(sound, 0u);
}

TEST(SelfIntersection, HandlesTrianglesOfVeryDifferentSizes) {
    TriangleMesh mesh = test::box(Vec3(-50, -50, -1), Vec3(50, 50, 0));
    append(mesh, test::sphere(Vec3(0, 0, 1), 0.9, 200, 150));
    EXPECT_TRUE(selfIntersectingTriangles(SurfacePart(mesh)).value().empty());
    append(mesh, test::sphere(Vec3(20, 0, 0), 0.01, 12, 8));
    EXPECT_FALSE(selfIntersectingTriangles(SurfacePart(mesh)).value().empty());
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
