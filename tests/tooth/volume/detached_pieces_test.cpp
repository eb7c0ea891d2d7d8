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

/// 3 mm wide, with its top at z = 0.
TriangleMesh blockMesh(double height = 3) { return test::box(Vec3(-1.5, -1.5, -height), Vec3(1.5, 1.5, 0)); }

std::shared_ptr<const LayeredTooth> toothOf(TriangleMesh outer) {
    return std::make_shared<const LayeredTooth>(std::move(*LayeredTooth::make(std::move(outer))));
}

Vec3 cornerOf(const TriangleMesh& mesh, std::uint32_t vertex) { return mesh.vertices[vertex].cast<double>(); }

/// A tooth with its volume and surface.
struct CutBlock {
    explicit CutBlock(TriangleMesh outer, double voxel = kVoxel)
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

/// The shaft upright, or along y.
Pose upright(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }
Pose lying(double x, double y, double z) {
    return {Vec3(x, y, z), Quat(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitX()))};
}

/// Cuts a groove along x, 1 mm deep, and an undercut from it toward +y up to `end`. Above it remains a ridge, 1.1 mm
/// wide and 0.4 mm thick. It is attached at the end of the undercut, if that ends in the block.
void undercut(CutBlock& cutBlock, double end) {
    cutBlock.carve(upright(-2.5, 0, -1), upright(2.5, 0, -1));
    cutBlock.carve(lying(-2.5, 0, -0.8), lying(end, 0, -0.8));
}

constexpr double kRidge = 3 * 1.1 * 0.4;  // mm^3

TEST(DetachedPieceSearch, ADetachedRidgeIsRemoved) {
    CutBlock cutBlock(blockMesh());
    undercut(cutBlock, 2.5);
    const std::vector<DetachedPiece> pieces =
        findDetachedPieces(cutBlock.volume.bricks(), *cutBlock.volume.tooth(), cutBlock.volume.lattice());
    ASSERT_EQ(pieces.size(), 1U);
    const double before = cutBlock.removed;
    const std::vector<double> detached = cutBlock.removeDetached();
    ASSERT_EQ(detached.size(), 1U);
    // The cut is wider than the bur by a tenth of a voxel.
    EXPECT_NEAR(detached[0], kRidge, 0.05 * kRidge);
    EXPECT_NEAR(cutBlock.removed - before, kRidge, 0.025 * kRidge);
    // The two faces of the ridge on the block's top and side are removed too.
    EXPECT_EQ(test::openEdges(cutBlock.mesh()), 0);
    EXPECT_NEAR(test::volumeOf(blockMesh()) - test::volumeOf(cutBlock.mesh()), cutBlock.removed,
                0.003 * cutBlock.removed);
    EXPECT_TRUE(cutBlock.removeDetached().empty());
    EXPECT_EQ(cutBlock.live.failures(), 0U);
}

TEST(DetachedPieceSearch, APieceOnABridgeStays) {
    CutBlock cutBlock(blockMesh());
    undercut(cutBlock, 0.9);  // the side of the bur reaches 1.3: 0.2 mm remain
    const std::uint64_t before = cutBlock.volume.hash();
    EXPECT_TRUE(cutBlock.removeDetached().empty());
    EXPECT_EQ(cutBlock.volume.hash(), before);
}

TEST(DetachedPieceSearch, ALargePieceStays) {
    // At 20 um the upper part of the block has more than kMaxUnsampled bricks. The block is cut through at half its
    // height.
    const double height = 6;
    CutBlock cutBlock(blockMesh(height), 0.02);
    cutBlock.carve(lying(-2.5, -2, -3), lying(2.5, -2, -3));
    EXPECT_TRUE(cutBlock.removeDetached().empty());
    // At 50 um it has fewer, and the larger one of the two halves stays.
    CutBlock coarse(blockMesh(height));
    coarse.carve(lying(-2.5, -2, -2.5), lying(2.5, -2, -2.5));
    const std::vector<double> detached = coarse.removeDetached();
    ASSERT_EQ(detached.size(), 1U);
    EXPECT_NEAR(detached[0], 9 * 2.1, 0.05 * 9 * 2.1);
    EXPECT_NEAR(test::volumeOf(coarse.mesh()), 9 * 3.1, 0.01 * 9 * 3.1);
    EXPECT_EQ(boundingBox(coarse.mesh()).min().z(), -height);
}

TEST(DetachedPieceSearch, ASeparateBodyIsNotDetached) {
    TriangleMesh two = blockMesh();
    const TriangleMesh chip = test::box(Vec3(-0.3, 1.6, -0.3), Vec3(0.3, 2.0, 0));
    const auto first = static_cast<std::uint32_t>(two.vertices.size());
    two.vertices.insert(two.vertices.end(), chip.vertices.begin(), chip.vertices.end());
    for (const Triangle& t : chip.triangles) two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    CutBlock cutBlock(two);
    cutBlock.carve(upright(-2.5, 1.55, -0.1), upright(2.5, 1.55, -0.1));  // along both sides
    EXPECT_TRUE(cutBlock.removeDetached().empty());
    EXPECT_EQ(boundingBox(cutBlock.mesh()).max().y(), 2.0F);
}

TEST(DetachedPieceSearch, UndoBringsThePieceBackBitForBit) {
    CutBlock cutBlock(blockMesh());
    undercut(cutBlock, 2.5);
    const std::uint64_t before = cutBlock.volume.hash();
    cutBlock.volume.mark();
    ASSERT_EQ(cutBlock.removeDetached().size(), 1U);
    EXPECT_NE(cutBlock.volume.hash(), before);
    cutBlock.live.update(cutBlock.volume, cutBlock.volume.undo());
    EXPECT_EQ(cutBlock.volume.hash(), before);
    EXPECT_EQ(test::openEdges(cutBlock.mesh()), 0);
}

TEST(DetachedPieceSearch, EqualForAnyNumberOfThreads) {
    const auto run = [](std::size_t threads) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        CutBlock cutBlock(blockMesh());
        undercut(cutBlock, 2.5);
        (void)cutBlock.removeDetached();
        return std::pair(cutBlock.volume.hash(), cutBlock.removed);
    };
    EXPECT_EQ(run(1), run(4));
}

TEST(DetachedPieceSearch, ABurCutsOnWhereAPieceWas) {
    CutBlock cutBlock(blockMesh());
    undercut(cutBlock, 2.5);
    (void)cutBlock.removeDetached();
    const double before = cutBlock.removed;
    cutBlock.carve(upright(-2.5, 0.9, -0.2), upright(2.5, 0.9, -0.2));  // through the removed ridge
    EXPECT_NEAR(cutBlock.removed, before, 1e-4);
    cutBlock.carve(upright(-2.5, 0.9, -1.5), upright(2.5, 0.9, -1.5));
    EXPECT_NEAR(cutBlock.removed - before, 3 * 0.8 * 0.3, 0.02);
    EXPECT_EQ(test::openEdges(cutBlock.mesh()), 0);
}

/// A film above a bur right under the block's top, 15 um thick and 0.1 mm wide. The nodes below it are removed, and
/// those above are in the air.
TEST(Debris, AFilmThinnerThanAVoxelGoesToo) {
    CutBlock cutBlock(blockMesh());
    constexpr double kClearance = kDefaultClearance * kVoxel;
    const double deep = -kRadius - kClearance - 0.015;
    cutBlock.carve(lying(0, -1, deep), lying(0, -1, deep));
    const double beside = kRadius + kClearance + 0.05;
    for (const double x : {-beside, beside}) cutBlock.carve(upright(x, -2.5, -0.6), upright(x, 2.5, -0.6));
    cutBlock.carve(upright(-2.5, -1.2, -0.6), upright(2.5, -1.2, -0.6));
    EXPECT_TRUE(cutBlock.removeDetached().empty());
    EXPECT_EQ(boundingBox(cutBlock.mesh()).max().z(), 0);
    const auto inTheFilm = [&] {
        const TriangleMesh mesh = cutBlock.mesh();
        return std::ranges::count_if(mesh.triangles, [&](const Triangle& t) {
            const Vec3 middle = (cornerOf(mesh, t[0]) + cornerOf(mesh, t[1]) + cornerOf(mesh, t[2])) / 3;
            return std::abs(middle.x()) < 0.06 && middle.y() > -0.7 && middle.z() > -0.05;
        });
    };
    EXPECT_GT(inTheFilm(), 100);
    const auto debris = [&] {
        return nodesBesideDebris(*cutBlock.live.snapshot(), cutBlock.volume.bricks(), cutBlock.volume.lattice());
    };
    const double before = test::volumeOf(cutBlock.mesh());
    cutBlock.take(cutBlock.volume.removeDebris(debris()));
    EXPECT_EQ(inTheFilm(), 0);
    EXPECT_TRUE(debris().empty());
    constexpr double kFilm = 0.1 * 2.3 * (0.015 + 0.001);  // the round bur leaves 1 um more on average
    EXPECT_NEAR(before - test::volumeOf(cutBlock.mesh()), kFilm, 0.03 * kFilm);
    EXPECT_EQ(test::openEdges(cutBlock.mesh()), 0);
    EXPECT_NEAR(test::volumeOf(blockMesh()) - test::volumeOf(cutBlock.mesh()), cutBlock.removed,
                0.003 * cutBlock.removed);
}

TEST(Debris, AWholeToothHasNone) {
    CutBlock cutBlock(blockMesh());
    undercut(cutBlock, 0.9);
    EXPECT_TRUE(
        nodesBesideDebris(*cutBlock.live.snapshot(), cutBlock.volume.bricks(), cutBlock.volume.lattice()).empty());
}

}  // namespace
}  // namespace tactooth
