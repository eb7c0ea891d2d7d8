// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TriangleMesh unitBox() { return test::box(Vec3(0, 0, 0), Vec3(1, 2, 3)); }

/// A closed ring around z: `sectors` times `sides` quads.
TriangleMesh torus(double radius, double tube, std::uint32_t sectors, std::uint32_t sides) {
    TriangleMesh mesh;
    for (std::uint32_t sector = 0; sector < sectors; ++sector) {
        const double around = 2 * std::numbers::pi * sector / sectors;
        for (std::uint32_t side = 0; side < sides; ++side) {
            const double across = 2 * std::numbers::pi * side / sides;
            const double distance = radius + tube * std::cos(across);
            mesh.vertices.push_back(
                Vec3(distance * std::cos(around), distance * std::sin(around), tube * std::sin(across)).cast<float>());
        }
    }
    for (std::uint32_t sector = 0; sector < sectors; ++sector) {
        const std::uint32_t here = sector * sides;
        const std::uint32_t there = (sector + 1) % sectors * sides;
        for (std::uint32_t side = 0; side < sides; ++side) {
            const std::uint32_t up = (side + 1) % sides;
            mesh.triangles.push_back({here + side, there + side, there + up});
            mesh.triangles.push_back({here + side, there + up, here + up});
        }
    }
    return mesh;
}

TEST(MeshReport, BoxIsSoundAndMeasuredExactly) {
    const MeshReport report = reportOn(unitBox());
    EXPECT_EQ(report.triangles, 12U);
    EXPECT_EQ(report.vertices, 8U);
    EXPECT_TRUE(report.watertight());
    EXPECT_FALSE(report.insideOut());
    EXPECT_DOUBLE_EQ(report.volume().value(), 6.0);
    EXPECT_DOUBLE_EQ(report.area, 22.0);
    EXPECT_EQ(report.eulerCharacteristic, 2);
    EXPECT_EQ(report.genus(), 0);
    EXPECT_EQ(Vec3(report.box.min()), Vec3(0, 0, 0));
    EXPECT_EQ(Vec3(report.box.max()), Vec3(1, 2, 3));
    ASSERT_EQ(report.shells.size(), 1U);
    EXPECT_EQ(report.shells[0].triangles, 12U);
    EXPECT_THAT(findings(report), IsEmpty());
}

TEST(MeshReport, VolumeFarFromTheOriginIsAsExact) {
    const MeshReport report = reportOn(test::box(Vec3(4096, -8192, 4096), Vec3(4097, -8190, 4099)));
    EXPECT_DOUBLE_EQ(report.volume().value(), 6.0);
}

TEST(MeshReport, SphereApproachesItsFormulas) {
    const double radius = 4;
    const MeshReport report = reportOn(test::sphere(Vec3(1, 2, 3), radius, 200, 100));
    EXPECT_NEAR(report.volume().value(), 4.0 / 3 * std::numbers::pi * radius * radius * radius, 0.2);
    EXPECT_NEAR(report.area, 4 * std::numbers::pi * radius * radius, 0.1);
}

TEST(MeshReport, MeasuresScaleWithTheModel) {
    const TriangleMesh mesh = torus(4, 1, 48, 24);
    const MeshReport unscaled = reportOn(mesh);
    for (const float scale : {1e-3F, 1e3F}) {
        TriangleMesh scaled = mesh;
        for (Vec3f& vertex : scaled.vertices) vertex *= scale;
        const MeshReport report = reportOn(scaled);
        EXPECT_EQ(report.flatTriangles, 0U);
        EXPECT_NEAR(report.volume().value() / std::pow(scale, 3), unscaled.volume().value(),
                    1e-5 * unscaled.signedVolume);
        EXPECT_NEAR(report.area / std::pow(scale, 2), unscaled.area, 1e-5 * unscaled.area);
    }
}

TEST(MeshReport, RingHasOneHandle) {
    const MeshReport report = reportOn(torus(4, 1, 12, 8));
    EXPECT_TRUE(report.watertight());
    EXPECT_EQ(report.eulerCharacteristic, 0);
    EXPECT_EQ(report.genus(), 1);
}

TEST(MeshReport, AMissingTriangleLeavesThreeOpenEdges) {
    TriangleMesh mesh = unitBox();
    mesh.triangles.pop_back();
    const MeshReport report = reportOn(mesh);
    EXPECT_EQ(report.boundaryEdges, 3U);
    EXPECT_FALSE(report.closed());
    EXPECT_TRUE(report.oriented());
    EXPECT_EQ(report.volume(), std::nullopt);
    EXPECT_EQ(report.genus(), std::nullopt);
    EXPECT_THAT(findings(report), ElementsAre("3 edges are open: the surface has a hole and no inside."));
}

TEST(MeshReport, ATurnedTriangleDisagreesWithItsThreeNeighbours) {
    TriangleMesh mesh = unitBox();
    std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
    const MeshReport report = reportOn(mesh);
    EXPECT_EQ(report.inconsistentEdges, 3U);
    EXPECT_TRUE(report.closed());
    EXPECT_FALSE(report.watertight());
    EXPECT_EQ(findings(report).size(), 1U);
}

TEST(MeshReport, ABoxWithAllTrianglesTurnedIsInsideOut) {
    TriangleMesh mesh = unitBox();
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    const MeshReport report = reportOn(mesh);
    EXPECT_TRUE(report.insideOut());
    EXPECT_DOUBLE_EQ(report.signedVolume, -6.0);
    EXPECT_DOUBLE_EQ(report.volume().value(), 6.0);
    EXPECT_THAT(findings(report), ElementsAre("The surface is inside out: its triangles turn clockwise."));
}

TEST(MeshReport, SeparatePiecesAreShellsLargestFirst) {
    TriangleMesh mesh = test::box(Vec3(9, 9, 9), Vec3(10, 10, 10));
    append(mesh, test::sphere(Vec3(0, 0, 0), 1, 8, 4));
    const MeshReport report = reportOn(mesh);
    ASSERT_EQ(report.shells.size(), 2U);
    EXPECT_EQ(report.shells[0].triangles, 48U);
    EXPECT_EQ(report.shells[1].triangles, 12U);
    EXPECT_DOUBLE_EQ(report.shells[1].signedVolume, 1.0);
    EXPECT_EQ(Vec3(report.shells[1].box.min()), Vec3(9, 9, 9));
    EXPECT_EQ(report.genus(), 0);
}

TEST(MeshReport, AVoidHasNegativeVolume) {
    TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(4, 4, 4));
    TriangleMesh hollow = test::box(Vec3(1, 1, 1), Vec3(3, 3, 3));
    for (Triangle& triangle : hollow.triangles) std::swap(triangle[1], triangle[2]);
    append(mesh, hollow);
    const MeshReport report = reportOn(mesh);
    EXPECT_DOUBLE_EQ(report.volume().value(), 64.0 - 8.0);
    EXPECT_DOUBLE_EQ(report.shells[1].signedVolume, -8.0);
    EXPECT_FALSE(report.insideOut());
}

TEST(MeshReport, BoxesThatShareAnEdgeAreStuckTogether) {
    TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const TriangleMesh second = test::box(Vec3(1, 1, 0), Vec3(2, 2, 1));
    // The second box shares the first one's edge from (1,1,0) to (1,1,1): its vertices 0 and 4 become 3 and 7.
    for (Triangle triangle : second.triangles) {
        for (std::uint32_t& vertex : triangle) vertex = vertex == 0 ? 3 : vertex == 4 ? 7 : vertex + 8;
        mesh.triangles.push_back(triangle);
    }
    mesh.vertices.insert(mesh.vertices.end(), second.vertices.begin(), second.vertices.end());
    const MeshReport report = reportOn(mesh);
    EXPECT_EQ(report.nonManifoldEdges, 1U);
    EXPECT_EQ(report.boundaryEdges, 0U);
    EXPECT_TRUE(report.watertight());
    EXPECT_NEAR(report.volume().value(), 2, 1e-9);
    EXPECT_EQ(report.genus(), std::nullopt);
    EXPECT_EQ(report.vertices, 14U);
    EXPECT_THAT(findings(report), ElementsAre("1 edge has four or more triangles: parts of the surface touch there."));
}

TEST(MeshReport, BoxesThatShareAPointArePinchedButTwoSoundShells) {
    TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    const TriangleMesh second = test::box(Vec3(1, 1, 1), Vec3(2, 2, 2));
    for (Triangle triangle : second.triangles) {
        for (std::uint32_t& vertex : triangle) vertex = vertex == 0 ? 7 : vertex + 8;
        mesh.triangles.push_back(triangle);
    }
    mesh.vertices.insert(mesh.vertices.end(), second.vertices.begin(), second.vertices.end());
    const MeshReport report = reportOn(mesh);
    EXPECT_EQ(report.vertices, 15U);
    EXPECT_EQ(report.pinchedVertices, 1U);
    EXPECT_EQ(report.shells.size(), 2U);
    EXPECT_EQ(report.genus(), 0);
    EXPECT_TRUE(report.watertight());
}

TEST(MeshReport, DegenerateTrianglesAreCountedAndLeaveTheTopologyAlone) {
    TriangleMesh mesh = unitBox();
    mesh.triangles.insert(mesh.triangles.begin(), Triangle{5, 5, 2});
    mesh.triangles.push_back({1, 1, 1});
    const MeshReport report = reportOn(mesh);
    EXPECT_EQ(report.triangles, 14U);
    EXPECT_EQ(report.degenerateTriangles, 2U);
    EXPECT_EQ(report.duplicateTriangles, 0U);
    EXPECT_TRUE(report.watertight());
    EXPECT_EQ(report.genus(), 0);
    EXPECT_THAT(findings(report), ElementsAre("2 triangles have two equal corners."));
}

TEST(MeshReport, CornersInALineAreFlat) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
    EXPECT_EQ(reportOn(mesh).flatTriangles, 1U);
}

TEST(MeshReport, DuplicatesAreFoundInAnyRotationAndOrientation) {
    TriangleMesh mesh = unitBox();
    const auto [a, b, c] = mesh.triangles[0];
    mesh.triangles.push_back({b, c, a});
    mesh.triangles.push_back({a, c, b});
    EXPECT_EQ(reportOn(mesh).duplicateTriangles, 2U);
}

TEST(MeshReport, AnEmptyMeshIsNotClosed) {
    const MeshReport report = reportOn(TriangleMesh{});
    EXPECT_FALSE(report.closed());
    EXPECT_EQ(report.volume(), std::nullopt);
    EXPECT_TRUE(report.box.isEmpty());
    EXPECT_TRUE(report.shells.empty());
}

TEST(MeshReport, TopologyDoesNotDependOnTheOrderOfTriangles) {
    TriangleMesh mesh = torus(4, 1, 20, 10);
    append(mesh, test::sphere(Vec3(20, 0, 0), 1, 8, 4));
    mesh.triangles.erase(mesh.triangles.begin() + 7);
    const MeshReport ordered = reportOn(mesh);
    std::mt19937 random(20260103);
    for (int round = 0; round < 20; ++round) {
        std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
        const MeshReport report = reportOn(mesh);
        EXPECT_EQ(report.boundaryEdges, ordered.boundaryEdges);
        EXPECT_EQ(report.eulerCharacteristic, ordered.eulerCharacteristic);
        ASSERT_EQ(report.shells.size(), 2U);
        EXPECT_EQ(report.shells[0].triangles, ordered.shells[0].triangles);
    }
}

}  // namespace
}  // namespace tactooth
