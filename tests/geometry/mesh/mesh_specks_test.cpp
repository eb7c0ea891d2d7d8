// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_specks.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace tactooth {
namespace {

TriangleMesh ball() { return test::sphere(Vec3(1, 2, 3), 5, 24, 16); }

void addTriangle(TriangleMesh& mesh, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Typical specks of scans beside the tooth.
TriangleMesh withSpeck(int kind) {
    TriangleMesh mesh = ball();
    switch (kind) {
        case 0:  // a tiny body
            append(mesh, test::box(Vec3(60, 0, 0), Vec3(60.1, 0.1, 0.1)));
            break;
        case 1:  // two equal corners
            addTriangle(mesh, {90, 0, 0}, {90, 0, 0}, {-90, 0, 0});
            break;
        case 2:  // three corners in a line
            addTriangle(mesh, {0, 0, 0}, {0, 0, 1000}, {0, 0, 500});
            break;
        case 3:  // longer than the tooth, and almost without width
            addTriangle(mesh, {0, 0, 40}, {0, 0.001F, 40}, {0, 0, 80});
            break;
        case 4:  // all three corners one point
            addTriangle(mesh, {1e6F, 0, 0}, {1e6F, 0, 0}, {1e6F, 0, 0});
            break;
        case 5:  // several tiny bodies, before the tooth in the file
            mesh = test::sphere(Vec3(0, 0, 300), 0.1, 8, 6);
            append(mesh, test::box(Vec3(0, -200, 0), Vec3(0.05, -199.9, 0.1)));
            append(mesh, ball());
            break;
        default:
            break;
    }
    return mesh;
}

class MeshSpecks : public ::testing::TestWithParam<int> {};

TEST_P(MeshSpecks, DoNotChangeTheBox) {
    const Box3 expected = boundingBox(ball());
    EXPECT_FALSE(boundingBox(withSpeck(GetParam())).isApprox(expected));
    EXPECT_TRUE(boxExcludingSpecks(withSpeck(GetParam())).isApprox(expected));
    TriangleMesh mesh = withSpeck(GetParam());
    EXPECT_GE(dropSpecks(mesh), 1u);
    EXPECT_EQ(mesh.triangles.size(), ball().triangles.size());
    EXPECT_EQ(dropSpecks(mesh), 0u);
}

INSTANTIATE_TEST_SUITE_P(Kinds, MeshSpecks, ::testing::Range(0, 6));

TEST(MeshSpecks, VoidsAndSecondBodiesStay) {
    TriangleMesh mesh = ball();
    append(mesh, test::sphere(Vec3(1, 2, 3), 0.1, 8, 6));     // a bubble inside
    append(mesh, test::box(Vec3(20, 0, 0), Vec3(21, 1, 1)));  // a tenth as long
    mesh.triangles.push_back({0, 0, 1});                      // an empty triangle of the ball
    const TriangleMesh before = mesh;
    EXPECT_EQ(dropSpecks(mesh), 0u);
    EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(MeshSpecks, KeepsAllOfASurfaceOfIsolatedTriangles) {
    // A surface whose triangles are not connected: the largest of them is not a body with specks around it.
    TriangleMesh mesh;
    for (int i = 0; i < 500; ++i) {
        const auto x = static_cast<float>(i), size = 0.01F * static_cast<float>(1 + i % 100);
        addTriangle(mesh, {x, 0, 0}, {x + size, 0, 0}, {x, size, 0});
    }
    EXPECT_EQ(dropSpecks(mesh), 0u);
}

}  // namespace
}  // namespace tactooth
