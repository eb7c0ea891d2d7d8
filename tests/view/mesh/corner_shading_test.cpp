// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/corner_shading.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(CornerShading, BoxKeepsItsEdges) {
    const TriangleMesh box = test::box(Vec3(0, 0, 0), Vec3(1, 2, 3));
    const std::vector<Vec3f> normals = cornerShading(box).normals;
    for (std::size_t t = 0; t < box.triangles.size(); ++t) {
        const Vec3f facet = box.areaVector(t).normalized().cast<float>();
        for (std::size_t c = 0; c < 3; ++c) EXPECT_LT((normals[3 * t + c] - facet).norm(), 1e-6F);
    }
}

TEST(CornerShading, SphereIsSmooth) {
    const TriangleMesh ball = test::sphere(Vec3(1, 2, 3), 2, 48, 24);
    const std::vector<Vec3f> normals = cornerShading(ball).normals;
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Vec3f outward = ((ball.corner(t, c) - Vec3(1, 2, 3)) / 2).cast<float>();
            EXPECT_GT(normals[3 * t + static_cast<std::size_t>(c)].dot(outward), 0.9995F);
        }
    }
}

TEST(CornerShading, CylinderIsSmoothAroundAndSharpAtItsRim) {
    const TriangleMesh rod = test::cylinder(Vec3::Zero(), 1, 4, 32);
    const std::vector<Vec3f> normals = cornerShading(rod).normals;
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

/// A square of tag 2 and half a square of tag 5, folded up along their common edge x = 1 by `angle`, rad.
CornerShading shadingOfFold(double angle) {
    TriangleMesh sheet;
    const auto x = static_cast<float>(1 + std::cos(angle));
    const auto z = static_cast<float>(std::sin(angle));
    sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {x, 0, z}};
    sheet.triangles = {{0, 1, 3}, {0, 3, 2}, {1, 4, 3}};
    const std::vector<SurfaceTag> tags = {2, 2, 5};
    return cornerShading(sheet, tags);
}

TEST(CornerShading, MaterialsPassIntoEachOtherAtTheirBorder) {
    const CornerShading shading = shadingOfFold(0.1);
    EXPECT_EQ(shading.appearances[0], (AppearanceMix{2, 2, 0})) << "away from the border";
    EXPECT_EQ(shading.appearances[7], (AppearanceMix{5, 5, 0}));
    EXPECT_EQ(shading.appearances[2], (AppearanceMix{2, 5, 85})) << "90 degrees of one and 45 of the other at (1, 1)";
    EXPECT_EQ(shading.appearances[2], shading.appearances[8]) << "the same from both sides";
    EXPECT_EQ(shading.normals[2], shading.normals[8]);
}

TEST(CornerShading, MaterialsStayApartAcrossASharpEdge) {
    const CornerShading shading = shadingOfFold(0.9);
    EXPECT_EQ(shading.appearances[2], (AppearanceMix{2, 2, 0}));
    EXPECT_EQ(shading.appearances[8], (AppearanceMix{5, 5, 0}));
}

TEST(CornerShading, TriangleWithoutAreaGetsAUnitNormal) {
    TriangleMesh sliver;
    sliver.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    sliver.triangles = {{0, 1, 2}};
    for (const Vec3f& normal : cornerShading(sliver).normals) EXPECT_NEAR(normal.norm(), 1, 1e-6F);
}

TEST(CornerShading, ASplinterDoesNotTurnTheNormalOfTheWallThatItLiesIn) {
    TriangleMesh mesh;  // a flat square, and below one of its edges a sliver 1 um high that is inclined by 39 degrees
    const float lean = 0.00078F;
    mesh.vertices = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 1, 0), Vec3f(0, 1, 0), Vec3f(0.5F, -0.001F, -lean)};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}};
    const CornerShading shading = cornerShading(mesh);
    for (std::size_t corner = 0; corner < 6; ++corner) {
        EXPECT_LT((shading.normals[corner] - Vec3f::UnitZ()).norm(), 0.01F) << corner;
    }
}

}  // namespace
}  // namespace tactooth
