// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The proxy on whole teeth, checked by an oracle that shares no code with it.
#include <gtest/gtest.h>

#include <random>

#include "collision/contact_oracle.h"
#include "collision/proxy/contact_query.h"
#include "instruments/tool_trajectory.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

constexpr std::size_t kTeeth = test::cases<std::size_t>(3, 1);

/// One case: a tooth, a tool, and how often the poses are checked.
struct Case {
    std::size_t tooth;
    std::size_t tool;
    ToolTrajectory path;
    std::size_t touchEvery = 1;    // ticks
    std::size_t insideEvery = 25;  // ticks
};

/// Leads a proxy along a path and checks its poses. Returns the fraction of ticks with contact.
double checkAlong(const Case& what) {
    const TriangleMesh& tooth = test::oracleTeeth()[what.tooth].mesh;
    const TriangleMesh& tool = test::oracleTools()[what.tool].mesh;
    const test::Oracle oracle(tooth, tool);
    const auto surface = test::surfaceOf(tooth);
    const auto shape = test::toolOf(tool);
    const std::vector<Pose> devicePath = toolTrajectory(tooth, what.path);
    ContactQuery query(shape, surface);
    ProxySolver solver(shape);
    solver.setSurface(surface);
    const bool startsInside = !oracle.isFree(devicePath.front());
    EXPECT_EQ(startsInside, what.path.approach < 0);
    EXPECT_EQ(query.at(devicePath.front()).touching, startsInside);
    solver.placeAt(startsInside ? query.freePose() : devicePath.front());
    std::size_t held = 0;
    for (std::size_t tick = 0; tick < devicePath.size(); ++tick) {
        const MoveResult result = solver.moveToward(devicePath[tick]);
        EXPECT_NE(result.status, MoveStatus::Overlapping) << tick;
        Vec3 pushed = Vec3::Zero();
        for (int i = 0; i < result.contactCount; ++i)
            pushed += result.contacts[i].multiplier * result.contacts[i].normal;
        held += result.contactCount > 0 ? 1 : 0;
        const bool rotatesFully = solver.pose().rotation.isApprox(devicePath[tick].rotation);
        if (result.status == MoveStatus::InContact && rotatesFully) {
            EXPECT_NEAR((solver.pose().position - devicePath[tick].position - pushed).norm(), 0, 1e-3) << tick;
        }

        const bool checksTouch = tick % what.touchEvery == 0;
        if (checksTouch && oracle.touches(solver.pose())) return ADD_FAILURE() << "intersects at tick " << tick, 0;
        const bool checksInside = tick % what.insideEvery == 0 || tick + 1 == devicePath.size();
        if (checksInside && oracle.encloses(solver.pose())) return ADD_FAILURE() << "is inside at tick " << tick, 0;
    }
    EXPECT_LT((solver.pose().position - devicePath.back().position).norm(), what.path.approach < 0 ? 10 : 1e-9);
    return static_cast<double>(held) / static_cast<double>(devicePath.size());
}

ToolTrajectory pathAt(double speed, double press) {
    ToolTrajectory path;
    path.speed = speed;
    path.press = press;
    path.stroke = 3;
    path.strokes = speed > 50 ? 6 : 1;
    return path;
}

}  // namespace

TEST(MotionOracle, ACatalogueBurAtOneCentimetreASecondNeverIntersects) {
    for (std::size_t tooth = 0; tooth < kTeeth; ++tooth) EXPECT_GT(checkAlong({tooth, 0, pathAt(10, 0.3)}), 0.3);
}

TEST(MotionOracle, ACatalogueBurAtTenCentimetresASecondNeverIntersects) {
    for (std::size_t tooth = 0; tooth < kTeeth; ++tooth) EXPECT_GT(checkAlong({tooth, 1, pathAt(100, 0.5)}), 0.3);
}

TEST(MotionOracle, AFinelyMeshedBurNeverIntersects) {
    if (test::oracleTools().size() < 3) GTEST_SKIP() << "the tapered bur is not available";
    EXPECT_GT(checkAlong({2, 2, pathAt(10, 0.5), 3}), 0.3);
    EXPECT_GT(checkAlong({0, 2, pathAt(100, 0.3), 3}), 0.3);
}

TEST(MotionOracle, APathThatStartsInsideFindsAFreePoseAndContinuesFromThere) {
    for (std::size_t tooth = 0; tooth < kTeeth; ++tooth) {
        ToolTrajectory path = pathAt(100, 0.5);
        path.approach = -0.7;
        checkAlong({tooth, 1, path});
    }
}

TEST(MotionOracle, ARandomWalkOverAToothNeverIntersects) {
    const TriangleMesh& tooth = test::oracleTeeth()[2].mesh;
    const TriangleMesh& tool = test::oracleTools()[1].mesh;
    const test::Oracle oracle(tooth, tool);
    const std::vector<Pose> path = toolTrajectory(tooth, pathAt(10, 1.0));
    const Vec3 home = path[path.size() / 2].position;  // 1 mm below the surface
    for (unsigned seed = 1; seed <= test::cases(3U, 1U); ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        const auto kick = [&] { return Vec3(normal(random), normal(random), normal(random)); };
        ProxySolver solver(test::toolOf(tool));
        solver.setSurface(test::surfaceOf(tooth));
        Pose device{Vec3(home.x(), home.y(), boundingBox(tooth).max().z() + 0.2), Quat::Identity()};
        solver.placeAt(device);
        int held = 0;
        for (int tick = 0; tick < 800; ++tick) {
            const double size = tick % 100 == 99 ? 1.0 : 0.05;  // sometimes a jump
            device.position += size * kick() - 0.02 * (device.position - home);
            const Vec3 axis = kick();
            device.rotation =
                (Quat(Eigen::AngleAxisd(0.02 * axis.norm(), axis.normalized())) * device.rotation).normalized();
            const MoveResult result = solver.moveToward(device);
            ASSERT_NE(result.status, MoveStatus::Overlapping) << seed << " " << tick;
            ASSERT_FALSE(oracle.touches(solver.pose())) << seed << " " << tick;
            if (tick % 50 == 49) {
                ASSERT_FALSE(oracle.encloses(solver.pose())) << seed << " " << tick;
            }

            held += result.contactCount > 0 ? 1 : 0;
        }
        EXPECT_GT(held, 200) << seed;
    }
}

TEST(MotionOracle, APathThroughTheToothDoesNotPullTheToolThroughIt) {
    const TriangleMesh& tooth = test::oracleTeeth()[0].mesh;
    const TriangleMesh& tool = test::oracleTools()[0].mesh;
    const test::Oracle oracle(tooth, tool);
    const Box3 box = boundingBox(tooth);
    ProxySolver solver(test::toolOf(tool));
    solver.setSurface(test::surfaceOf(tooth));
    const Vec3 middle(box.center().x(), box.center().y(), box.max().z() - 5);
    for (const double speed : {0.05, 1.0, 20.0}) {  // mm a tick
        const Pose start{Vec3(middle.x(), box.min().y() - 3, middle.z()), Quat(Eigen::AngleAxisd(1.5, Vec3::UnitX()))};
        ASSERT_TRUE(oracle.isFree(start));
        solver.placeAt(start);
        Pose device = start;
        while (device.position.y() < middle.y()) {
            device.position.y() += speed;
            solver.moveToward(device);
            ASSERT_TRUE(oracle.isFree(solver.pose())) << speed;
        }
        for (int i = 0; i < 20; ++i) solver.moveToward({middle, start.rotation});
        EXPECT_LT(solver.pose().position.y(), middle.y()) << speed;
        EXPECT_TRUE(oracle.isFree(solver.pose())) << speed;
    }
}

}  // namespace tactooth
