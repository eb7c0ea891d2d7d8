// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/ten_patches.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/mesh/mesh_report.h"
#include "instruments/mesh_checks.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

/// Distance of the lowest point of `tool` at `pose` above the patches, mm; negative inside.
double clearance(const TenPatches& piece, const TriangleMesh& tool, const Pose& pose) {
    double least = 1e30;
    for (const Vec3f& v : tool.vertices) {
        for (const HalfSpace& space : piece.freeSpace) {
            least = std::min(least, space.normal.dot(pose * v.cast<double>()) - space.offset);
        }
    }
    return least;
}

TEST(TenPatches, IsOneClosedBlockThatDoesNotCutItself) {
    const MeshReport report = reportOn(makeTenPatches().surface);
    EXPECT_TRUE(report.watertight());
    EXPECT_EQ(report.shells.size(), 1U);
    EXPECT_GT(report.signedVolume, 200);
    EXPECT_EQ(report.flatTriangles, 0U);
    EXPECT_FALSE(test::selfIntersects(makeTenPatches().surface));
}

TEST(TenPatches, EveryPatchLiesInItsPlaneAndUnderNoOther) {
    const TenPatches piece = makeTenPatches();
    constexpr double kFloat = 5e-7;  // mm: what single precision leaves of coordinates up to 8 mm
    for (std::size_t i = 0; i < TenPatches::kPatches; ++i) {
        ASSERT_LT(piece.first[i], piece.behind[i]) << "patch " << i;
        for (std::uint32_t t = piece.first[i]; t < piece.behind[i]; ++t) {
            EXPECT_GT(piece.surface.areaVector(t).normalized().dot(piece.freeSpace[i].normal), 1 - 1e-9);
            for (int corner = 0; corner < 3; ++corner) {
                const Vec3 p = piece.surface.corner(t, corner);
                EXPECT_NEAR(piece.freeSpace[i].normal.dot(p), piece.freeSpace[i].offset, kFloat);
                for (const HalfSpace& space : piece.freeSpace) EXPECT_GE(space.normal.dot(p), space.offset - kFloat);
            }
        }
    }
}

TEST(TenPatches, PlacesTouchOneTwoAndThreePatches) {
    const TenPatches piece = makeTenPatches();
    const auto touched = [&](const Vec3& p) {
        return std::ranges::count_if(piece.freeSpace,
                                     [&](const HalfSpace& s) { return std::abs(s.normal.dot(p) - s.offset) < 1e-12; });
    };
    EXPECT_EQ(touched(piece.a), 1);
    EXPECT_EQ(touched(piece.b), 2);
    EXPECT_EQ(touched(piece.c), 3);
}

TEST(TenPatches, FreeHandStaysWhereItIs) {
    const Pose hand{Vec3(0.3, -0.2, 3), Quat::Identity()};
    EXPECT_EQ(nearestFreeTip(makeTenPatches(), test::sphere(Vec3(0, 0, 0.7), 0.7, 16, 8), hand), hand.position);
}

TEST(TenPatches, BallOverOnePatchGivesWayAlongItsNormal) {
    const TenPatches piece = makeTenPatches();
    const TriangleMesh point = test::box(Vec3::Zero(), Vec3(1e-3, 1e-3, 1e-3));
    const Vec3 hand = piece.a - 0.2 * piece.freeSpace[0].normal;
    const Vec3 lowest(1e-3, 1e-3, 0);  // the corner of the little box that meets the patch
    const double depth = 0.2 - piece.freeSpace[0].normal.dot(lowest);
    EXPECT_LT(
        (nearestFreeTip(piece, point, {hand, Quat::Identity()}) - hand - depth * piece.freeSpace[0].normal).norm(),
        1e-9);
}

TEST(TenPatches, NoFreePlaceIsNearer) {
    const TenPatches piece = makeTenPatches();
    const TriangleMesh ball = test::sphere(Vec3(0, 0, 0.7), 0.7, 16, 8);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(-1.5, 1.5);
    std::uniform_real_distribution<double> share(-1, 1);
    for (int i = 0; i < 200; ++i) {
        const Pose hand{Vec3(side(random), side(random), 0.3 * side(random)), Quat::Identity()};
        const Vec3 tip = nearestFreeTip(piece, ball, hand);
        const double depth = (tip - hand.position).norm();
        EXPECT_GT(clearance(piece, ball, {tip, hand.rotation}), -1e-6);
        if (depth == 0) continue;
        EXPECT_NEAR(clearance(piece, ball, {tip, hand.rotation}), 0, 1e-6);
        for (int k = 0; k < 50; ++k) {  // of all positions a little closer to the device, none is free
            const Vec3 aside(share(random), share(random), share(random));
            const Vec3 nearer = tip + 0.05 * depth * aside;
            if ((nearer - hand.position).norm() > depth - 1e-6) continue;
            EXPECT_LT(clearance(piece, ball, {nearer, hand.rotation}), 0);
        }
    }
}

}  // namespace
}  // namespace tactooth
