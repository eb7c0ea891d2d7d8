// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/proxy_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "collision/proxy/proxy_fixture.h"
#include "support/exact_intersection.h"
#include "support/expect_assert.h"
#include "support/sanitizer.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::poseAt;
using test::settle;
using test::smallBox;
using test::solverAt;
using test::surfaceOf;
using test::toolOf;

/// A flat half at z = 0, and one that slopes down from x = 0 by an eighth (seen from `side`); 8 mm long and wide.
TriangleMesh edgeBetweenFlatAndSlope(float side) {
    TriangleMesh mesh;
    const float down = -side * 4.0F / 8;
    mesh.vertices = {{-4, -4, 0}, {0, -4, 0}, {0, 4, 0}, {-4, 4, 0}, {4, -4, down}, {4, 4, down}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
    return mesh;
}

}  // namespace

TEST(ProxySolver, ReachesAFreeGoal) {
    ProxySolver solver = solverAt(poseAt(0, 0, 5), toolOf(smallBox()), surfaceOf(test::floorBlock()));
    EXPECT_EQ(settle(solver, poseAt(3, -2, 1)).status, MoveStatus::Reached);
    EXPECT_EQ(solver.pose().position, Vec3(3, -2, 1));
}

TEST(ProxySolver, WithASmallBudgetContinuesInTheNextMove) {
    const auto tool = toolOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 40, 20));
    const auto bed = surfaceOf(test::sphere(Vec3(0, 0, -2), 2, 200, 120));
    const test::ExactIntersection oracle(bed->base->mesh(), tool->mesh());
    for (const Work budget : {Work{6'000}, Work{25'000}}) {
        ProxySolver limited(tool), unlimited(tool);
        limited.setBudget(budget);
        for (ProxySolver* solver : {&limited, &unlimited}) {
            solver->setSurface(bed);
            solver->placeAt(poseAt(0, 0, 0.02));
        }
        int cutShort = 0, stillInARow = 0;
        for (int tick = 1; tick <= 60; ++tick) {
            const Pose goal = poseAt(0.01 * tick, 0.002 * tick, -0.02 - 0.002 * tick);
            const Vec3 before = limited.pose().position;
            cutShort += limited.moveToward(goal).status == MoveStatus::OutOfBudget ? 1 : 0;
            stillInARow = limited.pose().position == before ? stillInARow + 1 : 0;
            EXPECT_LT(stillInARow, 5) << tick;
            EXPECT_FALSE(oracle.at(limited.pose())) << tick;
            EXPECT_EQ(settle(unlimited, goal).status, MoveStatus::InContact) << tick;
        }
        EXPECT_GT(cutShort, 5) << budget;
        const Pose rest = poseAt(0.6, 0.12, -0.14);
        EXPECT_EQ(settle(limited, rest).status, MoveStatus::InContact);
        EXPECT_NEAR((limited.pose().position - unlimited.pose().position).norm(), 0, 1e-5) << budget;
    }
}

TEST(ProxySolver, WithABudgetWaitsAFewMovesAtTheEndOfAGivenList) {
    const auto tool = toolOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 100, 60));
    const auto bed = surfaceOf(test::sphere(Vec3(0, 0, -2), 2, 300, 200));
    const Pose start = poseAt(0, 0, 0.02), far = poseAt(0.3, 0, -0.1);
    constexpr double kReach = 0.03;  // mm
    const auto given = [&](Work budget) {
        ProxySolver solver(tool);
        NeighbourList near(*tool);
        near.buildAll(*bed, start, ContactMargin{Vec3::Zero(), kReach, 0.01});
        EXPECT_GT(near.clusters(), 600U) << "else the proxy builds a list at once";
        solver.setSurface(bed);
        solver.placeAt(start);
        solver.setSurface(bed, near);
        solver.setBudget(budget);
        return solver;
    };
    ProxySolver bounded = given(1'000'000'000);
    EXPECT_EQ(bounded.moveToward(far).status, MoveStatus::OutOfBudget);
    EXPECT_EQ(bounded.ownListRebuilds(), 0U);
    EXPECT_NEAR((bounded.pose().position - start.position).norm(), kReach, 0.2 * kReach);
    for (int move = 2; move <= 8; ++move) EXPECT_EQ(bounded.moveToward(far).status, MoveStatus::OutOfBudget);
    EXPECT_EQ(bounded.ownListRebuilds(), 0U);
    EXPECT_NEAR((bounded.pose().position - start.position).norm(), kReach, 0.2 * kReach);
    for (std::uint32_t lists = 1; lists <= 3; ++lists) {
        (void)bounded.moveToward(far);
        EXPECT_EQ(bounded.ownListRebuilds(), lists) << "no list was given: it builds one in each move";
    }
    EXPECT_GT((bounded.pose().position - start.position).norm(), 1.1 * kReach);

    ProxySolver unbounded = given(kUnlimitedWork);
    EXPECT_NE(unbounded.moveToward(far).status, MoveStatus::OutOfBudget);
    EXPECT_GT(unbounded.ownListRebuilds(), 0U);
}

TEST(ProxySolver, RotatesToTheEndOfAGivenListAndWaitsThere) {
    const auto tool = toolOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 100, 60));
    const auto bed = surfaceOf(test::sphere(Vec3(0, 0, -2), 2, 300, 200));
    const Pose start = poseAt(0, 0, 0.02);
    constexpr double kTurn = 0.01;
    for (const double angle : {0.05, 0.5, 2.5}) {  // a share of a large rotation is more than that share of its chord
        ProxySolver solver(tool);
        NeighbourList near(*tool);
        near.buildAll(*bed, start, ContactMargin{Vec3::Zero(), 0.03, kTurn});
        solver.setSurface(bed);
        solver.placeAt(start);
        solver.setSurface(bed, near);
        solver.setBudget(1'000'000'000);
        const Pose turned{start.position, Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()))};
        for (int move = 1; move <= 8; ++move) {
            EXPECT_EQ(solver.moveToward(turned).status, MoveStatus::OutOfBudget);
            EXPECT_EQ(solver.ownListRebuilds(), 0U) << angle << ", move " << move;
            const double chord = chordBetween(solver.pose().rotation, start.rotation);
            EXPECT_LT(chord, kTurn);
            EXPECT_GT(chord, 0.9 * kTurn);
        }
    }
}

TEST(ProxySolver, OutsideOfALateListWaitsForTheNextOne) {
    const auto tool = toolOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 100, 60));
    const auto bed = surfaceOf(test::sphere(Vec3(0, 0, -2), 2, 300, 200));
    const Pose listed = poseAt(0, 0, 0.02), start = poseAt(0.06, 0, 0.02), far = poseAt(0.3, 0, -0.1);
    const auto listAt = [&](const Pose& pose) {
        NeighbourList near(*tool);
        near.buildAll(*bed, pose, ContactMargin{Vec3::Zero(), 0.03, 0.01});
        return near;
    };
    ProxySolver solver = solverAt(start, tool, bed);
    NeighbourList late = listAt(listed);
    solver.setSurface(bed, late);
    solver.setBudget(1'000'000'000);
    for (int move = 1; move <= 3; ++move) {
        EXPECT_EQ(solver.moveToward(far).status, MoveStatus::OutOfBudget);
        EXPECT_EQ(solver.pose().position, start.position);
    }
    EXPECT_EQ(solver.ownListRebuilds(), 0U);
    NeighbourList next = listAt(start);
    solver.setSurface(bed, next);
    (void)solver.moveToward(far);
    EXPECT_NE(solver.pose().position, start.position);
    EXPECT_EQ(solver.ownListRebuilds(), 0U);

    NeighbourList again = listAt(listed);
    ProxySolver lonely = solverAt(start, tool, bed);
    lonely.setSurface(bed, again);
    lonely.setBudget(1'000'000'000);
    for (int move = 1; move <= 8; ++move) (void)lonely.moveToward(far);
    EXPECT_EQ(lonely.ownListRebuilds(), 0U);
    (void)lonely.moveToward(far);
    EXPECT_EQ(lonely.ownListRebuilds(), 1U) << "no list was given: it builds one";
}

// A bur as long as its slot cannot rotate in it: no list would allow that.
TEST(ProxySolver, HeldByItsCavityBuildsNoListForARotation) {
    TriangleMesh long1 = test::sphere(Vec3::Zero(), 0.5, 80, 60);
    TriangleMesh long2 = test::sphere(Vec3::Zero(), 0.502, 240, 120);
    for (TriangleMesh* mesh : {&long1, &long2}) {
        for (Vec3f& vertex : mesh->vertices) vertex.x() *= 4;
    }
    const auto tool = toolOf(std::move(long1));
    const auto cavity = surfaceOf(std::move(long2));
    ProxySolver solver = solverAt(poseAt(0, 0, 0), tool, cavity);
    NeighbourList near(*tool);
    near.buildAll(*cavity, poseAt(0, 0, 0), ContactMargin{Vec3::Zero(), 0.02, 0.01});
    ASSERT_GT(near.clusters(), 600U);
    solver.setSurface(cavity, near);
    solver.setBudget(1'000'000'000);
    const Pose turned{Vec3(0.01, 0, -0.05), Quat(Eigen::AngleAxisd(0.1, Vec3::UnitZ()))};
    for (int move = 1; move <= 40; ++move) (void)solver.moveToward(turned);
    EXPECT_EQ(solver.ownListRebuilds(), 0U);
    EXPECT_LT(chordBetween(solver.pose().rotation, Quat::Identity()), 0.01);
}

// In a cavity of the bur's own shape, the proxy's own list is too long at first.
TEST(ProxySolver, WaitsForAGivenListIfItsOwnIsTooLong) {
    const auto tool = toolOf(test::sphere(Vec3::Zero(), 0.5, 60, 30));
    const auto cavity = surfaceOf(test::sphere(Vec3::Zero(), 0.502, 240, 120));
    const Pose start = poseAt(0, 0, 0), below = poseAt(0.05, 0.03, -0.1);
    const auto listOf = [&](double reach) {
        NeighbourList near(*tool);
        near.buildAll(*cavity, start, ContactMargin{Vec3::Zero(), reach, 0.01});
        return near;
    };
    ProxySolver solver = solverAt(start, tool, cavity);
    NeighbourList shortList = listOf(0.0003);
    solver.setSurface(cavity, shortList);
    solver.setBudget(1'000'000'000);
    for (int move = 0; move < 8; ++move) (void)solver.moveToward(below);
    ASSERT_EQ(solver.ownListRebuilds(), 0U) << "at the end of the list that it was given";
    Vec3 place;
    do {
        place = solver.pose().position;
        EXPECT_EQ(solver.moveToward(below).status, MoveStatus::OutOfBudget);
    } while (solver.pose().position != place);
    const std::uint32_t lists = solver.ownListRebuilds();
    EXPECT_GT(lists, 0U);
    for (int move = 1; move < 8; ++move) {
        EXPECT_EQ(solver.moveToward(below).status, MoveStatus::OutOfBudget);
        EXPECT_EQ(solver.pose().position, place);
    }
    EXPECT_EQ(solver.ownListRebuilds(), lists) << "the last list was too long, and no shorter one is built at once";
    NeighbourList longList = listOf(0.002);
    solver.setSurface(cavity, longList);
    (void)solver.moveToward(below);
    EXPECT_NE(solver.pose().position, place);
    EXPECT_EQ(solver.ownListRebuilds(), lists);
}

TEST(ProxySolver, ReturnsTheListOfTheOldSurface) {
    const auto tool = toolOf(smallBox());
    const auto low = surfaceOf(test::floorBlock());
    const auto lower = surfaceOf(test::box(Vec3(-10, -10, -1), Vec3(10, 10, -0.1)));
    const ContactMargin contactMargin{Vec3::Zero(), 0.3, 0.01};
    ProxySolver solver(tool);
    NeighbourList near(*tool);
    solver.setSurface(low);
    solver.placeAt(poseAt(0, 0, 0.2));
    near.buildAll(*low, solver.pose(), contactMargin);
    const std::size_t clusters = near.clusters();
    ASSERT_GT(clusters, 0U);
    solver.setSurface(low, near);
    near.buildAll(*lower, solver.pose(), {});
    EXPECT_EQ(solver.setSurface(lower, near), low);
    EXPECT_TRUE(near.made());
    EXPECT_EQ(near.clusters(), clusters);
    solver.setSurface(low, near);  // and back
    (void)settle(solver, poseAt(0, 0, 0.1));
    EXPECT_EQ(solver.ownListRebuilds(), 0U);
}

TEST(ProxySolver, StopsOnAPlaneAtItsMargin) {
    ProxySolver solver = solverAt(poseAt(0, 0, 2), toolOf(smallBox()), surfaceOf(test::floorBlock()));
    const MoveResult result = settle(solver, poseAt(1, 2, -0.25));
    EXPECT_EQ(result.status, MoveStatus::InContact);
    EXPECT_NEAR(solver.pose().position.x(), 1, 1e-9);
    EXPECT_NEAR(solver.pose().position.y(), 2, 1e-9);
    EXPECT_NEAR(solver.pose().position.z(), solver.margin(), solver.margin());
    ASSERT_GE(result.contactCount, 1);
    EXPECT_NEAR(result.contacts[0].normal.z(), 1, 1e-9);
}

TEST(ProxySolver, SettlesInTheCornerOfThreeWalls) {
    TriangleMesh walls = test::floorBlock();
    append(walls, test::box(Vec3(1, -10, -1), Vec3(2, 10, 10)));
    append(walls, test::box(Vec3(-10, 1, -1), Vec3(10, 2, 10)));
    ProxySolver solver = solverAt(poseAt(-3, -3, 3), toolOf(smallBox()), surfaceOf(walls));
    const MoveResult result = settle(solver, poseAt(0.8, 0.9, -0.2));
    EXPECT_EQ(result.status, MoveStatus::InContact);
    EXPECT_NEAR((solver.pose().position - Vec3(0.5, 0.5, 0)).norm(), 0, 4 * solver.margin());
    EXPECT_EQ(result.contactCount, 3);
}

TEST(ProxySolver, IsHeldInAVGrooveAtTheClosedFormHeight) {
    // Two planes at 45 degrees. An upright box 1 mm wide rests on two edges half a millimetre above the bottom.
    TriangleMesh groove;
    groove.vertices = {Vec3f(0, -10, 0), Vec3f(0, 10, 0),  Vec3f(5, 10, 5),
                       Vec3f(5, -10, 5), Vec3f(-5, 10, 5), Vec3f(-5, -10, 5)};
    groove.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {0, 4, 5}};
    ProxySolver solver = solverAt(poseAt(0.3, 0, 4), toolOf(smallBox()), surfaceOf(groove));
    settle(solver, poseAt(0.1, 0.5, 0.2));
    EXPECT_NEAR((solver.pose().position - Vec3(0, 0.5, 0.5)).norm(), 0, 2 * solver.margin());
}

// Beside a convex edge, the flat half has its own point nearest to the goal, and the slope has a nearer one. Between
// them the distance grows by less than the margin: the proxy must not stop there.
TEST(ProxySolver, DoesNotStopBesideAnEdgeThatLeadsOn) {
    constexpr double kDepth = 0.3;
    const TriangleMesh ball = test::sphere(Vec3(0, 0, 0.5), 0.5, 16, 8);
    const TriangleMesh spike = test::sphere(Vec3(0, 0, -0.5), 0.5, 16, 8);
    for (const double beside : {0.0, 1.0, 4.0, 30.0, 100.0}) {  // margins
        for (const bool isCornerOfTool : {true, false}) {
            SCOPED_TRACE(beside);
            ProxySolver solver(toolOf(isCornerOfTool ? ball : edgeBetweenFlatAndSlope(-1)));
            solver.setSurface(surfaceOf(isCornerOfTool ? edgeBetweenFlatAndSlope(1) : spike));
            const double toFlat = isCornerOfTool ? -1 : 1;
            solver.placeAt(poseAt(toFlat, 0.3, 1));
            solver.moveToward(poseAt(toFlat, 0.3, 0.5));
            const double x = beside * solver.margin();
            EXPECT_EQ(solver.moveToward(poseAt(toFlat * x, 0.3, -kDepth)).status, MoveStatus::InContact);
            const double exact = (8 * kDepth + x) / std::sqrt(65.0);
            const Vec3 goal(toFlat * x, 0.3, -kDepth);
            EXPECT_NEAR((solver.pose().position - goal).norm(), exact, 2 * solver.margin());
        }
    }
}

TEST(ProxySolver, DoesNotPassAThinWallInOneLongMove) {
    ProxySolver solver(toolOf(test::sphere(Vec3(0, 0, 0), 0.02, 16, 8)));
    solver.setSurface(surfaceOf(test::box(Vec3(-10, -10, 0), Vec3(10, 10, 0.1))));
    for (const double x : {0.0, 0.37, -3.1}) {
        solver.placeAt(poseAt(x, 0.123, 5));
        for (int i = 0; i < 100; ++i) solver.moveToward(poseAt(x, 0.123, -5));
        EXPECT_GT(solver.pose().position.z(), 0.1);
    }
}

TEST(ProxySolver, OnceSettledStaysWithoutWorkUntilGoalOrSurfaceChange) {
    ProxySolver solver(toolOf(smallBox()));
    const auto walls = surfaceOf(test::floorBlock());
    solver.setSurface(walls);
    solver.placeAt(poseAt(0, 0, 0.1));
    const MoveResult first = solver.moveToward(poseAt(0, 0, -0.2));
    const Pose held = solver.pose();
    EXPECT_GT(first.work, 0);
    const MoveResult again = solver.moveToward(poseAt(0, 0, -0.2));
    EXPECT_EQ(again.status, MoveStatus::InContact);
    EXPECT_EQ(again.work, 0);
    EXPECT_EQ(again.contactCount, first.contactCount);
    EXPECT_EQ(again.contacts[0].multiplier, first.contacts[0].multiplier);
    EXPECT_EQ(solver.pose().position, held.position);

    EXPECT_GT(solver.moveToward(poseAt(0.001, 0, -0.2)).work, 0);
    EXPECT_EQ(solver.moveToward(poseAt(0.001, 0, -0.2)).work, 0);
    solver.setSurface(surfaceOf(test::box(Vec3(-10, -10, -1), Vec3(10, 10, -0.1))));
    EXPECT_GT(solver.moveToward(poseAt(0.001, 0, -0.2)).work, 0);
    EXPECT_NEAR(solver.pose().position.z(), -0.1, 1e-6);
}

// The end of a bur on the floor that it has milled: thousands of triangles touch, and one plane separates them all. It
// need not be the plane of the pair that holds the tool.
TEST(ProxySolver, OnAFlatFloorNeedsFewGjkRuns) {
    constexpr std::uint32_t kSide = 80;
    TriangleMesh floor;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> rough(-1e-6F, 1e-6F);  // mm
    for (std::uint32_t y = 0; y <= kSide; ++y) {
        for (std::uint32_t x = 0; x <= kSide; ++x) {
            const auto place = [](std::uint32_t i) { return 0.025F * static_cast<float>(i) - 1; };
            floor.vertices.emplace_back(place(x), place(y), rough(random));
        }
    }
    floor.triangles = test::gridTriangles(kSide);
    ProxySolver solver =
        solverAt(poseAt(0, 0, 0.01), toolOf(test::cylinder(Vec3(0, 0, 0), 0.5, 1, 28)), surfaceOf(std::move(floor)));
    int touching = 0;
    int distances = 0;
    for (int tick = 1; tick <= 100; ++tick) {
        const Quat turn(Eigen::AngleAxisd(5e-4 * tick, Vec3::UnitZ()));
        const MoveResult move = solver.moveToward({Vec3(1e-4 * tick, 0, -0.1), turn});
        touching += move.contactCount > 0;
        distances += move.distances;
    }
    EXPECT_EQ(touching, 100);
    EXPECT_LT(distances, 100 * 50);
}

TEST(ProxySolver, GivesTheSameResultAtEveryScale) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
        TriangleMesh ball = test::sphere(Vec3(0, 0, 0), 0.5 * scale, 24, 12);
        TriangleMesh tooth = test::sphere(Vec3(0, 0, -5 * scale), 5 * scale, 200, 100);
        ProxySolver solver = solverAt({Vec3(0, 0, 3) * scale, Quat::Identity()}, toolOf(ball), surfaceOf(tooth));
        settle(solver, {Vec3(0.8, 0.3, 0.1) * scale, Quat::Identity()});
        const Vec3 answer = solver.pose().position / scale;
        EXPECT_NEAR((answer - Vec3(0, 0, -5)).norm(), 5.5, 0.01) << scale;  // facets are up to 0.007 mm flat
        EXPECT_NEAR((answer - Vec3(0, 0, -5)).normalized().dot(Vec3(0.8, 0.3, 5.1).normalized()), 1, 1e-4) << scale;
    }
}

TEST(ProxySolver, RotatesOnlyAsFarAsTheWallsAllow) {
    TriangleMesh walls = test::box(Vec3(-10, -10, -1), Vec3(10, -0.6, 10));
    append(walls, test::box(Vec3(-10, 0.6, -1), Vec3(10, 10, 10)));
    const TriangleMesh plank = test::box(Vec3(-4, -0.5, 0), Vec3(4, 0.5, 0.2));
    ProxySolver solver = solverAt(poseAt(0, 0, 3), toolOf(plank), surfaceOf(walls));
    const test::ExactIntersection oracle(walls, plank);
    const Pose turned{Vec3(0, 0, 3), Quat(Eigen::AngleAxisd(1.2, Vec3::UnitZ()))};
    for (int i = 0; i < 50; ++i) {
        solver.moveToward(turned);
        ASSERT_FALSE(oracle.at(solver.pose()));
    }
    const double angle = 2 * std::acos(std::min(1.0, std::abs(solver.pose().rotation.w())));
    EXPECT_GT(angle, 0.0);
    EXPECT_LT(angle, 0.03);  // 8 mm long and 1 mm wide between walls 1.2 mm apart: 0.0252 rad
}

TEST(ProxySolver, KnowsWhichPosesAroundItAreClear) {
    const TriangleMesh tooth = test::sphere(Vec3(0, 0, 0), 3, 120, 80);
    const TriangleMesh bur = test::cylinder(Vec3(0, 0, 0), 0.6, 4, 12);
    const test::ExactIntersection oracle(tooth, bur);
    ProxySolver solver(toolOf(bur));
    solver.setSurface(surfaceOf(tooth));
    EXPECT_FALSE(solver.isClearAt(poseAt(0, 0, 3.1)).has_value()) << "nothing is known yet";
    solver.placeAt(poseAt(0, 0, 3.1));
    (void)settle(solver, poseAt(0, 0, 2.99));
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    int clear = 0;
    int blocked = 0;
    for (int i = 0; i < 400; ++i) {
        Vec3 step;
        for (int axis = 0; axis < 3; ++axis) step[axis] = 0.002 * normal(random);
        const Pose pose{solver.pose().position + step, solver.pose().rotation};
        const auto isClear = solver.isClearAt(pose);
        if (!isClear) continue;
        EXPECT_EQ(*isClear, !oracle.at(pose)) << i;
        ++(*isClear ? clear : blocked);
    }
    EXPECT_GT(clear, 50);
    EXPECT_GT(blocked, 50);
    EXPECT_FALSE(solver.isClearAt(poseAt(0, 0, 9)).has_value()) << "too far away";
    EXPECT_FALSE(solver.isClearAt({solver.pose().position, Quat(0, 1, 0, 0)}).has_value()) << "rotated too far";
}

TEST(ProxySolver, SettlesAfterAShiftAsAfterAPlacement) {
    ProxySolver shifted(toolOf(smallBox()));
    ProxySolver placed(toolOf(smallBox()));
    for (ProxySolver* solver : {&shifted, &placed}) {
        solver->setSurface(surfaceOf(test::floorBlock()));
        solver->placeAt(poseAt(0, 0, 0.1));
        (void)settle(*solver, poseAt(0.2, 0, -0.1));
    }
    shifted.shiftTo(poseAt(0.25, 0.1, 0.003));
    placed.placeAt(poseAt(0.25, 0.1, 0.003));
    EXPECT_EQ(shifted.pose().position, Vec3(0.25, 0.1, 0.003));
    for (ProxySolver* solver : {&shifted, &placed}) EXPECT_EQ(settle(*solver, poseAt(0.3, 0.1, -0.1)).contactCount, 1);
    EXPECT_NEAR((shifted.pose().position - placed.pose().position).norm(), 0, 1e-6);
    EXPECT_NEAR(shifted.pose().position.z(), 0, 1e-6);
}

TEST(ProxySolver, NeverIntersectsOnARandomWalkAndRepeatsItBitForBit) {
    constexpr int kTicks = test::cases(3000, 600);
    const TriangleMesh tooth = test::sphere(Vec3(0, 0, 0), 3, 120, 80);
    const TriangleMesh bur = test::cylinder(Vec3(0, 0, 0), 0.6, 4, 12);
    const test::ExactIntersection oracle(tooth, bur);
    std::vector<Pose> first;
    for (int run = 0; run < 2; ++run) {
        ProxySolver solver(toolOf(bur));
        solver.setSurface(surfaceOf(tooth));
        Pose goal = poseAt(0, 0, 4);
        solver.placeAt(goal);
        std::mt19937 random(42);
        std::normal_distribution<double> normal;
        int held = 0;
        for (int tick = 0; tick < kTicks; ++tick) {
            Vec3 kick;
            for (int axis = 0; axis < 3; ++axis) kick[axis] = normal(random);
            goal.position += 0.05 * kick - 0.02 * (goal.position - Vec3(0, 0, 2.7));
            for (int axis = 0; axis < 3; ++axis) kick[axis] = normal(random);
            goal.rotation =
                (Quat(Eigen::AngleAxisd(0.02 * kick.norm(), kick.normalized())) * goal.rotation).normalized();
            const MoveResult result = solver.moveToward(goal);
            ASSERT_NE(result.status, MoveStatus::Overlapping);
            held += result.contactCount > 0 ? 1 : 0;
            if (run == 0) {
                ASSERT_FALSE(oracle.at(solver.pose())) << tick;
                first.push_back(solver.pose());
            } else {
                ASSERT_EQ(solver.pose().position, first[tick].position);
                ASSERT_EQ(solver.pose().rotation.coeffs(), first[tick].rotation.coeffs());
            }
        }
        EXPECT_GT(held, kTicks / 3);
        EXPECT_LT(held, kTicks / 60 * 59);
    }
}

TEST(ProxySolver, AssertsThatItHasASurfaceAndAFiniteGoal) {
    ProxySolver solver(toolOf(smallBox()));
    EXPECT_ASSERT((void)solver.moveToward(poseAt(0, 0, 1)));
    solver.setSurface(surfaceOf(test::floorBlock()));
    EXPECT_ASSERT((void)solver.moveToward(poseAt(0, 0, std::nan(""))));
    EXPECT_ASSERT(solver.placeAt(poseAt(0, 0, 1 / 0.0)));
    EXPECT_ASSERT(solver.setBudget(-1));
}

}  // namespace tactooth
