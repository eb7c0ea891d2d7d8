// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/subdivide.h"

#include <gtest/gtest.h>

#include "geometry/mesh/mesh_report.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

double longestEdge(const TriangleMesh& mesh) {
    double longest = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int i = 0; i < 3; ++i)
            longest = std::max(longest, (mesh.corner(t, i) - mesh.corner(t, (i + 1) % 3)).norm());
    }
    return longest;
}

/// Two triangles of an open plate, and a third one on their common edge.
TriangleMesh threeOnOneEdge() {
    return {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}}, {{0, 1, 2}, {1, 3, 2}, {1, 2, 4}}};
}

TEST(Subdivide, EachTimeMakesFourOfOne) {
    const TriangleMesh box = test::box(Vec3(-1, -2, -3), Vec3(4, 5, 6));
    EXPECT_EQ(subdivided(box, 0).triangles, box.triangles);
    EXPECT_EQ(subdivided(box, 1).triangles.size(), 48U);
    EXPECT_EQ(subdivided(box, 3).triangles.size(), 768U);
}

TEST(Subdivide, KeepsTheSurface) {
    const TriangleMesh box = test::box(Vec3(-1, -2, -3), Vec3(4, 5, 6));
    for (const TriangleMesh& fine : {subdivided(box, 3), subdividedTo(box, 1000)}) {
        const MeshReport report = reportOn(fine);
        EXPECT_TRUE(report.watertight());
        EXPECT_EQ(report.pinchedVertices, 0U);
        EXPECT_EQ(report.genus(), 0);
        EXPECT_NEAR(report.signedVolume, 5 * 7 * 9, 1e-4);
        EXPECT_NEAR(report.area, 2 * (5 * 7 + 7 * 9 + 9 * 5), 1e-4);
        for (std::size_t v = 0; v < box.vertices.size(); ++v) EXPECT_EQ(fine.vertices[v], box.vertices[v]);
        for (const Vec3f& v : fine.vertices) {
            EXPECT_TRUE(v.x() == -1 || v.x() == 4 || v.y() == -2 || v.y() == 5 || v.z() == -3 || v.z() == 6) << v;
        }
    }
}

TEST(Subdivide, NewVerticesLieInTheMiddleOfOldEdges) {
    const TriangleMesh ball = test::sphere(Vec3(3, 4, 5), 2, 16, 8);
    const TriangleMesh fine = subdivided(ball, 1);
    EXPECT_EQ(fine.vertices.size(), ball.vertices.size() + ball.triangles.size() * 3 / 2);
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        const Vec3f middle = (0.5 * (ball.corner(t, 0) + ball.corner(t, 1))).cast<float>();
        EXPECT_TRUE(std::ranges::find(fine.vertices, middle) != fine.vertices.end());
    }
}

TEST(Subdivide, ReachesTheNumberOfTriangles) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 2, 16, 8);  // 224 triangles
    for (const std::size_t wanted : {225U, 300U, 1000U, 2024U, 10001U}) {
        const TriangleMesh fine = subdividedTo(ball, wanted);
        EXPECT_GE(fine.triangles.size(), wanted);
        EXPECT_LE(fine.triangles.size(), wanted + 1);
        EXPECT_TRUE(reportOn(fine).watertight());
    }
    EXPECT_EQ(subdividedTo(ball, 100).triangles, ball.triangles);
}

TEST(Subdivide, LongestEdgesGoFirst) {
    const TriangleMesh bar = test::box(Vec3::Zero(), Vec3(40, 1, 1));
    const TriangleMesh even = subdivided(bar, 4);  // 3072 triangles, all of the shape of the old ones
    EXPECT_GT(longestEdge(even), 2.4);
    EXPECT_LT(longestEdge(subdividedTo(bar, 2000)), 1.5);
}

TEST(Subdivide, EdgeOfThreeTrianglesStaysOne) {
    const MeshReport before = reportOn(threeOnOneEdge());
    const MeshReport report = reportOn(subdivided(threeOnOneEdge(), 2));
    EXPECT_EQ(report.triangles, 48U);
    EXPECT_EQ(before.nonManifoldEdges, 1U);
    EXPECT_EQ(report.nonManifoldEdges, 4U);
    EXPECT_EQ(report.boundaryEdges, 4 * before.boundaryEdges);
}

TEST(Subdivide, TriangleWithoutEdgesIsKept) {
    const TriangleMesh degenerate{{{1, 2, 3}}, {{0, 0, 0}}};
    EXPECT_EQ(subdivided(degenerate, 2).triangles, degenerate.triangles);
    EXPECT_EQ(subdividedTo(degenerate, 10).triangles, degenerate.triangles);
}

}  // namespace
}  // namespace tactooth
