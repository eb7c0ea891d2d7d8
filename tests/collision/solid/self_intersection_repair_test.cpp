// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/self_intersection_repair.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision/solid/self_intersection.h"
#include "geometry/field/isosurface.h"
#include "support/expect_assert.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

bool intersectsItself(const TriangleMesh& mesh) {
    return !selfIntersectingTriangles(SurfacePart(mesh)).value().empty();
}

/// A wavy wall around a tube, thinner than a cell.
double thinWall(const Vec3& p) {
    const double radius = std::hypot(p.x(), p.y()) - 1.2 - 0.1 * std::sin(5 * p.z());
    return std::max(std::abs(radius) - 0.07, std::abs(p.z()) - 1.5);
}

TEST(SelfIntersectionRepair, MovesASurfaceBackUntilItDoesNotIntersectItself) {
    const Box3 box(Vec3(-2, -2, -2), Vec3(2, 2, 2));
    RelaxedSurface surface = relaxedIsosurface(thinWall, box, {.cellSize = 0.21});
    ASSERT_EQ(surface.restPositions.size(), surface.mesh.vertices.size());
    ASSERT_TRUE(intersectsItself(surface.mesh));
    const TriangleMesh before = surface.mesh;
    EXPECT_TRUE(repairSelfIntersections(surface.mesh, surface.restPositions));
    EXPECT_FALSE(intersectsItself(surface.mesh));
    EXPECT_EQ(test::unpairedEdges(surface.mesh), 0);
    for (std::size_t i = 0; i < surface.restPositions.size(); ++i) {
        EXPECT_TRUE(surface.mesh.vertices[i] == before.vertices[i] ||
                    surface.mesh.vertices[i] == surface.restPositions[i]);
    }
}

TEST(SelfIntersectionRepair, LeavesASurfaceWithoutIntersectionsAsItIs) {
    const TriangleMesh ball = test::sphere(Vec3(0, 0, 0), 1, 20, 15);
    TriangleMesh same = ball;
    EXPECT_TRUE(repairSelfIntersections(same, std::vector<Vec3f>(ball.vertices.size(), Vec3f(9, 9, 9))));
    EXPECT_TRUE(test::areBitEqual(same, ball));
}

TEST(SelfIntersectionRepair, ReportsRestPositionsThatIntersect) {
    TriangleMesh pair;
    pair.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2F, 0.2F, -1}, {0.2F, 0.2F, 1}, {2, 2, 0}};
    pair.triangles = {{0, 1, 2}, {3, 4, 5}};
    const std::vector<Vec3f> restPositions = pair.vertices;
    EXPECT_FALSE(repairSelfIntersections(pair, restPositions));
}

TEST(SelfIntersectionRepair, AssertsThatEachVertexHasARestPosition) {
    TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    EXPECT_ASSERT((void)repairSelfIntersections(mesh, {}));
}

}  // namespace
}  // namespace tactooth
