// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Wrong calls of the geometry layer fire an assert.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/field/cell_patches.h"
#include "geometry/field/isosurface.h"
#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/near_weld.h"
#include "geometry/mesh/subdivide.h"
#include "geometry/mesh/triangle_intersection.h"
#include "geometry/mesh/vertex_welder.h"
#include "geometry/util/disjoint_sets.h"
#include "geometry/util/exact_sign.h"
#include "geometry/util/index_bitset.h"
#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

#if defined(TACTOOTH_ASSERTS)

const double kNan = std::nan("");

TriangleMesh box() { return test::box(Vec3::Zero(), Vec3::Ones()); }

TEST(GeometryPrecondition, ACornerIsThatOfATriangle) {
    const TriangleMesh mesh = box();
    EXPECT_ASSERT((void)mesh.corner(12, 0));
    EXPECT_ASSERT((void)mesh.corner(0, 3));
    EXPECT_ASSERT((void)mesh.corner(0, -1));
}

TEST(GeometryPrecondition, ATriangleNamesVerticesOfTheMesh) {
    TriangleMesh mesh = box();
    mesh.triangles[3][1] = 8;
    EXPECT_ASSERT((void)mesh.corner(3, 1));
    EXPECT_ASSERT((void)boundingBox(mesh));
    EXPECT_ASSERT(MeshEdges{mesh});
    EXPECT_ASSERT((void)edgeBalance(mesh));
}

TEST(GeometryPrecondition, ATransformIsRigid) {
    EXPECT_ASSERT((void)transformed(box(), {Vec3::Zero(), Quat(2, 0, 0, 0)}));
    EXPECT_ASSERT((void)transformed(box(), {Vec3(kNan, 0, 0), Quat::Identity()}));
}

TEST(GeometryPrecondition, AWeldedVertexIsFinite) {
    VertexWelder welder(4);
    EXPECT_ASSERT((void)welder.add(Vec3f(std::nanf(""), 0, 0)));
}

TEST(GeometryPrecondition, AToleranceIsPositiveAndMarksAreComplete) {
    EXPECT_ASSERT((void)weldedWithin(box(), 0));
    EXPECT_ASSERT((void)weldedWithin(box(), kNan));
    EXPECT_ASSERT((void)weldedWithin(box(), 0.1, nullptr, std::vector<std::uint8_t>(3)));
}

TEST(GeometryPrecondition, SubdivisionGoesForward) { EXPECT_ASSERT((void)subdivided(box(), -1)); }

TEST(GeometryPrecondition, TwoTrianglesAreDifferentAndExist) {
    const TriangleMesh mesh = box();
    EXPECT_ASSERT((void)trianglesIntersect(mesh, 1, 1));
    EXPECT_ASSERT((void)trianglesIntersect(mesh, 1, 12));
}

TEST(GeometryPrecondition, AnIsosurfaceHasCellsAndABox) {
    const ScalarField ball = [](const Vec3& p) { return p.norm() - 1; };
    const Box3 bounds(Vec3::Constant(-1.5), Vec3::Constant(1.5));
    EXPECT_ASSERT((void)isosurface(ball, bounds, {.cellSize = 0}));
    EXPECT_ASSERT((void)isosurface(ball, bounds, {.cellSize = 0.2, .lipschitzBound = -1}));
    EXPECT_ASSERT((void)isosurface(ball, Box3(), {.cellSize = 0.2}));
    EXPECT_ASSERT((void)cellPatches(256));
}

TEST(GeometryPrecondition, NumbersAreBelowTheirBound) {
    DisjointSets sets(5);
    EXPECT_ASSERT((void)sets.find(5));
    IndexBitset bits(64);
    EXPECT_ASSERT(bits.add(64));
    bits.add(3);
    const BitsetRank rank(bits);
    EXPECT_ASSERT((void)rank[2]);
    EXPECT_ASSERT((void)crossProductSign({0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}, 3));
}

TEST(GeometryPrecondition, DirectionsOfARotationAreNotZero) {
    EXPECT_ASSERT((void)shortestRotation(Vec3::Zero(), Vec3::UnitX()));
}

#endif

}  // namespace
}  // namespace tactooth
