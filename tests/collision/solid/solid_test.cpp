// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/solid/solid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "collision/bvh/closest_point.h"
#include "collision/solid/winding.h"
#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/mesh_report.h"
#include "geometry/mesh/vertex_welder.h"
#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

TriangleMesh turned(TriangleMesh mesh) {
    for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

TriangleMesh cube(double half) { return test::box(Vec3(-half, -half, -half), Vec3(half, half, half)); }

std::string wordsOf(const SolidReport& report) {
    std::string words;
    for (const ImportNote& importNote : notesOn(report, Message::verbatim("outer")))
        words += inWords(importNote) + '\n';
    return words;
}

TEST(Solid, ASoundSurfaceKeepsEveryBitAndHasNoNotes) {
    for (const TriangleMesh& mesh :
         {cube(1), test::sphere(Vec3(1, 2, 3), 5, 40, 30), test::cylinder(Vec3(0, 0, 0), 1, 5, 30)}) {
        const ExaminedSolid examined = examineSolid(mesh);
        EXPECT_TRUE(examined.report.isSolid());
        EXPECT_EQ(examined.mesh.vertices, mesh.vertices);
        EXPECT_EQ(examined.mesh.triangles, mesh.triangles);
        EXPECT_EQ(wordsOf(examined.report), "");
    }
}

/// Nested shells, any of which may face the wrong side. Inside and outside alternate from shell to shell.
class NestedShells : public ::testing::TestWithParam<int> {};

TEST_P(NestedShells, AreOrientedByTheirNesting) {
    constexpr std::array<double, 4> kHalf = {10, 7, 4, 2};
    double volume = 0;
    TriangleMesh mesh;
    for (std::size_t i = 0; i < kHalf.size(); ++i) {
        volume += (i % 2 == 0 ? 1 : -1) * std::pow(2 * kHalf[i], 3);
        append(mesh, (GetParam() >> i & 1) != 0 ? turned(cube(kHalf[i])) : cube(kHalf[i]));
    }
    // Beside them another body with a void.
    append(mesh, test::box(Vec3(20, 0, 0), Vec3(30, 10, 10)));
    append(mesh, (GetParam() & 1) != 0 ? test::sphere(Vec3(25, 5, 5), 3, 24, 16)
                                       : turned(test::sphere(Vec3(25, 5, 5), 3, 24, 16)));
    volume += 1000 - reportOn(test::sphere(Vec3(25, 5, 5), 3, 24, 16)).signedVolume;

    const ExaminedSolid examined = examineSolid(mesh);
    ASSERT_TRUE(examined.report.isSolid());
    const MeshReport report = reportOn(examined.mesh);
    EXPECT_TRUE(report.watertight());
    EXPECT_NEAR(report.signedVolume, volume, 1e-3);
    EXPECT_EQ(examined.report.voids, 3u);
    const ExaminedSolid again = examineSolid(examined.mesh);
    EXPECT_EQ(again.mesh.triangles, examined.mesh.triangles);
    EXPECT_EQ(again.report.flippedTriangles, 0u);
}

INSTANTIATE_TEST_SUITE_P(EveryMixOfTurnedOnes, NestedShells, ::testing::Range(0, 16));

TEST(Solid, TheNearestTriangleAndARayAgree) {
    TriangleMesh mesh = turned(cube(5));
    append(mesh, test::sphere(Vec3(1, 1, 1), 3, 24, 16));
    append(mesh, turned(cube(0.5)));
    const ExaminedSolid examined = examineSolid(mesh);
    ASSERT_TRUE(examined.report.isSolid());
    const SurfacePart part(examined.mesh);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-6, 6);
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 point(place(random), place(random), place(random));
        const auto hit = closestPoint(part, point);
        const Vec3 normal = examined.mesh.areaVector(hit->triangle).normalized();
        const Vec3 away = (point - hit->point).normalized();
        if (std::abs(normal.dot(away)) < 0.999) continue;  // nearest to an edge
        EXPECT_EQ(contains(part, point), normal.dot(away) < 0);
        inside += contains(part, point);
    }
    EXPECT_GT(inside, 200);
}

/// The surface of voxels: bodies may touch along edges and corners.
TriangleMesh voxelSurface(const std::vector<std::array<int, 3>>& voxels) {
    std::vector<Vec3f> corners;
    const auto isFull = [&](const std::array<int, 3>& v) { return std::ranges::find(voxels, v) != voxels.end(); };
    for (const auto& v : voxels) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {0, 1}) {
                std::array<int, 3> beside = v;
                beside[axis] += side == 1 ? 1 : -1;
                if (isFull(beside)) continue;
                const int u = (axis + 1) % 3, w = (axis + 2) % 3;
                std::array<Vec3f, 4> square;
                for (int i = 0; i < 4; ++i) {
                    Vec3f p = Eigen::Vector3i(v[0], v[1], v[2]).cast<float>();
                    p[axis] += float(side);
                    p[u] += i == 1 || i == 2 ? 1.0F : 0.0F;
                    p[w] += i >= 2 ? 1.0F : 0.0F;
                    square[side == 1 ? i : 3 - i] = p;
                }
                corners.insert(corners.end(), {square[0], square[1], square[2], square[0], square[2], square[3]});
            }
        }
    }
    return weld(corners);
}

TEST(Solid, VoxelsThatTouchAlongEdgesAreSolidInAnyOrientation) {
    const std::vector<std::vector<std::array<int, 3>>> shapes = {
        {{0, 0, 0}, {1, 1, 0}},
        {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}},
        {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}},  // a ring that touches itself
        {{0, 0, 0}, {1, 1, 1}},                                   // only in a corner
        {{0, 0, 0}, {0, 1, 1}, {1, 1, 0}},
    };
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        TriangleMesh mesh = voxelSurface(shapes[i]);
        const ExaminedSolid examined = examineSolid(mesh);
        ASSERT_TRUE(examined.report.isSolid())
            << i << ": " << flawSentence(examined.report, Message::verbatim("it")).in(Language::English);
        EXPECT_EQ(examined.mesh.triangles, mesh.triangles) << i;
        EXPECT_NEAR(reportOn(mesh).volume().value(), double(shapes[i].size()), 1e-6);
        const ExaminedSolid back = examineSolid(turned(mesh));
        EXPECT_TRUE(back.report.isSolid());
        EXPECT_NEAR(reportOn(back.mesh).signedVolume, double(shapes[i].size()), 1e-6) << i;
        const SurfacePart part(mesh);
        for (const auto& v : shapes[i]) EXPECT_TRUE(contains(part, Vec3(v[0] + 0.4, v[1] + 0.6, v[2] + 0.3)));
    }
}

/// Bodies that overlap in several ways.
TriangleMesh overlapping(int kind) {
    TriangleMesh mesh = cube(3);
    switch (kind) {
        case 0:
            append(mesh, test::sphere(Vec3(3, 0, 0), 1, 24, 16));
            break;
        case 1:  // one of them is inverted
            append(mesh, turned(test::box(Vec3(2, 2, 2), Vec3(5, 5, 5))));
            break;
        case 2:  // a rod through the body
            append(mesh, test::cylinder(Vec3(0.1, 0.2, -5), 0.5, 10, 20));
            break;
        case 3:  // the same body once more, moved by a micrometre
            append(mesh, test::box(Vec3(-2.999, -2.999, -2.999), Vec3(3.001, 3.001, 3.001)));
            break;
        case 4:  // one surface that is pushed through itself
            mesh = test::sphere(Vec3(0, 0, 0), 3, 48, 32);
            for (Vec3f& v : mesh.vertices) {
                if (v.z() > 2) v.z() -= 6.5F;
            }
            break;
        case 5:  // many that overlap
            for (int i = 1; i < 8; ++i) append(mesh, test::sphere(Vec3(0.7 * i, 0.3 * i, 0), 2, 24, 16));
            break;
        default:
            break;
    }
    return mesh;
}

class OverlappingBodies : public ::testing::TestWithParam<int> {};

TEST_P(OverlappingBodies, AreNoSolid) {
    const ExaminedSolid examined = examineSolid(overlapping(GetParam()));
    EXPECT_EQ(examined.report.flaw, SolidFlaw::Overlapping);
    EXPECT_GT(examined.report.overlap, 0.1);
    EXPECT_GT(examined.report.selfIntersectingTriangles, 0u);
    EXPECT_THAT(flawSentence(examined.report, Message::verbatim("it")).in(Language::English),
                HasSubstr("reach into each other by"));
}

INSTANTIATE_TEST_SUITE_P(Kinds, OverlappingBodies, ::testing::Range(0, 6));

TEST(Solid, AFoldBelowTheResolutionOfTheCtIsLeftAsItIs) {
    TriangleMesh mesh = test::sphere(Vec3(0, 0, 0), 3, 96, 64);
    append(mesh, test::sphere(Vec3(5.995, 0, 0), 3, 96, 64));
    const ExaminedSolid examined = examineSolid(mesh);
    EXPECT_TRUE(examined.report.isSolid())
        << flawSentence(examined.report, Message::verbatim("it")).in(Language::English);
    EXPECT_EQ(examined.mesh.triangles, mesh.triangles);
    EXPECT_THAT(wordsOf(examined.report), HasSubstr("they are left as they are"));
}

TEST(Solid, AFlawIsExplained) {
    TriangleMesh open = cube(1);
    open.triangles.pop_back();
    EXPECT_EQ(examineSolid(open).report.flaw, SolidFlaw::Open);
    EXPECT_EQ(examineSolid(open).report.openEdges, 3u);
    EXPECT_EQ(examineSolid({}).report.flaw, SolidFlaw::Empty);
    TriangleMesh flat;
    flat.vertices = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)};
    flat.triangles = {{0, 1, 2}, {0, 2, 1}};
    EXPECT_EQ(examineSolid(flat).report.flaw, SolidFlaw::Empty);
    for (const TriangleMesh& mesh : {open, TriangleMesh(), flat}) {
        EXPECT_FALSE(flawSentence(examineSolid(mesh).report, Message::verbatim("it")).in(Language::English).empty());
    }
}

TEST(Solid, ASurfaceWithOneSideIsTwisted) {
    // The projective plane with six vertices: closed, with only one side.
    TriangleMesh mesh;
    for (int i = 0; i < 6; ++i) mesh.vertices.emplace_back(std::cos(float(i)), std::sin(2 * float(i)), float(i % 3));
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                      {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
    ASSERT_EQ(edgeBalance(mesh).odd, 0u);
    const SolidFlaw flaw = examineSolid(mesh).report.flaw;
    EXPECT_TRUE(flaw == SolidFlaw::NonOrientable || flaw == SolidFlaw::SelfIntersecting);
}

TEST(Solid, OneTriangleThatFacesTheWrongSideIsFlipped) {
    for (std::size_t t = 0; t < 12; ++t) {
        TriangleMesh mesh = cube(2);
        std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
        const ExaminedSolid examined = examineSolid(mesh);
        EXPECT_TRUE(examined.report.isSolid());
        EXPECT_EQ(examined.report.flippedTriangles, 1u);
        EXPECT_NEAR(reportOn(examined.mesh).signedVolume, 64, 1e-6);
    }
}

TEST(Winding, CountsTheBodiesInFrontOfATriangle) {
    TriangleMesh mesh = cube(5);  // triangles 0 to 11
    append(mesh, cube(3));
    append(mesh, turned(cube(1)));
    const SurfacePart part(mesh);
    for (std::uint32_t t = 0; t < 12; ++t) {
        EXPECT_EQ(windingInFront(part, t), 0);
        EXPECT_EQ(windingInFront(part, 12 + t), 1);
        EXPECT_EQ(windingInFront(part, 24 + t), 1);  // faces inward: two bodies around it, minus itself
        EXPECT_NEAR(clearanceFrom(part, t, false), 2, 1e-9);
        EXPECT_NEAR(clearanceFrom(part, 12 + t, true), 2, 1e-9);
        EXPECT_TRUE(std::isinf(clearanceFrom(part, t, true)));
    }
}

TEST(Winding, AssertsThatTheTriangleAndThePlaceExist) {
    const SurfacePart part(cube(5));
    EXPECT_ASSERT((void)windingInFront(part, 12));
    EXPECT_ASSERT((void)windingInFront(part, 0, Barycentric(1, 1, 0)));
    EXPECT_ASSERT((void)clearanceFrom(part, 0, true, Barycentric(2, -1, 0)));
}

}  // namespace
}  // namespace tactooth
