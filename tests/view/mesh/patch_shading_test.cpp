// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/patch_shading.h"

#include <gtest/gtest.h>

#include <array>

#include "support/shapes.h"

namespace tactooth {
namespace {

ShadedPatch patchOf(const TriangleMesh& mesh, const SurfacePart& base, std::vector<SurfaceTag> tags = {}) {
    return {std::make_shared<const SurfacePart>(mesh, std::move(tags)), base, cornerShading(base.mesh(), base.tags())};
}

TEST(PatchShading, PieceOfABaseTriangleTakesOverItsShading) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 3, 24, 12);
    std::vector<SurfaceTag> tags(ball.triangles.size(), 1);
    const std::uint32_t parent = 100;
    tags[parent] = 4;
    const SurfacePart base(ball, tags);
    const CornerShading whole = cornerShading(base.mesh(), tags);
    const Vec3 a = base.mesh().corner(parent, 0);
    const Vec3 b = base.mesh().corner(parent, 1);
    const Vec3 c = base.mesh().corner(parent, 2);
    TriangleMesh piece;
    piece.vertices = {a.cast<float>(), ((a + b) / 2).cast<float>(), ((a + c) / 2).cast<float>()};
    piece.triangles = {{0, 1, 2}};
    const CornerShading shading = patchShading(patchOf(piece, base, {4}), {}, base, whole);
    EXPECT_LT((shading.normals[0] - whole.normals[3 * parent]).norm(), 1e-3F);
    EXPECT_LT((shading.normals[1] - (whole.normals[3 * parent] + whole.normals[3 * parent + 1]).normalized()).norm(),
              1e-3F);
    EXPECT_EQ(shading.appearances[0].first, 1);
    EXPECT_EQ(shading.appearances[0].second, 4);
    const double wanted = (whole.appearances[3 * parent].share + whole.appearances[3 * parent + 1].share) / 2.0;
    EXPECT_NEAR(shading.appearances[1].share, wanted, 1);
}

TEST(PatchShading, CutSurfaceKeepsItsOwnShading) {
    const SurfacePart base(test::sphere(Vec3::Zero(), 3, 24, 12));
    const TriangleMesh cut = test::box(Vec3(2.5, -0.2, -0.2), Vec3(2.7, 0.2, 0.2));
    const CornerShading shading = patchShading(patchOf(cut, base), {}, base, cornerShading(base.mesh()));
    EXPECT_EQ(shading.normals, cornerShading(cut).normals);
}

TEST(PatchShading, WallsOfNeighboursAreShadedAsOne) {
    const SurfacePart base(test::box(Vec3::Constant(-9), Vec3::Constant(9)));
    const CornerShading baseShading = cornerShading(base.mesh());
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 2, 48, 24);
    std::array<TriangleMesh, 3> pieces;  // bands of the ball, each with its own vertices
    std::array<std::vector<std::size_t>, 3> whole;
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        const double height = ball.corner(t, 0).z() + ball.corner(t, 1).z() + ball.corner(t, 2).z();
        const std::size_t band = height < -1 ? 0 : height < 1.5 ? 1 : 2;
        TriangleMesh& piece = pieces[band];
        const auto vertexOf = [&](int corner) {
            const Vec3f v = ball.corner(t, corner).cast<float>();
            const auto known = std::find(piece.vertices.begin(), piece.vertices.end(), v);
            if (known == piece.vertices.end()) piece.vertices.push_back(v);
            return static_cast<std::uint32_t>(std::find(piece.vertices.begin(), piece.vertices.end(), v) -
                                              piece.vertices.begin());
        };
        piece.triangles.push_back({vertexOf(0), vertexOf(1), vertexOf(2)});
        whole[band].push_back(t);
    }
    const ShadedPatch below = patchOf(pieces[0], base), middle = patchOf(pieces[1], base);
    const ShadedPatch above = patchOf(pieces[2], base);
    const CornerShading wanted = cornerShading(ball);
    const auto worst = [&](const CornerShading& shading) {
        float largest = 0;
        for (std::size_t i = 0; i < whole[1].size(); ++i) {
            for (std::size_t c = 0; c < 3; ++c) {
                largest = std::max(largest, (shading.normals[3 * i + c] - wanted.normals[3 * whole[1][i] + c]).norm());
            }
        }
        return largest;
    };
    EXPECT_LT(worst(patchShading(middle, std::array{&below, &above}, base, baseShading)), 1e-5F);
    EXPECT_GT(worst(patchShading(middle, {}, base, baseShading)), 0.02F);
}

TEST(PatchShading, TheWallKeepsItsEdgeTowardThePiecesOfTheBase) {
    const SurfacePart base(test::box(Vec3(0, 0, -5), Vec3(5, 5, 0)));
    const CornerShading baseShading = cornerShading(base.mesh());
    TriangleMesh mesh;  // a piece of the top face and a wall that slopes down from its edge by 30 degrees
    mesh.vertices = {Vec3f(1, 1, 0), Vec3f(2, 1, 0), Vec3f(2, 3, 0), Vec3f(3, 1, -0.577F), Vec3f(3, 3, -0.577F)};
    mesh.triangles = {{0, 1, 2}, {1, 3, 4}, {1, 4, 2}};
    const CornerShading shading = patchShading(patchOf(mesh, base), {}, base, baseShading);
    const Vec3f wall = mesh.areaVector(1).normalized().cast<float>();
    for (std::size_t corner = 0; corner < 3; ++corner)
        EXPECT_LT((shading.normals[corner] - Vec3f::UnitZ()).norm(), 1e-6F);
    for (std::size_t corner = 3; corner < 9; ++corner) EXPECT_LT((shading.normals[corner] - wall).norm(), 1e-3F);
}

TEST(PatchShading, WhereTheWallBeginsItHasTheAppearancesOfTheBase) {
    const TriangleMesh block = test::box(Vec3(0, 0, -5), Vec3(5, 5, 0));
    const std::vector<SurfaceTag> tags(block.triangles.size(), 5);
    const SurfacePart base(block, tags);
    TriangleMesh wall;  // slopes down from the top face
    wall.vertices = {Vec3f(2, 1, 0), Vec3f(2, 3, 0), Vec3f(3, 1, -1), Vec3f(3, 3, -1)};
    wall.triangles = {{0, 2, 3}, {0, 3, 1}};
    const CornerShading shading = patchShading(patchOf(wall, base, {1, 1}), {}, base, cornerShading(block, tags));
    const std::array<SurfaceTag, 6> wanted = {5, 1, 1, 5, 1, 5};
    for (std::size_t corner = 0; corner < wanted.size(); ++corner) {
        EXPECT_EQ(shading.appearances[corner].first, wanted[corner]) << corner;
    }
}

}  // namespace
}  // namespace tactooth
