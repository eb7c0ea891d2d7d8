// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Roughness that the hand would feel and that is not in the surface: the triangles themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/mesh/simplify.h"
#include "geometry/mesh/subdivide.h"
#include "haptic_path.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::kTick;

/// A part of a ball of 5 mm around its top at the origin: 9 degrees wide, one facet is 0.05 degrees.
TriangleMesh ballTop(double radius) {
    constexpr std::uint32_t kSide = 181;
    constexpr double kFacet = 0.05 * std::numbers::pi / 180;
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
        const double a = kFacet * (i % kSide - 90.0);
        const double b = kFacet * (i / kSide - 90.0);
        const Vec3 outward = Vec3(std::tan(a), std::tan(b), 1).normalized();
        mesh.vertices.push_back((radius * outward - radius * Vec3::UnitZ()).cast<float>());
    }
    mesh.triangles = test::gridTriangles(kSide);
    return mesh;
}

/// A cone on its tip, 0.4 mm wide.
TriangleMesh point() {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}};
    constexpr std::uint32_t kSides = 9;
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const double azimuth = 2 * std::numbers::pi * i / kSides;
        mesh.vertices.push_back(Vec3(0.2 * std::cos(azimuth), 0.2 * std::sin(azimuth), 0.5).cast<float>());
    }
    for (std::uint32_t i = 0; i < kSides; ++i) {
        mesh.triangles.push_back({0, (i + 1) % kSides + 1, i + 1});
        if (i > 1) mesh.triangles.push_back({1, i, i + 1});
    }
    return mesh;
}

double degreesBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

}  // namespace

TEST(SmoothForce, TheSameSurfaceWithMoreTrianglesGivesTheSameForce) {
    TriangleMesh tooth = simplified(test::oracleTeeth()[2].mesh, 9500);
    const TriangleMesh ground = tooth;
    const test::ForceStats coarse = test::forceAlong(ground, tooth, 10);
    EXPECT_GT(coarse.mean, 0.02);
    for (int level = 0; level < 2; ++level) {
        tooth = subdivided(tooth, 1);
        const test::ForceStats fine = test::forceAlong(ground, tooth, 10);
        EXPECT_NEAR(fine.mean, coarse.mean, 0.02 * coarse.mean) << tooth.triangles.size();
        EXPECT_NEAR(fine.peak, coarse.peak, 0.02 * coarse.peak) << tooth.triangles.size();
    }
}

// The force may turn as much as the ball's surface does under the device, and by 0.1 degrees more.
TEST(SmoothForce, ItsDirectionTurnsWithTheBallUnderIt) {
    constexpr double kRadius = 5;  // mm
    constexpr double kPress = 0.1;
    for (const double speed : {10.0, 50.0}) {  // mm/s
        HapticSimulation simulation = test::simulationOn(ballTop(kRadius), point(), false);
        Vec3 last = Vec3::Zero();
        const double step = speed * kTick / (kRadius - kPress);  // rad of the ball a tick
        int turns = 0;
        for (int tick = 0; tick < 100; ++tick)  // comes down beside the start of the slide
            (void)simulation.step({{Vec3(-0.3, 0.02, 0.5 - 0.006 * tick), Quat::Identity()}, 0, false}, kTick);
        for (double angle = -0.06; angle < 0.06; angle += step) {
            const Vec3 outward(std::sin(angle), 0.004 * std::cos(angle), std::cos(angle));
            const Vec3 hand = (kRadius - kPress) * outward - kRadius * Vec3::UnitZ();
            const Tick tick = simulation.step({{hand, Quat::Identity()}, 0, false}, kTick);
            ASSERT_GT(tick.contact.triangles, 0) << angle;
            if (!last.isZero()) {
                EXPECT_LE(degreesBetween(tick.contact.normal, last), step * 180 / std::numbers::pi + 0.1) << angle;
                ++turns;
            }
            last = tick.contact.normal;
        }
        EXPECT_GT(turns, 10);
    }
}

TEST(SmoothForce, ADeviceAtRestGetsNoNoise) {
    for (const test::NamedMesh& tooth : test::oracleTeeth()) {
        ToolTrajectory how;
        how.speed = 30;
        const std::vector<Pose> path = toolTrajectory(tooth.mesh, how);
        HapticSimulation simulation = test::simulationOn(tooth.mesh, test::oracleTools()[0].mesh);
        int pressed = 0;
        for (std::size_t i = 0; i < path.size(); ++i) {
            (void)simulation.step({path[i], 0, false}, kTick);
            if (i % 97 != 60) continue;
            for (int tick = 0; tick < 60; ++tick)
                (void)simulation.step({path[i], 0, false}, kTick);  // the low-passed speed decays
            const Tick first = simulation.step({path[i], 0, false}, kTick);
            pressed += first.contact.triangles > 0 ? 1 : 0;
            for (int tick = 0; tick < 300; ++tick) {
                const Tick later = simulation.step({path[i], 0, false}, kTick);
                ASSERT_LT((later.force.wrench.force - first.force.wrench.force).norm(), 1e-3) << tooth.name << " " << i;
            }
        }
        EXPECT_GT(pressed, 1) << tooth.name;
    }
}

}  // namespace tactooth
