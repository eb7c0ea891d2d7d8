// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Surfaces that no tooth has, but that occur in STL files: nothing may crash, hang or become NaN, and a pose that the
// proxy takes as free must be free.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>
#include <random>

#include "collision/contact_oracle.h"
#include "collision/proxy/contact_query.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr int kMostIterations = 64;  // far above the proxy's own limit

bool isFinite(const Pose& pose) { return pose.position.allFinite() && pose.rotation.coeffs().allFinite(); }

void expectSound(const Contact& contact) {
    EXPECT_TRUE(std::isfinite(contact.depth));
    EXPECT_GE(contact.depth, 0);
    EXPECT_TRUE(contact.normal.allFinite());
    EXPECT_TRUE(contact.point.allFinite());
}

/// Runs all queries with a tool and a tooth around `centre`, `size` mm wide. Returns how often contacts held the proxy.
int stressTest(const TriangleMesh& tooth, const TriangleMesh& tool, const Vec3& centre, double size,
               bool closed = false) {
    const auto surface = test::surfaceOf(tooth, closed);
    const auto shape = test::toolOf(tool);
    const test::ExactIntersection oracle(tooth, tool);
    ContactQuery query(shape, surface);
    ProxySolver solver(shape);
    solver.setSurface(surface);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    const auto kick = [&] { return Vec3(normal(random), normal(random), normal(random)); };
    Pose device{centre + 3 * size * Vec3::UnitZ(), Quat::Identity()};
    solver.placeAt(device);
    int held = 0;
    for (int tick = 0; tick < 300; ++tick) {
        device.position += 0.1 * size * kick() - 0.05 * (device.position - centre);
        const Vec3 axis = kick();
        device.rotation =
            (Quat(Eigen::AngleAxisd(0.05 * axis.norm(), axis.normalized())) * device.rotation).normalized();
        const MoveResult result = solver.moveToward(device);
        EXPECT_TRUE(isFinite(solver.pose())) << tick;
        EXPECT_LE(result.iterations, kMostIterations);
        EXPECT_NE(result.status, MoveStatus::Overlapping) << tick;
        for (int i = 0; i < result.contactCount; ++i) {
            EXPECT_NEAR(result.contacts[i].normal.norm(), 1, 1e-9);
            EXPECT_TRUE(std::isfinite(result.contacts[i].multiplier));
        }
        EXPECT_FALSE(oracle.at(solver.pose())) << tick;
        if (tick % 10 == 0) {
            const Contact contact = query.at(device);
            expectSound(contact);
            if (!closed) {
                EXPECT_EQ(contact.touching, oracle.at(device)) << tick;
            }

            expectSound(query.deepestPairAt(device));
        }
        held += result.contactCount > 0 ? 1 : 0;
        if (::testing::Test::HasFailure()) return held;
    }
    return held;
}

TriangleMesh block() { return test::box(Vec3(-1, -1, -1), Vec3(1, 1, 0)); }
TriangleMesh smallTool() { return test::cylinder(Vec3(0, 0, 0), 0.3, 2, 9); }

}  // namespace

TEST(HostileMesh, SliversHoldTheToolLikeAnySurface) {
    TriangleMesh fan;  // a disc of needles, each 1 mm long and 10 um wide at its end, and some of 1 nm
    fan.vertices.push_back(Vec3f(0, 0, 0));
    for (int i = 0; i <= 460; ++i) {
        const double angle = 1e-2 * (i - (i % 7 == 0 ? 1 : 0)) + (i % 7 == 0 ? 1e-6 : 0);
        fan.vertices.push_back(Vec3f(Vec3(std::cos(angle), std::sin(angle), 0).cast<float>()));
    }
    for (std::uint32_t i = 1; i < 460; ++i) fan.triangles.push_back({0, i, i + 1});
    EXPECT_GT(stressTest(fan, smallTool(), Vec3(-0.3, 0.4, -0.1), 0.5), 20);
}

// So many needles meet in one point that no neighbour list has room for them all. The tool must still move through the
// air around them, and they must hold it.
TEST(HostileMesh, ADenseFanOfNeedlesHoldsAToolThatStillMoves) {
    TriangleMesh fan;
    constexpr std::uint32_t kNeedles = 460;
    fan.vertices.push_back(Vec3f(0, 0, 0));
    for (std::uint32_t i = 0; i < kNeedles; ++i) {
        const double angle = 2 * std::numbers::pi * i / kNeedles;
        fan.vertices.push_back(Vec3(std::cos(angle), std::sin(angle), 0).cast<float>());
        fan.triangles.push_back({0, i + 1, (i + 1) % kNeedles + 1});
    }
    ProxySolver solver(test::toolOf(smallTool()));
    solver.setSurface(test::surfaceOf(fan, false));
    solver.placeAt({Vec3(0.02, 0.01, 0.5), Quat::Identity()});
    for (int tick = 0; tick < 60; ++tick) solver.moveToward({Vec3(0.02, 0.01, 0.5 - 0.01 * tick), Quat::Identity()});
    EXPECT_NEAR(solver.pose().position.z(), 0, 1e-4);  // pressed 0.09 mm below the disc
    for (int tick = 0; tick < 40; ++tick) solver.moveToward({Vec3(0.02 + 0.01 * tick, 0.01, -0.09), Quat::Identity()});
    EXPECT_NEAR(solver.pose().position.x(), 0.41, 1e-4);
    for (int tick = 0; tick < 10; ++tick) solver.moveToward({Vec3(0.41, 0.01, 0.05 * tick), Quat::Identity()});
    EXPECT_EQ(solver.pose().position.z(), 0.45);
}

// Random triangles of every size, some of them needles of a tenth of a nanometre, that cross and cover each other.
TEST(HostileMesh, ARandomSoupOfTrianglesHoldsTheTool) {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> coordinate(-1, 1);
    TriangleMesh soup;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const float size = std::pow(10.0F, -4 * std::abs(coordinate(random)));
        const auto point = [&] {
            const float x = coordinate(random);
            const float y = coordinate(random);
            return Vec3f(x, y, coordinate(random));
        };
        const Vec3f place = point();
        soup.vertices.push_back(place);
        soup.vertices.push_back(place + size * point());
        soup.vertices.push_back(i % 5 == 0 ? Vec3f(place + 1e-7F * point()) : Vec3f(place + size * point()));
        soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        if (i % 7 == 0) soup.triangles.push_back({3 * i + 2, 3 * i + 1, 3 * i});
    }
    EXPECT_GT(stressTest(soup, smallTool(), Vec3(0, 0, 0), 0.8), 20);
}

// The stateless query takes a bounded number of tests on any of these. Here its processor time is checked, generously.
TEST(HostileMesh, TheStatelessDepthOfASelfIntersectingHeapComesInBoundedTime) {
    TriangleMesh heap;
    for (int i = 0; i < 60; ++i) {
        const Vec3 shift(0.03 * (i % 7), 0.05 * (i % 5), 0.02 * (i % 11));
        append(heap, test::sphere(shift, 0.8, 16, 8));
    }
    ContactQuery query(test::toolOf(smallTool()), test::surfaceOf(heap, true));
    const std::clock_t before = std::clock();
    for (int i = 0; i < 20; ++i) {
        const Contact contact = query.at({Vec3(0.02 * i, 0.01 * i, -1.5), Quat::Identity()});
        expectSound(contact);
        EXPECT_TRUE(contact.touching);
    }
    EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC, 20);
}

TEST(HostileMesh, ZeroAreaAndDuplicateTrianglesDoNotMatter) {
    TriangleMesh mesh = block();
    const std::vector<Triangle> sound = mesh.triangles;
    for (const Triangle& t : sound) {
        mesh.triangles.push_back(t);
        mesh.triangles.push_back({t[0], t[1], t[1]});
        mesh.triangles.push_back({t[2], t[2], t[2]});
    }
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back((mesh.vertices[sound[0][0]] + mesh.vertices[sound[0][1]]) / 2);
    mesh.triangles.push_back({sound[0][0], middle, sound[0][1]});
    EXPECT_GT(stressTest(mesh, smallTool(), Vec3(0, 0, 0), 0.5), 20);
    TriangleMesh tool = smallTool();
    tool.triangles.push_back({0, 0, 1});
    tool.triangles.push_back({2, 2, 2});
    EXPECT_GT(stressTest(block(), tool, Vec3(0, 0, 0), 0.5), 20);
}

TEST(HostileMesh, OnlyZeroAreaTrianglesAreStillFinite) {
    TriangleMesh dust;
    dust.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    dust.triangles = {{0, 0, 0}, {1, 1, 2}, {0, 1, 1}};
    ProxySolver solver(test::toolOf(smallTool()));
    solver.setSurface(test::surfaceOf(dust, false));
    solver.placeAt({Vec3(0, 0, 2), Quat::Identity()});
    for (int i = 0; i < 50; ++i) {
        solver.moveToward({Vec3(0.1, 0.1, 1 - 0.05 * i), Quat::Identity()});
        ASSERT_TRUE(isFinite(solver.pose()));
    }
    ContactQuery query(test::toolOf(smallTool()), test::surfaceOf(dust, false));
    expectSound(query.at({Vec3(0, 0, -0.5), Quat::Identity()}));
    expectSound(query.deepestPairAt({Vec3(0, 0, -0.5), Quat::Identity()}));
}

TEST(HostileMesh, TJunctionsAndHolesAreClosedToATool) {
    TriangleMesh mesh;  // two big triangles on one side of a line, eleven on the other, one of them missing
    mesh.vertices = {{-2, -2, 0}, {2, -2, 0}, {2, 0, 0}, {-2, 0, 0}, {0, 2, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    std::uint32_t last = 3;
    for (int i = 1; i <= 11; ++i) {
        const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(Vec3f(-2 + 4.0F * static_cast<float>(i) / 11, 0, 0));
        if (i != 6) mesh.triangles.push_back({last, next, 4});
        last = next;
    }
    EXPECT_GT(stressTest(mesh, smallTool(), Vec3(0, -0.2, 0), 0.5), 20);
}

TEST(HostileMesh, InvertedAndSelfIntersectingShells) {
    TriangleMesh inverted = block();
    for (Triangle& t : inverted.triangles) std::swap(t[1], t[2]);
    EXPECT_GT(stressTest(inverted, smallTool(), Vec3(0, 0, 0), 0.5), 20);
    TriangleMesh crossed = block();
    append(crossed, test::box(Vec3(-0.5, -2, -2), Vec3(0.5, 2, 0.2)));
    append(crossed, test::sphere(Vec3(0, 0, 0), 0.5, 12, 6));
    EXPECT_GT(stressTest(crossed, smallTool(), Vec3(0, 0, 0), 0.5, true), 20);
}

TEST(HostileMesh, AMillionMillimetresAway) {
    const Vec3 far(1e6, -1e6, 1e6);
    const TriangleMesh mesh = test::box(far - Vec3(100, 100, 100), far + Vec3(100, 100, 0));
    EXPECT_GT(stressTest(mesh, test::cylinder(Vec3(0, 0, 0), 30, 200, 9), far, 50), 20);
}

TEST(HostileMesh, OneTriangleAgainstOneTriangle) {
    TriangleMesh one;
    one.vertices = {{-2, -2, 0}, {2, -2, 0}, {0, 2, 0}};
    one.triangles = {{0, 1, 2}};
    EXPECT_GT(stressTest(one, smallTool(), Vec3(0, 0, 0), 0.5), 20);
    TriangleMesh blade;
    blade.vertices = {{0, 0, 0}, {0.2F, 0, 1}, {-0.2F, 0, 1}};
    blade.triangles = {{0, 1, 2}};
    EXPECT_GT(stressTest(one, blade, Vec3(0, 0, 0), 0.5), 20);
    EXPECT_GT(stressTest(block(), blade, Vec3(0, 0, 0), 0.5), 20);
}

TEST(HostileMesh, AnEmptyToothOrToolHoldsNothing) {
    const Pose goal{Vec3(0.1, 0, -0.5), Quat::Identity()};
    for (const auto& [tooth, tool] : {std::pair(TriangleMesh{}, smallTool()), std::pair(block(), TriangleMesh{}),
                                      std::pair(TriangleMesh{}, TriangleMesh{})}) {
        ProxySolver solver(test::toolOf(tool));
        solver.setSurface(test::surfaceOf(tooth));
        solver.placeAt({Vec3(0, 0, 3), Quat::Identity()});
        for (int i = 0; i < 20; ++i) solver.moveToward(goal);
        EXPECT_EQ(solver.pose().position, goal.position);
        ContactQuery query(test::toolOf(tool), test::surfaceOf(tooth));
        EXPECT_FALSE(query.at(goal).touching);
        EXPECT_FALSE(query.deepestPairAt(goal).touching);
    }
}

}  // namespace tactooth
