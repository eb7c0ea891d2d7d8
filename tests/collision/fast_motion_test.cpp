// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// From 1 cm/s to 1 m/s at 1 kHz: while the tool touches, presses, slides and leaves, the depth is exact at every tick.
#include "collision/fast_motion.h"

#include <gtest/gtest.h>

#include <random>

#include "support/shapes.h"

namespace tactooth {
namespace {

void expectExact(const test::SpeedReport& report) {
    EXPECT_EQ(report.wrong, 0) << "of " << report.ticks << " ticks, first " << report.firstWrong << ", worst "
                               << report.worst << " mm";
    EXPECT_EQ(report.intersecting, 0);
    EXPECT_GT(report.touching, report.ticks / 4);
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
    ToolTrajectory trajectory;
    trajectory.stroke = 3;
    trajectory.strokes = 12;
    for (const test::NamedMesh& tooth : test::oracleTeeth()) {
        SCOPED_TRACE(tooth.name);
        const std::vector<Pose> path = toolTrajectory(tooth.mesh, trajectory);
        ProxySolver solver(test::toolOf(test::oracleTools()[0].mesh));
        solver.setSurface(test::surfaceOf(tooth.mesh));
        solver.placeAt(path.front());
        int touching = 0;
        int behind = 0;
        for (const Pose& device : path) {
            touching += solver.moveToward(device).contactCount > 0 ? 1 : 0;
            behind += solver.pose().rotation.isApprox(device.rotation, 1e-12) ? 0 : 1;
        }
        EXPECT_GT(touching, 1000);
        EXPECT_EQ(behind, 0) << "of " << path.size();
    }
}

// A wall of a tenth of a millimetre: wherever the device goes, every point of the tool stays on its side.
TEST_P(FastMotion, NeverPullsAToolThroughAThinWall) {
    const TriangleMesh wall = test::box(Vec3(-20, -20, -0.1), Vec3(20, 20, 0));
    for (const TriangleMesh& tool : {test::oracleTools()[1].mesh, test::sphere(Vec3::Zero(), 0.02, 8, 4)}) {
        ProxySolver solver(test::toolOf(tool));
        solver.setSurface(test::surfaceOf(wall));
        std::mt19937 random(77);
        std::uniform_real_distribution<double> unit(-1, 1);
        Pose device{Vec3(0, 0, 2), Quat::Identity()};
        solver.placeAt(device);
        Vec3 displacement = -Vec3::UnitZ();
        int beyond = 0;
        for (int tick = 0; tick < 2000; ++tick) {
            if (tick % 7 == 6) {  // a new direction, toward the wall if the device is far from it
                const double x = unit(random);
                const double y = unit(random);
                displacement =
                    Vec3(x, y, std::abs(device.position.z()) > 3 ? (device.position.z() > 0 ? -1 : 1) : unit(random));
                displacement = (displacement - 0.1 * Vec3(device.position.x(), device.position.y(), 0)).normalized();
            }
            device.position += GetParam() * test::kTick * displacement;
            solver.moveToward(device);
            beyond += device.position.z() < -0.1 ? 1 : 0;
            for (const Vec3f& vertex : tool.vertices) ASSERT_GT((solver.pose() * vertex.cast<double>()).z(), 0) << tick;
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
    ProxySolver solver(test::toolOf(tool));
    solver.setSurface(test::surfaceOf(fissure, false));
    std::vector<Pose> path = test::pathOver(Vec3(0, 0, 2.2), GetParam());
    solver.placeAt({Vec3(0, 0, 4), Quat::Identity()});
    for (Pose& device : path) {
        device.rotation = Quat::Identity();
        solver.moveToward(device);
        const Qp3Result exact = solveQp3(free, device.position, 1e-12);
        ASSERT_TRUE(exact.feasible);
        const double depth = (exact.point - device.position).norm();
        EXPECT_NEAR((solver.pose().position - device.position).norm(), depth, test::kExactEnough);
    }
}

INSTANTIATE_TEST_SUITE_P(AtEverySpeed, FastMotion, ::testing::ValuesIn(test::kTipSpeeds), speedName);

}  // namespace tactooth
