// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// From 1 cm/s to 1 m/s at 1 kHz: while the tool touches, presses, slides and leaves, the depth is exact at every tick.
#include "collision/fast_motion.h"

#include <gtest/gtest.h>

#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

void expectExact(const test::SpeedReport& verdict) {
    EXPECT_EQ(verdict.wrong, 0) << "of " << verdict.ticks << " ticks, first " << verdict.firstWrong << ", worst "
                                << verdict.worst << " mm";
    EXPECT_EQ(verdict.intersecting, 0);
    EXPECT_GT(verdict.touching, verdict.ticks / 4);
}

void pressAt(Vec3 TenPatches::*place, double speed) {
    const TenPatches piece = makeTenPatches();
    for (std::size_t tool = 0; tool < 2; ++tool) {
        SCOPED_TRACE(test::oracleTools()[tool].name);
        expectExact(test::checkOverPatches(piece, test::oracleTools()[tool].mesh, piece.*place, speed));
    }
}

class FastMotion : public ::testing::TestWithParam<double> {};

std::string speedName(const ::testing::TestParamInfo<double>& speed) {
    return std::to_string(static_cast<int>(speed.param)) + "MmPerSecond";
}

}  // namespace

TEST_P(FastMotion, OnOneOfTenPatchesIsExact) { pressAt(&TenPatches::a, GetParam()); }

TEST_P(FastMotion, OnTheValleyLineOfTenPatchesIsExact) { pressAt(&TenPatches::b, GetParam()); }

TEST_P(FastMotion, InTheLowestCornerOfTenPatchesIsExact) { pressAt(&TenPatches::c, GetParam()); }

TEST_P(FastMotion, OverCuspsAndFissuresIsExact) {
    for (const test::NamedMesh& tooth : test::oracleTeeth()) {
        SCOPED_TRACE(tooth.name);
        const int strokes = test::fewStrokes(GetParam());
        expectExact(test::checkOverTooth(tooth.mesh, test::oracleTools()[0].mesh, GetParam(), strokes, 20));
    }
}

// A rotation of a pressed tool pushes it away from the tooth, sometimes beyond its neighbour list. The rotation is
// completed nevertheless.
TEST(FastMotion, CompletesTheRotationOfAPressedToolInEveryTick) {
    ToolTrajectory path;
    path.stroke = 3;
    path.strokes = 12;
    for (const test::NamedMesh& tooth : test::oracleTeeth()) {
        SCOPED_TRACE(tooth.name);
        const std::vector<Pose> hands = toolTrajectory(tooth.mesh, path);
        ProxySolver body(test::toolOf(test::oracleTools()[0].mesh));
        body.setSurface(test::surfaceOf(tooth.mesh));
        body.placeAt(hands.front());
        int touching = 0;
        int behind = 0;
        for (const Pose& hand : hands) {
            touching += body.moveToward(hand).contactCount > 0 ? 1 : 0;
            behind += body.pose().rotation.isApprox(hand.rotation, 1e-12) ? 0 : 1;
        }
        EXPECT_GT(touching, 1000);
        EXPECT_EQ(behind, 0) << "of " << hands.size();
    }
}

// A wall of a tenth of a millimetre: wherever the device goes, every point of the tool stays on its side.
TEST_P(FastMotion, NeverPullsAToolThroughAThinWall) {
    const TriangleMesh wall = test::box(Vec3(-20, -20, -0.1), Vec3(20, 20, 0));
    for (const TriangleMesh& tool : {test::oracleTools()[1].mesh, test::sphere(Vec3::Zero(), 0.02, 8, 4)}) {
        ProxySolver body(test::toolOf(tool));
        body.setSurface(test::surfaceOf(wall));
        std::mt19937 random(77);
        std::uniform_real_distribution<double> unit(-1, 1);
        Pose hand{Vec3(0, 0, 2), Quat::Identity()};
        body.placeAt(hand);
        Vec3 displacement = -Vec3::UnitZ();
        int beyond = 0;
        for (int tick = 0; tick < 2000; ++tick) {
            if (tick % 7 == 6) {  // a new direction, toward the wall if the device is far from it
                const double x = unit(random);
                const double y = unit(random);
                displacement =
                    Vec3(x, y, std::abs(hand.position.z()) > 3 ? (hand.position.z() > 0 ? -1 : 1) : unit(random));
                displacement = (displacement - 0.1 * Vec3(hand.position.x(), hand.position.y(), 0)).normalized();
            }
            hand.position += GetParam() * test::kTick * displacement;
            body.moveToward(hand);
            beyond += hand.position.z() < -0.1 ? 1 : 0;
            for (const Vec3f& vertex : tool.vertices) ASSERT_GT((body.pose() * vertex.cast<double>()).z(), 0) << tick;
        }
        if (GetParam() > 200) {
            EXPECT_GT(beyond, 300);
        }
    }
}

// A fissure of 20 degrees: two planes, so the free space of the tool's tip is a wedge, and its nearest point is known
// in closed form.
TEST_P(FastMotion, InANarrowFissureIsExact) {
    TriangleMesh fissure;
    const double slope = 5.671281819617709;  // tan 80 degrees
    const auto top = static_cast<float>(5 * slope);
    fissure.vertices = {{0, -20, 0}, {0, 20, 0}, {5, 20, top}, {5, -20, top}, {-5, 20, top}, {-5, -20, top}};
    fissure.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {0, 4, 5}};
    const TriangleMesh tool = test::sphere(Vec3::Zero(), 0.25, 16, 8);
    const double steep = top / 5.0;
    std::vector<HalfSpace> free;
    for (const double side : {-1.0, 1.0}) {
        const Vec3 normal = Vec3(side * steep, 0, 1).normalized();
        double lowest = 0;
        for (const Vec3f& v : tool.vertices) lowest = std::min(lowest, normal.dot(v.cast<double>()));
        free.push_back({normal, -lowest});
    }
    ProxySolver body(test::toolOf(tool));
    body.setSurface(test::surfaceOf(fissure, false));
    std::vector<Pose> path = test::pathOver(Vec3(0, 0, 2.2), GetParam());
    body.placeAt({Vec3(0, 0, 4), Quat::Identity()});
    for (Pose& hand : path) {
        hand.rotation = Quat::Identity();
        body.moveToward(hand);
        const Qp3Result exact = solveQp3(free, hand.position, 1e-12);
        ASSERT_TRUE(exact.feasible);
        const double depth = (exact.point - hand.position).norm();
        EXPECT_NEAR((body.pose().position - hand.position).norm(), depth, test::kExactEnough);
    }
}

INSTANTIATE_TEST_SUITE_P(AtEverySpeed, FastMotion, ::testing::ValuesIn(test::kTipSpeeds), speedName);

}  // namespace tactooth
