// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_repair.h"

#include <gtest/gtest.h>

#include "geometry/mesh/mesh_report.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

TriangleMesh ball() { return test::sphere(Vec3(1, 2, 3), 5, 24, 16); }

TEST(MeshRepair, AValidSurfaceIsUnchanged) {
    const RepairedMesh mended = repaired(ball());
    EXPECT_EQ(mended.mesh.triangles, ball().triangles);
    EXPECT_FALSE(mended.report.changedAnything());
}

TEST(MeshRepair, TurnsTrianglesThatDisagree) {
    TriangleMesh mesh = ball();
    for (std::size_t t = 0; t < mesh.triangles.size(); t += 5) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    const RepairedMesh mended = repaired(mesh);
    EXPECT_TRUE(reportOn(mended.mesh).watertight());
    EXPECT_GT(reportOn(mended.mesh).signedVolume, 0);
    EXPECT_EQ(mended.report.flippedTriangles, (mesh.triangles.size() + 4) / 5);
}

TEST(MeshRepair, TurnsTheWholeOutward) {
    TriangleMesh mesh = ball();
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
    EXPECT_NEAR(reportOn(repaired(mesh).mesh).signedVolume, reportOn(ball()).signedVolume, 1e-9);
}

TEST(MeshRepair, LeavesTheWallOfAVoid) {
    TriangleMesh hollow = test::sphere(Vec3(1, 2, 3), 2, 12, 8);
    for (Triangle& triangle : hollow.triangles) std::swap(triangle[0], triangle[1]);
    TriangleMesh mesh = ball();
    append(mesh, hollow);
    EXPECT_FALSE(repaired(mesh).report.changedAnything());
}

TEST(MeshRepair, FillsSmallHolesOnly) {
    // The boundary of one triangle is a tenth of the diagonal.
    TriangleMesh mesh = test::sphere(Vec3(1, 2, 3), 5, 48, 32);
    mesh.triangles.erase(mesh.triangles.begin() + 200);
    const RepairedMesh mended = repaired(mesh);
    EXPECT_EQ(mended.report.filledHoles, 1u);
    EXPECT_TRUE(reportOn(mended.mesh).watertight());
    TriangleMesh half = ball();
    std::erase_if(half.triangles, [&](const Triangle& t) { return half.vertices[t[0]].z() < 3; });
    EXPECT_EQ(repaired(half).report.openHoles, 1u);
    const RepairedMesh all = repaired(half, {.holes = HolesToFill::All});
    EXPECT_TRUE(reportOn(all.mesh).watertight());
    EXPECT_EQ(repaired(mesh, {.holes = HolesToFill::None}).report.openHoles, 1u);
}

TEST(MeshRepair, DropsDuplicateAndEmptyTrianglesAndSpecks) {
    TriangleMesh mesh = ball();
    mesh.triangles.push_back(mesh.triangles.front());
    mesh.triangles.push_back({0, 0, 1});
    append(mesh, test::box(Vec3(9, 9, 9), Vec3(9.1, 9.1, 9.1)));
    const RepairedMesh mended = repaired(mesh);
    EXPECT_EQ(mended.report.droppedDuplicates, 1u);
    EXPECT_EQ(mended.report.droppedDegenerate, 1u);
    EXPECT_EQ(mended.report.droppedPieces, 1u);
    EXPECT_EQ(mended.mesh.triangles, ball().triangles);
}

TEST(MeshRepair, ComponentsComeLargestFirst) {
    TriangleMesh mesh = test::box(Vec3(9, 9, 9), Vec3(10, 10, 10));
    append(mesh, ball());
    const auto pieces = connectedComponents(mesh);
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_EQ(pieces[0].triangles.size(), ball().triangles.size());
    EXPECT_TRUE(reportOn(pieces[1]).watertight());
}

}  // namespace
}  // namespace tactooth
