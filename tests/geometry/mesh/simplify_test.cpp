// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/simplify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "geometry/field/isosurface.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

bool isClosed(const TriangleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const Triangle& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
    }
    for (const auto& [edge, count] : uses) {
        if (count != 1 || !uses.contains({edge.second, edge.first})) return false;
    }
    return true;
}

int eulerNumber(const TriangleMesh& mesh) {
    return static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size() / 2);
}

TEST(Simplify, BallKeepsItsTopologyAndItsShape) {
    const TriangleMesh fine = test::sphere(Vec3::Zero(), 5, 80, 60);
    const TriangleMesh coarse = simplified(fine, 1500);
    EXPECT_LE(coarse.triangles.size(), 1500u);
    EXPECT_GE(coarse.triangles.size(), 1498u);
    EXPECT_TRUE(isClosed(coarse));
    EXPECT_EQ(eulerNumber(coarse), 2);
    for (std::size_t i = 0; i < coarse.triangles.size(); ++i) {
        const Vec3 middle = (coarse.corner(i, 0) + coarse.corner(i, 1) + coarse.corner(i, 2)) / 3;
        EXPECT_NEAR(middle.norm(), 5, 0.06);
        EXPECT_GT(coarse.areaVector(i).dot(middle), 0);
    }
}

TEST(Simplify, RingKeepsItsHandle) {
    const auto ring = [](const Vec3& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1.2, p.z()) - 0.5; };
    const TriangleMesh fine = isosurface(ring, Box3(Vec3(-2, -2, -1), Vec3(2, 2, 1)), {.cellSize = 0.1});
    const TriangleMesh coarse = simplified(fine, 600);
    EXPECT_TRUE(isClosed(coarse));
    EXPECT_EQ(eulerNumber(coarse), 0);
    EXPECT_LE(coarse.triangles.size(), 600u);
}

TEST(Simplify, StopsAtTheFewestTrianglesThatKeepTheTopology) {
    const TriangleMesh least = simplified(test::sphere(Vec3::Zero(), 1, 12, 8), 1);
    EXPECT_TRUE(isClosed(least));
    EXPECT_EQ(eulerNumber(least), 2);
    EXPECT_GE(least.triangles.size(), 4u);
}

TEST(Simplify, LeavesASmallEnoughMeshAlone) {
    const TriangleMesh box = test::box(Vec3::Zero(), Vec3::Ones());
    EXPECT_EQ(simplified(box, 12).triangles, box.triangles);
}

}  // namespace
}  // namespace tactooth
