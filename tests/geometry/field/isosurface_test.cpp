// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/field/isosurface.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/field/cell_patches.h"
#include "support/mesh_checks.h"

namespace tactooth {
namespace {

const Box3 kBox(Vec3(-2, -2, -2), Vec3(2, 2, 2));

double ball(const Vec3& p) { return (p - Vec3(0.03, -0.11, 0.07)).norm() - 1.5; }

double ring(const Vec3& p) { return std::hypot(std::hypot(p.x(), p.y()) - 1.2, p.z()) - 0.5; }

/// Vertices - edges + faces: 2 for a ball, 0 for a ring.
int eulerNumber(const TriangleMesh& mesh) {
    return static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size() / 2);
}

TEST(Isosurface, BallIsClosedRoundAndOfItsVolume) {
    const TriangleMesh mesh = isosurface(ball, kBox, {.cellSize = 0.1});
    EXPECT_EQ(test::unpairedEdges(mesh), 0);
    EXPECT_EQ(eulerNumber(mesh), 2);
    for (const Vec3f& vertex : mesh.vertices) EXPECT_NEAR(ball(vertex.cast<double>()), 0, 1e-5);
    const double exact = 4.0 / 3 * std::numbers::pi * 1.5 * 1.5 * 1.5;
    EXPECT_NEAR(test::volumeOf(mesh), exact, 0.003 * exact);
}

TEST(Isosurface, VolumeErrorFallsWithTheSquareOfTheCell) {
    const double exact = 4.0 / 3 * std::numbers::pi * 1.5 * 1.5 * 1.5;
    const double coarse = exact - test::volumeOf(isosurface(ball, kBox, {.cellSize = 0.2}));
    const double fine = exact - test::volumeOf(isosurface(ball, kBox, {.cellSize = 0.1}));
    EXPECT_NEAR(coarse / fine, 4, 0.6);
}

TEST(Isosurface, RingHasOneHandle) {
    const TriangleMesh mesh = isosurface(ring, kBox, {.cellSize = 0.1});
    EXPECT_EQ(test::unpairedEdges(mesh), 0);
    EXPECT_EQ(eulerNumber(mesh), 0);
}

/// Random signs at every grid point: every kind of cell and of ambiguous face occurs.
double noise(const Vec3& p) {
    if (p.cwiseAbs().maxCoeff() > 1.55) return 1;
    const auto cell = (p / 0.1).array().round().cast<int>();
    std::mt19937 random(static_cast<unsigned>(cell.x() * 73856093 ^ cell.y() * 19349663 ^ cell.z() * 83492791));
    random.discard(4);
    return std::uniform_real_distribution<double>(-1, 1)(random);
}

TEST(Isosurface, IsAManifoldEvenForNoise) {
    const TriangleMesh mesh = isosurface(noise, kBox, {.cellSize = 0.1, .lipschitzBound = 1000, .relaxations = 0});
    EXPECT_GT(mesh.triangles.size(), 50000u);
    EXPECT_EQ(test::unpairedEdges(mesh), 0);
}

TEST(Isosurface, TrianglesAreWellShaped) {
    const TriangleMesh mesh = isosurface(ball, kBox, {.cellSize = 0.1});
    double worst = 1;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        double edges = 0;
        for (int k = 0; k < 3; ++k) edges += (mesh.corner(i, k) - mesh.corner(i, (k + 1) % 3)).squaredNorm();
        worst = std::min(worst, 2 * std::sqrt(3.0) * mesh.areaVector(i).norm() / edges);  // 1 for equal sides
    }
    EXPECT_GT(worst, 0.25);
}

TEST(Isosurface, SkippingFarBlocksChangesNothing) {
    const TriangleMesh skipping = isosurface(ring, kBox, {.cellSize = 0.07, .lipschitzBound = 1});
    const TriangleMesh all = isosurface(ring, kBox, {.cellSize = 0.07, .lipschitzBound = 1000});
    EXPECT_EQ(skipping.vertices.size(), all.vertices.size());
    EXPECT_EQ(skipping.triangles.size(), all.triangles.size());
    EXPECT_NEAR(test::volumeOf(skipping), test::volumeOf(all), 1e-6);
}

TEST(Isosurface, FollowsTheSurfaceOfAFieldThatClaimsToBeFar) {
    const auto steep = [](const Vec3& p) { return (p.x() > 0.3 ? 50 : 1) * ball(p); };
    const TriangleMesh mesh = isosurface(steep, kBox, {.cellSize = 0.1});
    EXPECT_EQ(test::unpairedEdges(mesh), 0);
    EXPECT_NEAR(test::volumeOf(mesh), test::volumeOf(isosurface(ball, kBox, {.cellSize = 0.1})), 1e-3);
}

TEST(Isosurface, IsTheSameOnAnyNumberOfThreads) {
    const TriangleMesh many = isosurface(ring, kBox, {.cellSize = 0.1});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const TriangleMesh single = isosurface(ring, kBox, {.cellSize = 0.1});
    EXPECT_FALSE(many.empty());
    EXPECT_TRUE(test::areBitEqual(many, single));
}

TEST(Isosurface, NothingInsideGivesAnEmptyMesh) {
    EXPECT_TRUE(isosurface([](const Vec3&) { return 5.0; }, kBox, {}).empty());
}

TEST(CellPatches, EveryCrossedEdgeHasAPatchOfAtLeastThreeEdges) {
    for (unsigned inside = 0; inside < 256; ++inside) {
        const CellPatches& patches = cellPatches(inside);
        std::array<int, 4> edges{};
        for (int edge = 0; edge < kCellEdges; ++edge) {
            const bool crossed = ((inside >> edgeCorner(edge, 0)) & 1u) != ((inside >> edgeCorner(edge, 1)) & 1u);
            EXPECT_EQ(crossed, patches.patchOfEdge[edge] >= 0);
            if (crossed) ++edges.at(patches.patchOfEdge[edge]);
        }
        for (int patch = 0; patch < patches.count; ++patch) EXPECT_GE(edges[patch], 3);
    }
}

TEST(CellPatches, OppositeInsideCornersAreKeptApart) {
    EXPECT_EQ(cellPatches(0b00000001u).count, 1);
    EXPECT_EQ(cellPatches(0b00001001u).count, 2);  // corners 0 and 3: across a face
    EXPECT_EQ(cellPatches(0b10000001u).count, 2);  // corners 0 and 7: across the cell
    EXPECT_EQ(cellPatches(0b01101001u).count, 4);  // every second corner
}

}  // namespace
}  // namespace tactooth
