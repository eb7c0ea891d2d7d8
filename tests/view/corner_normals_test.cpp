// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/corner_normals.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(CornerNormals, BoxKeepsItsEdges) {
    const TriangleMesh box = test::box(Vec3(0, 0, 0), Vec3(1, 2, 3));
    const std::vector<Vec3f> normals = cornerNormals(box);
    for (std::size_t t = 0; t < box.triangles.size(); ++t) {
        const Vec3f facet = box.areaVector(t).normalized().cast<float>();
        for (std::size_t c = 0; c < 3; ++c) EXPECT_LT((normals[3 * t + c] - facet).norm(), 1e-6F);
    }
}

TEST(CornerNormals, SphereIsSmooth) {
    const TriangleMesh ball = test::sphere(Vec3(1, 2, 3), 2, 48, 24);
    const std::vector<Vec3f> normals = cornerNormals(ball);
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Vec3f outward = ((ball.corner(t, c) - Vec3(1, 2, 3)) / 2).cast<float>();
            EXPECT_GT(normals[3 * t + static_cast<std::size_t>(c)].dot(outward), 0.9995F);
        }
    }
}

TEST(CornerNormals, CylinderIsSmoothAroundAndSharpAtItsRim) {
    const TriangleMesh rod = test::cylinder(Vec3::Zero(), 1, 4, 32);
    const std::vector<Vec3f> normals = cornerNormals(rod);
    for (std::size_t t = 0; t < rod.triangles.size(); ++t) {
        const bool cap = std::abs(rod.areaVector(t).normalized().z()) > 0.9;
        for (int c = 0; c < 3; ++c) {
            const Vec3f normal = normals[3 * t + static_cast<std::size_t>(c)];
            if (cap) {
                EXPECT_GT(std::abs(normal.z()), 0.9999F);
            } else {
                Vec3f radial = rod.corner(t, c).cast<float>();
                radial.z() = 0;
                EXPECT_GT(normal.dot(radial), 0.9999F);
            }
        }
    }
}

TEST(CornerNormals, BorderOfAMaterialIsAnEdge) {
    // Two triangles of a gently folded sheet: smooth with one tag, faceted with two.
    TriangleMesh sheet;
    sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.2F}};
    sheet.triangles = {{0, 1, 2}, {1, 3, 2}};
    const std::vector<Vec3f> smooth = cornerNormals(sheet);
    EXPECT_LT((smooth[1] - smooth[3]).norm(), 1e-6F);
    const std::vector<SurfaceTag> tags = {0, 1};
    const std::vector<Vec3f> faceted = cornerNormals(sheet, tags);
    EXPECT_GT((faceted[1] - faceted[3]).norm(), 0.05F);
}

TEST(CornerNormals, TriangleWithoutAreaGetsAUnitNormal) {
    TriangleMesh sliver;
    sliver.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    sliver.triangles = {{0, 1, 2}};
    for (const Vec3f& normal : cornerNormals(sliver)) EXPECT_NEAR(normal.norm(), 1, 1e-6F);
}

TEST(PatchNormals, PieceOfABaseTriangleTakesOverItsNormals) {
    const SurfacePart base(test::sphere(Vec3::Zero(), 3, 24, 12));
    const std::vector<Vec3f> baseNormals = cornerNormals(base.mesh());
    const std::uint32_t parent = 100;
    const Vec3 a = base.mesh().corner(parent, 0);
    const Vec3 b = base.mesh().corner(parent, 1);
    const Vec3 c = base.mesh().corner(parent, 2);
    TriangleMesh piece;
    piece.vertices = {a.cast<float>(), ((a + b) / 2).cast<float>(), ((a + c) / 2).cast<float>()};
    piece.triangles = {{0, 1, 2}};
    const std::vector<Vec3f> normals = patchNormals(SurfacePart(piece), base, baseNormals);
    EXPECT_LT((normals[0] - baseNormals[3 * parent]).norm(), 1e-3F);
    EXPECT_LT((normals[1] - (baseNormals[3 * parent] + baseNormals[3 * parent + 1]).normalized()).norm(), 1e-3F);
}

TEST(PatchNormals, CutSurfaceKeepsItsOwnNormals) {
    const SurfacePart base(test::sphere(Vec3::Zero(), 3, 24, 12));
    const TriangleMesh cut = test::box(Vec3(2.5, -0.2, -0.2), Vec3(2.7, 0.2, 0.2));
    const std::vector<Vec3f> normals = patchNormals(SurfacePart(cut), base, cornerNormals(base.mesh()));
    EXPECT_EQ(normals, cornerNormals(cut));
}

}  // namespace
}  // namespace tactooth
