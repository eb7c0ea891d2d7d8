// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/detached_pieces.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <numbers>

#include "support/mesh_checks.h"
#include "support/shapes.h"
#include "tooth/file/debris.h"
#include "tooth/surface/incremental_surface.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;
constexpr double kRadius = 0.4;  // mm, of the bur

/// 3 mm wide, its top at zero.
TriangleMesh blockMesh(double height = 3) { return test::box(Vec3(-1.5, -1.5, -height), Vec3(1.5, 1.5, 0)); }

std::shared_ptr<const LayeredTooth> toothOf(TriangleMesh outer) {
    return std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(std::move(outer))));
}

Vec3 cornerOf(const TriangleMesh& mesh, std::uint32_t vertex) { return mesh.vertices[vertex].cast<double>(); }

/// A tooth and its surface under the bur.
struct Bench {
    explicit Bench(TriangleMesh outer, double voxel = kVoxel)
        : volume(toothOf(std::move(outer)), voxel), live(volume) {}

    void carve(const Pose& from, const Pose& to) { take(volume.carve(bur, from, to)); }
    void take(const CarveResult& result) {
        live.update(volume, result.changed);
        removed += total(result.removed);
    }
    [[nodiscard]] std::vector<double> removeDetached() {
        const DetachedPieces detached = volume.removeDetached();
        take(detached.carve);
        return detached.volumes;
    }
    [[nodiscard]] TriangleMesh mesh() const { return visibleMesh(*live.snapshot()).mesh; }

    RevolutionEnvelope bur = *RevolutionEnvelope::make(test::cylinder(Vec3::Zero(), kRadius, 4, 64));
    CutVolume volume;
    IncrementalSurface live;
    double removed = 0;
};

/// The shaft up, or lying along y.
Pose upright(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }
Pose lying(double x, double y, double z) {
    return {Vec3(x, y, z), Quat(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitX()))};
}

/// A groove along x, 1 mm deep, and from it an undercut toward +y up to `end`: above it hangs a ridge that is 1.1 mm
/// wide and 0.4 mm thick, held where the undercut ends, if it does.
void undercut(Bench& bench, double end) {
    bench.carve(upright(-2.5, 0, -1), upright(2.5, 0, -1));
    bench.carve(lying(-2.5, 0, -0.8), lying(end, 0, -0.8));
}

constexpr double kRidge = 3 * 1.1 * 0.4;  // mm^3

TEST(DetachedPieceSearch, ARidgeCutOffAllAroundFalls) {
    Bench bench(blockMesh());
    undercut(bench, 2.5);
    const std::vector<DetachedPiece> pieces =
        findDetachedPieces(bench.volume.bricks(), *bench.volume.tooth(), bench.volume.lattice());
    ASSERT_EQ(pieces.size(), 1U);
    const double before = bench.removed;
    const std::vector<double> detached = bench.removeDetached();
    ASSERT_EQ(detached.size(), 1U);
    // The cut is wider than the bur by a tenth of a voxel.
    EXPECT_NEAR(detached[0], kRidge, 0.05 * kRidge);
    EXPECT_NEAR(bench.removed - before, kRidge, 0.025 * kRidge);
    // The two faces that the ridge had left of the block's top and side are gone with it.
    EXPECT_EQ(test::openEdges(bench.mesh()), 0);
    EXPECT_NEAR(test::volumeOf(blockMesh()) - test::volumeOf(bench.mesh()), bench.removed, 0.003 * bench.removed);
    EXPECT_TRUE(bench.removeDetached().empty());
    EXPECT_EQ(bench.live.failures(), 0U);
}

TEST(DetachedPieceSearch, WhatABridgeHoldsStays) {
    Bench bench(blockMesh());
    undercut(bench, 0.9);  // the bur's side comes to 1.3: 0.2 mm are left
    const std::uint64_t before = bench.volume.hash();
    EXPECT_TRUE(bench.removeDetached().empty());
    EXPECT_EQ(bench.volume.hash(), before);
}

TEST(DetachedPieceSearch, WhatIsTooLargeToBeAChipStays) {
    // At 20 um the upper part of the block, cut through at half its height, has more than kMaxUnsampled bricks.
    const double height = 6;
    Bench bench(blockMesh(height), 0.02);
    bench.carve(lying(-2.5, -2, -3), lying(2.5, -2, -3));
    EXPECT_TRUE(bench.removeDetached().empty());
    // At 50 um it has not, and of two halves the larger stays.
    Bench coarse(blockMesh(height));
    coarse.carve(lying(-2.5, -2, -2.5), lying(2.5, -2, -2.5));
    const std::vector<double> detached = coarse.removeDetached();
    ASSERT_EQ(detached.size(), 1U);
    EXPECT_NEAR(detached[0], 9 * 2.1, 0.05 * 9 * 2.1);
    EXPECT_NEAR(test::volumeOf(coarse.mesh()), 9 * 3.1, 0.01 * 9 * 3.1);
    EXPECT_EQ(boundingBox(coarse.mesh()).min().z(), -height);
}

TEST(DetachedPieceSearch, ABodyThatWasNeverPartOfTheRestIsNotLoose) {
    TriangleMesh two = blockMesh();
    const TriangleMesh chip = test::box(Vec3(-0.3, 1.6, -0.3), Vec3(0.3, 2.0, 0));
    const auto first = static_cast<std::uint32_t>(two.vertices.size());
    two.vertices.insert(two.vertices.end(), chip.vertices.begin(), chip.vertices.end());
    for (const Triangle& t : chip.triangles) two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    Bench bench(two);
    bench.carve(upright(-2.5, 1.55, -0.1), upright(2.5, 1.55, -0.1));  // along both
    EXPECT_TRUE(bench.removeDetached().empty());
    EXPECT_EQ(boundingBox(bench.mesh()).max().y(), 2.0F);
}

TEST(DetachedPieceSearch, UndoBringsThePieceBackBitForBit) {
    Bench bench(blockMesh());
    undercut(bench, 2.5);
    const std::uint64_t before = bench.volume.hash();
    ASSERT_TRUE(bench.volume.mark());
    ASSERT_EQ(bench.removeDetached().size(), 1U);
    EXPECT_NE(bench.volume.hash(), before);
    bench.live.update(bench.volume, bench.volume.undo());
    EXPECT_EQ(bench.volume.hash(), before);
    EXPECT_EQ(test::openEdges(bench.mesh()), 0);
}

TEST(DetachedPieceSearch, EqualForAnyNumberOfThreads) {
    const auto run = [](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        Bench bench(blockMesh());
        undercut(bench, 2.5);
        (void)bench.removeDetached();
        return std::pair(bench.volume.hash(), bench.removed);
    };
    EXPECT_EQ(run(1), run(4));
}

TEST(DetachedPieceSearch, ABurGoesOnWhereAPieceFell) {
    Bench bench(blockMesh());
    undercut(bench, 2.5);
    (void)bench.removeDetached();
    const double before = bench.removed;
    bench.carve(upright(-2.5, 0.9, -0.2), upright(2.5, 0.9, -0.2));  // through the ridge that is no more
    EXPECT_NEAR(bench.removed, before, 1e-4);
    bench.carve(upright(-2.5, 0.9, -1.5), upright(2.5, 0.9, -1.5));
    EXPECT_NEAR(bench.removed - before, 3 * 0.8 * 0.3, 0.02);
    EXPECT_EQ(test::openEdges(bench.mesh()), 0);
}

/// A film above a bur that lies right under the block's top, 15 um thick and 0.1 mm wide: the nodes below it are
/// removed, and those above are in the air.
TEST(Debris, AFilmThinnerThanAVoxelGoesToo) {
    Bench bench(blockMesh());
    constexpr double kClearance = kDefaultClearance * kVoxel;
    const double deep = -kRadius - kClearance - 0.015;
    bench.carve(lying(0, -1, deep), lying(0, -1, deep));
    const double beside = kRadius + kClearance + 0.05;
    for (const double x : {-beside, beside}) bench.carve(upright(x, -2.5, -0.6), upright(x, 2.5, -0.6));
    bench.carve(upright(-2.5, -1.2, -0.6), upright(2.5, -1.2, -0.6));
    EXPECT_TRUE(bench.removeDetached().empty());
    EXPECT_EQ(boundingBox(bench.mesh()).max().z(), 0);
    const auto inTheFilm = [&] {
        const TriangleMesh mesh = bench.mesh();
        return std::ranges::count_if(mesh.triangles, [&](const Triangle& t) {
            const Vec3 middle = (cornerOf(mesh, t[0]) + cornerOf(mesh, t[1]) + cornerOf(mesh, t[2])) / 3;
            return std::abs(middle.x()) < 0.06 && middle.y() > -0.7 && middle.z() > -0.05;
        });
    };
    EXPECT_GT(inTheFilm(), 100);
    const auto debris = [&] {
        return nodesBesideDebris(*bench.live.snapshot(), bench.volume.bricks(), bench.volume.lattice());
    };
    const double before = test::volumeOf(bench.mesh());
    bench.take(bench.volume.removeDebris(debris()));
    EXPECT_EQ(inTheFilm(), 0);
    EXPECT_TRUE(debris().empty());
    constexpr double kFilm = 0.1 * 2.3 * (0.015 + 0.001);  // the round bur leaves 1 um more on average
    EXPECT_NEAR(before - test::volumeOf(bench.mesh()), kFilm, 0.03 * kFilm);
    EXPECT_EQ(test::openEdges(bench.mesh()), 0);
    EXPECT_NEAR(test::volumeOf(blockMesh()) - test::volumeOf(bench.mesh()), bench.removed, 0.003 * bench.removed);
}

TEST(Debris, AWholeToothHasNone) {
    Bench bench(blockMesh());
    undercut(bench, 0.9);
    EXPECT_TRUE(nodesBesideDebris(*bench.live.snapshot(), bench.volume.bricks(), bench.volume.lattice()).empty());
}

}  // namespace
}  // namespace tactooth
