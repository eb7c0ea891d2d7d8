// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/near_weld.h"

#include <gtest/gtest.h>

#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(NearWeld, JoinsNearVerticesOnly) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.009F, 0, 0}, {1, 0.02F, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 2, 4}};
    std::size_t moved = 0;
    const TriangleMesh welded = weldedWithin(mesh, 0.01, &moved);
    EXPECT_EQ(moved, 1u);
    EXPECT_EQ(welded.vertices.size(), 4u);
    EXPECT_EQ(welded.triangles[1], (Triangle{0, 2, 3}));
}

TEST(NearWeld, AgreesWithAllPairs) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-1, 1);
    TriangleMesh mesh;
    for (int i = 0; i < 400; ++i) mesh.vertices.emplace_back(place(random), place(random), place(random));
    std::size_t moved = 0, expected = 0;
    (void)weldedWithin(mesh, 0.15, &moved);
    std::vector<Vec3f> kept;
    for (const Vec3f& vertex : mesh.vertices) {
        bool isNear = false;
        for (const Vec3f& other : kept) isNear |= (other.cast<double>() - vertex.cast<double>()).norm() <= 0.15;
        isNear ? void(++expected) : kept.push_back(vertex);
    }
    EXPECT_EQ(moved, expected);
    EXPECT_GT(moved, 20u);
}

}  // namespace
}  // namespace tactooth
