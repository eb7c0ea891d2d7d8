// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/crack_weld.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/mesh_report.h"
#include "geometry/mesh/vertex_welder.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

TriangleMesh ball(double radius = 9) { return test::sphere(Vec3(0, 0, 0), radius, 48, 32); }

/// Like a file of single triangles whose corners were each moved by up to `by`, in each direction.
TriangleMesh jittered(const TriangleMesh& mesh, float by, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> move(-by, by);
    std::vector<Vec3f> corners;
    for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t vertex : t) {
            corners.push_back(mesh.vertices[vertex] + Vec3f(move(random), move(random), move(random)));
        }
    }
    return weld(corners);
}

class CrackWeldOf : public ::testing::TestWithParam<float> {};

TEST_P(CrackWeldOf, JoinsCornersThatDifferInTheirLastDigits) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        TriangleMesh mesh = jittered(ball(), GetParam(), seed);
        const std::size_t cracks = edgeBalance(mesh).odd;
        EXPECT_GT(cracks, 0u);
        const CrackWeld done = weldCracks(mesh);
        EXPECT_TRUE(edgeBalance(mesh).closed()) << seed;
        EXPECT_EQ(mesh.triangles.size(), ball().triangles.size());
        EXPECT_GT(done.moved, 0u);
        EXPECT_GT(done.tolerance, GetParam() / 4);
        EXPECT_LT(done.tolerance, 0.002);
        EXPECT_NEAR(reportOn(mesh).signedVolume, reportOn(ball()).signedVolume, 1e-2);
    }
}

INSTANTIATE_TEST_SUITE_P(Roundings, CrackWeldOf, ::testing::Values(1e-17F, 1e-15F, 1e-9F, 1e-6F, 1e-5F, 1e-4F));

TEST(CrackWeld, AValidSurfaceKeepsEveryBit) {
    TriangleMesh mesh = ball();
    EXPECT_EQ(weldCracks(mesh).moved, 0u);
    EXPECT_EQ(mesh.vertices, ball().vertices);
    EXPECT_EQ(mesh.triangles, ball().triangles);
}

TEST(CrackWeld, AHoleStaysAHole) {
    TriangleMesh mesh = ball();
    mesh.triangles.resize(mesh.triangles.size() - 20);
    const TriangleMesh before = mesh;
    EXPECT_EQ(weldCracks(mesh).moved, 0u);
    EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(CrackWeld, ASpeckFarAwayDoesNotWidenTheTolerance) {
    for (const float far : {1e2F, 1e4F, 1e6F}) {
        TriangleMesh mesh = jittered(ball(), 1e-6F, 3);
        append(mesh, test::box(Vec3(far, far, far), Vec3(far + 1, far + 1, far + 1)));
        const CrackWeld done = weldCracks(mesh);
        EXPECT_TRUE(edgeBalance(mesh).closed()) << far;
        EXPECT_LT(done.tolerance, 0.002) << far;
    }
}

TEST(CrackWeld, NoEdgeIsRemoved) {
    // Triangles of 0.4 um in a cracked surface: the usual tolerance would remove them all.
    TriangleMesh mesh = jittered(test::sphere(Vec3(0, 0, 0), 9, 48, 32), 1e-7F, 4);
    const std::size_t large = mesh.triangles.size();
    const TriangleMesh tiny = test::sphere(Vec3(20, 0, 0), 2e-4, 600, 400);
    append(mesh, tiny);
    (void)weldCracks(mesh);
    EXPECT_EQ(mesh.triangles.size(), large + tiny.triangles.size());
}

Triangle turnedBack(const Triangle& t) { return {t[0], t[2], t[1]}; }
Triangle rotated(const Triangle& t) { return {t[1], t[2], t[0]}; }

TEST(RemoveDuplicates, LeavesOneOfEqualTrianglesAndNoneOfPairsBackToBack) {
    const TriangleMesh sound = ball();
    TriangleMesh mesh = sound;
    EXPECT_EQ(removeDuplicates(mesh), 0u);
    mesh.triangles.push_back(rotated(sound.triangles[5]));
    EXPECT_EQ(removeDuplicates(mesh), 1u);
    EXPECT_EQ(mesh.triangles, sound.triangles);
    // A fin: two triangles back to back beside the ball.
    const Triangle fin = {0, 100, 200};
    mesh.triangles.push_back(fin);
    mesh.triangles.push_back(rotated(turnedBack(fin)));
    EXPECT_EQ(removeDuplicates(mesh), 2u);
    EXPECT_EQ(mesh.triangles, sound.triangles);
    // Stored forward, back and forward again: forward once.
    mesh.triangles.push_back(turnedBack(sound.triangles[7]));
    mesh.triangles.push_back(sound.triangles[7]);
    EXPECT_EQ(removeDuplicates(mesh), 2u);
    EXPECT_EQ(mesh.triangles, sound.triangles);
}

TEST(RemoveDuplicates, AWholeBodyStoredThreeTimesIsOneBody) {
    TriangleMesh mesh = ball();
    const auto once = mesh.triangles;
    for (int i = 0; i < 2; ++i) mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
    EXPECT_EQ(removeDuplicates(mesh), 2 * once.size());
    EXPECT_EQ(mesh.triangles, once);
}

TEST(RemoveDuplicates, TwoBoxesWithAWallInCommonBecomeOne) {
    TriangleMesh mesh = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    TriangleMesh mirrored = mesh;  // in the plane of that wall, which has the same diagonal
    for (Vec3f& vertex : mirrored.vertices) vertex.x() = 2 - vertex.x();
    for (Triangle& triangle : mirrored.triangles) triangle = turnedBack(triangle);
    append(mesh, mirrored);
    std::vector<Vec3f> corners;
    for (const Triangle& t : mesh.triangles) {
        for (const std::uint32_t vertex : t) corners.push_back(mesh.vertices[vertex]);
    }
    mesh = weld(corners);
    EXPECT_EQ(removeDuplicates(mesh), 4u);
    EXPECT_TRUE(edgeBalance(mesh).closed());
    EXPECT_NEAR(reportOn(mesh).signedVolume, 2, 1e-6);
}

}  // namespace
}  // namespace tactooth
