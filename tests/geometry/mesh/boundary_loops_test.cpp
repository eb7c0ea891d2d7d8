// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/boundary_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/mesh/mesh_edges.h"
#include "geometry/mesh/mesh_repair.h"
#include "geometry/mesh/mesh_report.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

TriangleMesh ball() { return test::sphere(Vec3(1, 2, 3), 5, 24, 16); }

/// The ball without the triangles at `vertices`, whose boundaries may share corners.
TriangleMesh without(const std::vector<std::uint32_t>& triangles) {
    TriangleMesh mesh = ball();
    std::vector<Triangle> kept;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (std::ranges::find(triangles, t) == triangles.end()) kept.push_back(mesh.triangles[t]);
    }
    mesh.triangles = kept;
    return mesh;
}

bool shareOneCorner(const Triangle& a, const Triangle& b) {
    return std::ranges::count_if(a, [&](std::uint32_t v) { return std::ranges::find(b, v) != b.end(); }) == 1;
}

TEST(BoundaryLoops, HolesThatShareACornerHaveRimsOfTheirOwn) {
    const TriangleMesh whole = ball();
    int tried = 0;
    for (std::uint32_t a = 100; a < 140; ++a) {
        for (std::uint32_t b = a + 1; b < a + 60; ++b) {
            if (!shareOneCorner(whole.triangles[a], whole.triangles[b])) continue;
            std::size_t open = 0;
            const auto loops = boundaryLoops(without({a, b}), open);
            ASSERT_EQ(loops.size(), 2u);
            EXPECT_EQ(open, 0u);
            EXPECT_EQ(loops[0].size() + loops[1].size(), 6u);
            ++tried;
        }
    }
    EXPECT_GT(tried, 50);
}

TEST(BoundaryLoops, AnyHolesOfASoundSurfaceCanBeFilled) {
    std::mt19937 random(5);
    for (int round = 0; round < 100; ++round) {
        std::vector<std::uint32_t> gone;
        for (std::uint32_t i = 0; i < 3 + random() % 40; ++i)
            gone.push_back(static_cast<std::uint32_t>(random() % ball().triangles.size()));
        const RepairedMesh mended = repaired(without(gone), {.holes = HolesToFill::All});
        EXPECT_EQ(mended.report.openHoles, 0u) << round;
        EXPECT_TRUE(edgeBalance(mended.mesh).closed()) << round;
    }
}

TEST(BoundaryLoops, OfALoneTriangleThereIsNone) {
    TriangleMesh mesh;
    mesh.vertices = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)};
    mesh.triangles = {{0, 1, 2}};
    std::size_t open = 0;
    EXPECT_TRUE(boundaryLoops(mesh, open).empty());
    EXPECT_EQ(open, 1u);
}

TEST(BoundaryLoops, ThatDoNotCloseAreCounted) {
    // Two triangles that disagree: their boundaries run against each other and end.
    TriangleMesh mesh;
    mesh.vertices = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(1, 1, 0)};
    mesh.triangles = {{0, 1, 2}, {1, 2, 3}};
    std::size_t open = 0;
    const auto loops = boundaryLoops(mesh, open);
    EXPECT_GT(open, 0u);
    for (const BoundaryLoop& loop : loops) EXPECT_GE(loop.size(), 3u);
}

}  // namespace
}  // namespace tactooth
