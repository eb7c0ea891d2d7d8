// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/detail_levels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/mesh_checks.h"
#include "support/shapes.h"
#include "view/corner_shading.h"
#include "view/renderer_fixture.h"

namespace tactooth {
namespace {

constexpr double kRadius = 5;
constexpr std::uint32_t kNothingHidden = 0;

ShadingMesh fineBall() {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), kRadius, 400, 200);
    return shadingMesh(ball, cornerShading(ball));
}

/// An eye far away that sees everything and lets the surface be off by this much, mm.
ClusterCuller lenient(double error) {
    const Mat4 everything = Mat4::Identity() * 1e-3 + Mat4::Identity().col(3) * Eigen::RowVector4d(0, 0, 0, 1 - 1e-3);
    return {everything, Eigen::Vector4d(0, 0, 1, 0), false, error};
}

std::vector<Triangle> drawn(const DetailLevels& levels, const ShadingMesh& mesh, const ClusterCuller& culler,
                            std::span<const std::uint32_t> hidden) {
    std::vector<TriangleRun> runs;
    levels.visibleRuns(culler, mesh.clusters, hidden, runs);
    std::vector<Triangle> all = mesh.triangles, result;
    all.insert(all.end(), levels.triangles().begin(), levels.triangles().end());
    for (const TriangleRun& run : runs) {
        result.insert(result.end(), all.begin() + run.first, all.begin() + run.first + run.count);
    }
    return result;
}

TriangleMesh meshOf(const ShadingMesh& mesh, std::vector<Triangle> triangles) {
    TriangleMesh result;
    for (const ShadingVertex& vertex : mesh.vertices) result.vertices.emplace_back(vertex.position.data());
    result.triangles = std::move(triangles);
    return result;
}

TEST(DetailLevels, NoErrorAllowedDrawsTheSurfaceItself) {
    const ShadingMesh mesh = fineBall();
    const DetailLevels levels(mesh);
    const std::vector<std::uint32_t> hidden(levels.groups(), kNothingHidden);
    EXPECT_EQ(drawn(levels, mesh, lenient(0), hidden), mesh.triangles);
    EXPECT_EQ(drawn(levels, mesh, lenient(0.007), hidden), mesh.triangles);
}

TEST(DetailLevels, CoarserOnesAreClosedNearTheSurfaceAndFewer) {
    const ShadingMesh mesh = fineBall();
    const DetailLevels levels(mesh);
    const std::vector<std::uint32_t> hidden(levels.groups(), kNothingHidden);
    const double whole = test::volumeOf(meshOf(mesh, mesh.triangles));
    std::size_t before = mesh.triangles.size();
    for (const double allowed : {0.01, 0.05}) {
        const TriangleMesh coarse = meshOf(mesh, drawn(levels, mesh, lenient(allowed), hidden));
        EXPECT_LT(coarse.triangles.size(), before / 2);
        EXPECT_EQ(test::unpairedEdges(coarse), 0);
        const double area = 4 * 3.14159265 * kRadius * kRadius;
        EXPECT_NEAR(test::volumeOf(coarse), whole, allowed * area);
        EXPECT_NE(test::volumeOf(coarse), whole);
        before = coarse.triangles.size();
    }
}

TEST(DetailLevels, AGroupThatWasCutIsDrawnAsItIsAndNoGapOpensAroundIt) {
    const ShadingMesh mesh = fineBall();
    const DetailLevels levels(mesh);
    std::vector<std::uint32_t> hidden(levels.groups(), kNothingHidden);
    const auto coarse = drawn(levels, mesh, lenient(0.05), hidden);
    hidden[levels.groups() / 2] = 3;
    const auto mixed = drawn(levels, mesh, lenient(0.05), hidden);
    EXPECT_GT(mixed.size(), coarse.size());
    EXPECT_LT(mixed.size(), mesh.triangles.size() / 2);
    EXPECT_EQ(test::unpairedEdges(meshOf(mesh, mixed)), 0);
}

TEST(DetailLevels, ASurfaceOfFewTrianglesHasNone) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), kRadius, 48, 24);
    const ShadingMesh mesh = shadingMesh(ball, cornerShading(ball));
    const DetailLevels levels(mesh);
    EXPECT_TRUE(levels.triangles().empty());
    EXPECT_EQ(drawn(levels, mesh, lenient(1), {}), mesh.triangles);
}

TEST(DetailLevels, TrianglesBetweenTwoLooksStay) {
    ShadingMesh mesh = fineBall();
    for (ShadingVertex& vertex : mesh.vertices) vertex.looks = vertex.position[2] > 1 ? 1 : 0;
    const auto isMixed = [&](const Triangle& t) {
        const auto looks = [&](int corner) { return mesh.vertices[t[static_cast<std::size_t>(corner)]].looks; };
        return looks(0) != looks(1) || looks(1) != looks(2);
    };
    const auto mixed = static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), isMixed));
    ASSERT_GT(mixed, 100U);
    const auto fewer = coarsened(mesh.vertices, mesh.triangles, 0.05F);
    EXPECT_LT(fewer.size(), mesh.triangles.size() / 4);
    EXPECT_EQ(static_cast<std::size_t>(std::count_if(fewer.begin(), fewer.end(), isMixed)), mixed);
}

class DetailLevelsInPictures : public test::RendererTest {};

TEST_F(DetailLevelsInPictures, AQuickPictureShowsTheSame) {
    // A dented ball, so that there are shadows and shades to compare.
    TriangleMesh ball = test::sphere(Vec3::Zero(), kRadius, 500, 250);
    for (Vec3f& v : ball.vertices) v *= 1 + 0.05F * std::sin(3 * v.x()) * std::cos(2 * v.y() + v.z());
    const Scene scene = test::sceneOf({test::objectOf(std::move(ball))});
    RenderSettings all = kQuick;
    all.standOff = 0;
    const Image coarse = draw(scene), fine = draw(scene, all);
    EXPECT_NE(coarse, fine);  // it did take the coarser triangles
    const ImageDifference difference = compare(coarse, fine);
    EXPECT_LT(difference.mean, 0.6);
    EXPECT_LT(difference.worstShare, 0.01);
}

}  // namespace
}  // namespace tactooth
