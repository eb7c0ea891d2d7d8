// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/shading_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/util/pose.h"
#include "support/shapes.h"
#include "view/mesh/cluster_culling.h"

namespace tactooth {
namespace {

Vec3f positionOf(const ShadingMesh& mesh, std::uint32_t vertex) { return Vec3f(mesh.vertices[vertex].position.data()); }

TEST(ShadingMesh, EveryTriangleFindsItsPlace) {
    const TriangleMesh ball = test::sphere(Vec3(0, 1, 0), 4, 30, 20);
    const ShadingMesh mesh = shadingMesh(ball, cornerShading(ball));
    ASSERT_EQ(mesh.triangles.size(), ball.triangles.size());
    std::vector<bool> taken(ball.triangles.size());
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        const std::uint32_t place = mesh.drawIndexOfTriangle[t];
        ASSERT_FALSE(taken[place]);
        taken[place] = true;
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_EQ(positionOf(mesh, mesh.triangles[place][c]), ball.vertices[ball.triangles[t][c]]);
        }
    }
}

TEST(ShadingMesh, SmoothMeshKeepsItsVertexCountAndABoxSplitsCorners) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 4, 30, 20);
    EXPECT_EQ(shadingMesh(ball, cornerShading(ball)).vertices.size(), ball.vertices.size());
    const TriangleMesh box = test::box(Vec3::Zero(), Vec3::Ones());
    EXPECT_EQ(shadingMesh(box, cornerShading(box)).vertices.size(), 24U);
}

TEST(ShadingMesh, AppearancesReachTheVerticesOfTheirTriangles) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 4, 12, 6);
    CornerShading shading = cornerShading(ball);
    for (std::size_t corner = 0; corner < shading.appearances.size(); ++corner) {
        shading.appearances[corner] = {static_cast<SurfaceTag>(corner % 3), 7, static_cast<std::uint8_t>(corner % 5)};
    }
    const ShadingMesh mesh = shadingMesh(ball, shading);
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const ShadingVertex& vertex = mesh.vertices[mesh.triangles[mesh.drawIndexOfTriangle[t]][c]];
            EXPECT_EQ(vertex.appearances, (3 * t + c) % 3 + 256 * 7 + 65536 * ((3 * t + c) % 5));
        }
    }
}

TEST(ShadingMesh, ClustersCoverAllTrianglesOnceAndHoldThem) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 4, 60, 40);
    const ShadingMesh mesh = shadingMesh(ball, cornerShading(ball));
    std::uint32_t next = 0;
    for (const TriangleCluster& cluster : mesh.clusters) {
        EXPECT_EQ(cluster.firstTriangle, next);
        next += cluster.triangles;
        for (std::uint32_t t = cluster.firstTriangle; t < next; ++t) {
            for (const std::uint32_t vertex : mesh.triangles[t]) {
                EXPECT_LE((positionOf(mesh, vertex) - cluster.centre).norm(), cluster.radius * 1.0001F);
            }
        }
    }
    EXPECT_EQ(next, mesh.triangles.size());
}

TEST(ShadingMesh, PackedNormalsAreWithinATenthOfADegree) {
    const auto unpack = [](std::uint32_t bits, int axis) {
        const auto field = static_cast<std::int32_t>(bits << (22 - 10 * axis)) >> 22;
        return static_cast<float>(field) / 511.0F;
    };
    for (const Vec3f& normal : {Vec3f(1, 0, 0), Vec3f(0, -1, 0), Vec3f(1, -2, 3).normalized().eval()}) {
        const std::uint32_t bits = packNormal(normal);
        const Vec3f back(unpack(bits, 0), unpack(bits, 1), unpack(bits, 2));
        EXPECT_GT(back.normalized().dot(normal), std::cos(0.1F * 3.14159265F / 180));
    }
}

TEST(ClusterCulling, NeverSkipsATriangleThatShows) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 4, 160, 80);
    const ShadingMesh mesh = shadingMesh(ball, cornerShading(ball));
    Camera camera;
    camera.nearDistance = 0.5;
    for (const Vec3& eye : {Vec3(0, 0, 20), Vec3(9, 2, -3), Vec3(0, 4.3, 0.5)}) {
        camera.cameraInWorld = {eye, shortestRotation(Vec3::UnitZ(), eye)};
        const Mat4 worldToClip = projectionMatrix(camera, 1) * viewMatrix(camera);
        const ClusterCuller culler(worldToClip, Eigen::Vector4d(eye.homogeneous()), true);
        std::size_t skipped = 0;
        for (const TriangleCluster& cluster : mesh.clusters) {
            if (culler.mayBeVisible(cluster)) continue;
            ++skipped;
            for (std::uint32_t t = cluster.firstTriangle; t < cluster.firstTriangle + cluster.triangles; ++t) {
                const Vec3 a = positionOf(mesh, mesh.triangles[t][0]).cast<double>();
                const Vec3 b = positionOf(mesh, mesh.triangles[t][1]).cast<double>();
                const Vec3 c = positionOf(mesh, mesh.triangles[t][2]).cast<double>();
                const bool facesEye = (b - a).cross(c - a).dot(eye - a) > 0;
                const auto pixel = project(camera, {100, 100}, a);
                const bool inPicture = pixel && (pixel->array() >= 0).all() && (pixel->array() <= 100).all();
                ASSERT_FALSE(facesEye && inPicture);
            }
        }
        EXPECT_GT(skipped, mesh.clusters.size() / 4);
    }
}

TEST(ClusterCulling, ParallelViewSkipsTheFarSide) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 1, 160, 80);
    const ShadingMesh mesh = shadingMesh(ball, cornerShading(ball));
    Mat4 flatten = Mat4::Identity() * 0.5;
    flatten(3, 3) = 1;
    const ClusterCuller culler(flatten, Eigen::Vector4d(0, 0, 1, 0), true);
    const auto shown = static_cast<std::size_t>(std::count_if(mesh.clusters.begin(), mesh.clusters.end(),
                                                              [&](const auto& c) { return culler.mayBeVisible(c); }));
    EXPECT_GT(shown, mesh.clusters.size() * 2 / 5);
    EXPECT_LT(shown, mesh.clusters.size() * 7 / 10);
}

TEST(ClusterCulling, NeighbouringRunsAreJoined) {
    std::vector<TriangleCluster> clusters(3);
    for (std::uint32_t i = 0; i < 3; ++i) {
        clusters[i].firstTriangle = 10 * i;
        clusters[i].triangles = 10;
        clusters[i].centre = Vec3f(i == 2 ? 9.0F : 0.0F, 0, 0);
        clusters[i].radius = 0.1F;
    }
    std::vector<TriangleRange> runs;
    visibleRanges(ClusterCuller(Mat4::Identity(), Eigen::Vector4d(0, 0, 1, 0), false), clusters, runs);
    EXPECT_EQ(runs, (std::vector<TriangleRange>{{0, 20}}));
}

}  // namespace
}  // namespace tactooth
