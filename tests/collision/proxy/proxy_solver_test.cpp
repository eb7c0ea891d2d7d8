// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/proxy_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/exact_intersection.h"
#include "support/sanitizer.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

std::shared_ptr<const Surface> surfaceOf(TriangleMesh mesh) {
    return std::make_shared<Surface>(Surface{std::make_shared<SurfacePart>(std::move(mesh)), nullptr, {}, 0});
}

std::shared_ptr<const ToolShape> toolOf(TriangleMesh mesh) { return std::make_shared<ToolShape>(std::move(mesh)); }

/// Moves until the proxy has settled, at most 200 times.
MoveResult settle(ProxySolver& body, const Pose& goal) {
    MoveResult result;
    for (int i = 0; i < 200; ++i) {
        result = body.moveToward(goal);
        if (result.status != MoveStatus::OutOfIterations && result.status != MoveStatus::OutOfBudget) return result;
    }
    ADD_FAILURE() << "did not settle";
    return result;
}

Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }

TriangleMesh smallBox() { return test::box(Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 1)); }

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
    ProxySolver body(toolOf(smallBox()));
    body.setSurface(surfaceOf(test::box(Vec3(-10, -10, -1), Vec3(10, 10, 0))));
    body.placeAt(at(0, 0, 5));
    EXPECT_EQ(settle(body, at(3, -2, 1)).status, MoveStatus::Reached);
    EXPECT_EQ(body.pose().position, Vec3(3, -2, 1));
}

TEST(ProxySolver, WithASmallBudgetContinuesInTheNextMove) {
    const auto tool = toolOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 40, 20));
    const auto bed = surfaceOf(test::sphere(Vec3(0, 0, -2), 2, 200, 120));
    const test::ExactIntersection oracle(bed->base->mesh(), tool->mesh());
    for (const Work budget : {Work{6'000}, Work{25'000}}) {
        ProxySolver hurried(tool), patient(tool);
        hurried.setBudget(budget);
        for (ProxySolver* body : {&hurried, &patient}) {
            body->setSurface(bed);
            body->placeAt(at(0, 0, 0.02));
        }
        int cutShort = 0, stillInARow = 0;
        for (int tick = 1; tick <= 60; ++tick) {
            const Pose goal = at(0.01 * tick, 0.002 * tick, -0.02 - 0.002 * tick);
            const Vec3 before = hurried.pose().position;
            cutShort += hurried.moveToward(goal).status == MoveStatus::OutOfBudget ? 1 : 0;
            stillInARow = hurried.pose().position == before ? stillInARow + 1 : 0;
            EXPECT_LT(stillInARow, 5) << tick;
            EXPECT_FALSE(oracle.at(hurried.pose())) << tick;
            EXPECT_EQ(settle(patient, goal).status, MoveStatus::InContact) << tick;
        }
        EXPECT_GT(cutShort, 5) << budget;
        const Pose rest = at(0.6, 0.12, -0.14);
        EXPECT_EQ(settle(hurried, rest).status, MoveStatus::InContact);
        EXPECT_NEAR((hurried.pose().position - patient.pose().position).norm(), 0, 1e-5) << budget;
    }
}

TEST(ProxySolver, WithABudgetWaitsAFewMovesAtTheEndOfAGivenList) {
    const auto tool = toolOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 100, 60));
    const auto bed = surfaceOf(test::sphere(Vec3(0, 0, -2), 2, 300, 200));
    const Pose start = at(0, 0, 0.02), far = at(0.3, 0, -0.1);
    constexpr double kReach = 0.03;  // mm
    const auto given = [&](Work budget) {
        ProxySolver body(tool);
        NeighbourList near(*tool);
        near.buildAll(*bed, start, ContactMargin{Vec3::Zero(), kReach, 0.01});
        EXPECT_GT(near.clusters(), 600U) << "else the proxy builds a list at once";
        body.setSurface(bed);
        body.placeAt(start);
        body.setSurface(bed, near);
        body.setBudget(budget);
        return body;
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
    const Pose start = at(0, 0, 0.02);
    constexpr double kTurn = 0.01;
    for (const double angle : {0.05, 0.5, 2.5}) {  // a share of a large rotation is more than that share of its chord
        ProxySolver body(tool);
        NeighbourList near(*tool);
        near.buildAll(*bed, start, ContactMargin{Vec3::Zero(), 0.03, kTurn});
        body.setSurface(bed);
        body.placeAt(start);
        body.setSurface(bed, near);
        body.setBudget(1'000'000'000);
        const Pose turned{start.position, Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ()))};
        for (int move = 1; move <= 8; ++move) {
            EXPECT_EQ(body.moveToward(turned).status, MoveStatus::OutOfBudget);
            EXPECT_EQ(body.ownListRebuilds(), 0U) << angle << ", move " << move;
            const double chord = chordBetween(body.pose().rotation, start.rotation);
            EXPECT_LT(chord, kTurn);
            EXPECT_GT(chord, 0.9 * kTurn);
        }
    }
}

TEST(ProxySolver, OutsideOfALateListWaitsForTheNextOne) {
    const auto tool = toolOf(test::sphere(Vec3(0, 0, 0.5), 0.5, 100, 60));
    const auto bed = surfaceOf(test::sphere(Vec3(0, 0, -2), 2, 300, 200));
    const Pose listed = at(0, 0, 0.02), start = at(0.06, 0, 0.02), far = at(0.3, 0, -0.1);
    const auto listAt = [&](const Pose& pose) {
        NeighbourList near(*tool);
        near.buildAll(*bed, pose, ContactMargin{Vec3::Zero(), 0.03, 0.01});
        return near;
    };
    ProxySolver body(tool);
    body.setSurface(bed);
    body.placeAt(start);
    NeighbourList late = listAt(listed);
    body.setSurface(bed, late);
    body.setBudget(1'000'000'000);
    for (int move = 1; move <= 3; ++move) {
        EXPECT_EQ(body.moveToward(far).status, MoveStatus::OutOfBudget);
        EXPECT_EQ(body.pose().position, start.position);
    }
    EXPECT_EQ(body.ownListRebuilds(), 0U);
    NeighbourList next = listAt(start);
    body.setSurface(bed, next);
    (void)body.moveToward(far);
    EXPECT_NE(body.pose().position, start.position);
    EXPECT_EQ(body.ownListRebuilds(), 0U);

    NeighbourList again = listAt(listed);
    ProxySolver lonely(tool);
    lonely.setSurface(bed);
    lonely.placeAt(start);
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
    ProxySolver body(tool);
    body.setSurface(cavity);
    body.placeAt(at(0, 0, 0));
    NeighbourList near(*tool);
    near.buildAll(*cavity, at(0, 0, 0), ContactMargin{Vec3::Zero(), 0.02, 0.01});
    ASSERT_GT(near.clusters(), 600U);
    body.setSurface(cavity, near);
    body.setBudget(1'000'000'000);
    const Pose turned{Vec3(0.01, 0, -0.05), Quat(Eigen::AngleAxisd(0.1, Vec3::UnitZ()))};
    for (int move = 1; move <= 40; ++move) (void)body.moveToward(turned);
    EXPECT_EQ(body.ownListRebuilds(), 0U);
    EXPECT_LT(chordBetween(body.pose().rotation, Quat::Identity()), 0.01);
}

// In a cavity of the bur's own shape, the proxy's own list is too long at first.
TEST(ProxySolver, WaitsForAGivenListIfItsOwnIsTooLong) {
    const auto tool = toolOf(test::sphere(Vec3::Zero(), 0.5, 60, 30));
    const auto cavity = surfaceOf(test::sphere(Vec3::Zero(), 0.502, 240, 120));
    const Pose start = at(0, 0, 0), below = at(0.05, 0.03, -0.1);
    const auto listOf = [&](double reach) {
        NeighbourList near(*tool);
        near.buildAll(*cavity, start, ContactMargin{Vec3::Zero(), reach, 0.01});
        return near;
    };
    ProxySolver body(tool);
    body.setSurface(cavity);
    body.placeAt(start);
    NeighbourList shortList = listOf(0.0003);
    body.setSurface(cavity, shortList);
    body.setBudget(1'000'000'000);
    for (int move = 0; move < 8; ++move) (void)body.moveToward(below);
    ASSERT_EQ(body.ownListRebuilds(), 0U) << "at the end of the list that it was given";
    Vec3 place;
    do {
        place = body.pose().position;
        EXPECT_EQ(body.moveToward(below).status, MoveStatus::OutOfBudget);
    } while (body.pose().position != place);
    const std::uint32_t lists = body.ownListRebuilds();
    EXPECT_GT(lists, 0U);
    for (int move = 1; move < 8; ++move) {
        EXPECT_EQ(body.moveToward(below).status, MoveStatus::OutOfBudget);
        EXPECT_EQ(body.pose().position, place);
    }
    EXPECT_EQ(body.ownListRebuilds(), lists) << "the last list was too long, and no shorter one is built at once";
    NeighbourList longList = listOf(0.002);
    body.setSurface(cavity, longList);
    (void)body.moveToward(below);
    EXPECT_NE(body.pose().position, place);
    EXPECT_EQ(body.ownListRebuilds(), lists);
}

TEST(ProxySolver, ReturnsTheListOfTheOldSurface) {
    const auto tool = toolOf(smallBox());
    const auto low = surfaceOf(test::box(Vec3(-10, -10, -1), Vec3(10, 10, 0)));
    const auto lower = surfaceOf(test::box(Vec3(-10, -10, -1), Vec3(10, 10, -0.1)));
    const ContactMargin contactMargin{Vec3::Zero(), 0.3, 0.01};
    ProxySolver body(tool);
    NeighbourList near(*tool);
    body.setSurface(low);
    body.placeAt(at(0, 0, 0.2));
    near.buildAll(*low, body.pose(), contactMargin);
    const std::size_t clusters = near.clusters();
    ASSERT_GT(clusters, 0U);
    body.setSurface(low, near);
    near.buildAll(*lower, body.pose(), {});
    EXPECT_EQ(body.setSurface(lower, near), low);
    EXPECT_TRUE(near.made());
    EXPECT_EQ(near.clusters(), clusters);
    body.setSurface(low, near);  // and back
    (void)settle(body, at(0, 0, 0.1));
    EXPECT_EQ(body.ownListRebuilds(), 0U);
}

TEST(ProxySolver, StopsOnAPlaneAtItsMargin) {
    ProxySolver body(toolOf(smallBox()));
    body.setSurface(surfaceOf(test::box(Vec3(-10, -10, -1), Vec3(10, 10, 0))));
    body.placeAt(at(0, 0, 2));
    const MoveResult result = settle(body, at(1, 2, -0.25));
    EXPECT_EQ(result.status, MoveStatus::InContact);
    EXPECT_NEAR(body.pose().position.x(), 1, 1e-9);
    EXPECT_NEAR(body.pose().position.y(), 2, 1e-9);
    EXPECT_NEAR(body.pose().position.z(), body.margin(), body.margin());
    ASSERT_GE(result.contactCount, 1);
    EXPECT_NEAR(result.contacts[0].normal.z(), 1, 1e-9);
}

TEST(ProxySolver, SettlesInTheCornerOfThreeWalls) {
    TriangleMesh walls = test::box(Vec3(-10, -10, -1), Vec3(10, 10, 0));
    append(walls, test::box(Vec3(1, -10, -1), Vec3(2, 10, 10)));
    append(walls, test::box(Vec3(-10, 1, -1), Vec3(10, 2, 10)));
    ProxySolver body(toolOf(smallBox()));
    body.setSurface(surfaceOf(walls));
    body.placeAt(at(-3, -3, 3));
    const MoveResult result = settle(body, at(0.8, 0.9, -0.2));
    EXPECT_EQ(result.status, MoveStatus::InContact);
    EXPECT_NEAR((body.pose().position - Vec3(0.5, 0.5, 0)).norm(), 0, 4 * body.margin());
    EXPECT_EQ(result.contactCount, 3);
}

TEST(ProxySolver, IsHeldInAVGrooveAtTheClosedFormHeight) {
    // Two planes at 45 degrees. An upright box 1 mm wide rests on two edges half a millimetre above the bottom.
    TriangleMesh groove;
    groove.vertices = {Vec3f(0, -10, 0), Vec3f(0, 10, 0),  Vec3f(5, 10, 5),
                       Vec3f(5, -10, 5), Vec3f(-5, 10, 5), Vec3f(-5, -10, 5)};
    groove.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {0, 4, 5}};
    ProxySolver body(toolOf(smallBox()));
    body.setSurface(surfaceOf(groove));
    body.placeAt(at(0.3, 0, 4));
    settle(body, at(0.1, 0.5, 0.2));
    EXPECT_NEAR((body.pose().position - Vec3(0, 0.5, 0.5)).norm(), 0, 2 * body.margin());
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
            ProxySolver body(toolOf(isCornerOfTool ? ball : edgeBetweenFlatAndSlope(-1)));
            body.setSurface(surfaceOf(isCornerOfTool ? edgeBetweenFlatAndSlope(1) : spike));
            const double toFlat = isCornerOfTool ? -1 : 1;
            body.placeAt(at(toFlat, 0.3, 1));
            body.moveToward(at(toFlat, 0.3, 0.5));
            const double x = beside * body.margin();
            EXPECT_EQ(body.moveToward(at(toFlat * x, 0.3, -kDepth)).status, MoveStatus::InContact);
            const double exact = (8 * kDepth + x) / std::sqrt(65.0);
            const Vec3 hand(toFlat * x, 0.3, -kDepth);
            EXPECT_NEAR((body.pose().position - hand).norm(), exact, 2 * body.margin());
        }
    }
}

TEST(ProxySolver, DoesNotPassAThinWallInOneLongMove) {
    ProxySolver body(toolOf(test::sphere(Vec3(0, 0, 0), 0.02, 16, 8)));
    body.setSurface(surfaceOf(test::box(Vec3(-10, -10, 0), Vec3(10, 10, 0.1))));
    for (const double x : {0.0, 0.37, -3.1}) {
        body.placeAt(at(x, 0.123, 5));
        for (int i = 0; i < 100; ++i) body.moveToward(at(x, 0.123, -5));
        EXPECT_GT(body.pose().position.z(), 0.1);
    }
}

TEST(ProxySolver, OnceSettledStaysWithoutWorkUntilGoalOrSurfaceChange) {
    ProxySolver body(toolOf(smallBox()));
    const auto walls = surfaceOf(test::box(Vec3(-10, -10, -1), Vec3(10, 10, 0)));
    body.setSurface(walls);
    body.placeAt(at(0, 0, 0.1));
    const MoveResult first = body.moveToward(at(0, 0, -0.2));
    const Pose held = body.pose();
    EXPECT_GT(first.work, 0);
    const MoveResult again = body.moveToward(at(0, 0, -0.2));
    EXPECT_EQ(again.status, MoveStatus::InContact);
    EXPECT_EQ(again.work, 0);
    EXPECT_EQ(again.contactCount, first.contactCount);
    EXPECT_EQ(again.contacts[0].share, first.contacts[0].share);
    EXPECT_EQ(body.pose().position, held.position);

    EXPECT_GT(body.moveToward(at(0.001, 0, -0.2)).work, 0);
    EXPECT_EQ(body.moveToward(at(0.001, 0, -0.2)).work, 0);
    body.setSurface(surfaceOf(test::box(Vec3(-10, -10, -1), Vec3(10, 10, -0.1))));
    EXPECT_GT(body.moveToward(at(0.001, 0, -0.2)).work, 0);
    EXPECT_NEAR(body.pose().position.z(), -0.1, 1e-6);
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
    ProxySolver body(toolOf(test::cylinder(Vec3(0, 0, 0), 0.5, 1, 28)));
    body.setSurface(surfaceOf(std::move(floor)));
    body.placeAt(at(0, 0, 0.01));
    int touching = 0;
    int distances = 0;
    for (int tick = 1; tick <= 100; ++tick) {
        const Quat turn(Eigen::AngleAxisd(5e-4 * tick, Vec3::UnitZ()));
        const MoveResult move = body.moveToward({Vec3(1e-4 * tick, 0, -0.1), turn});
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
        ProxySolver body(toolOf(ball));
        body.setSurface(surfaceOf(tooth));
        body.placeAt({Vec3(0, 0, 3) * scale, Quat::Identity()});
        settle(body, {Vec3(0.8, 0.3, 0.1) * scale, Quat::Identity()});
        const Vec3 answer = body.pose().position / scale;
        EXPECT_NEAR((answer - Vec3(0, 0, -5)).norm(), 5.5, 0.01) << scale;  // facets are up to 0.007 mm flat
        EXPECT_NEAR((answer - Vec3(0, 0, -5)).normalized().dot(Vec3(0.8, 0.3, 5.1).normalized()), 1, 1e-4) << scale;
    }
}

TEST(ProxySolver, RotatesOnlyAsFarAsTheWallsAllow) {
    TriangleMesh walls = test::box(Vec3(-10, -10, -1), Vec3(10, -0.6, 10));
    append(walls, test::box(Vec3(-10, 0.6, -1), Vec3(10, 10, 10)));
    const TriangleMesh plank = test::box(Vec3(-4, -0.5, 0), Vec3(4, 0.5, 0.2));
    ProxySolver body(toolOf(plank));
    body.setSurface(surfaceOf(walls));
    body.placeAt(at(0, 0, 3));
    const test::ExactIntersection oracle(walls, plank);
    const Pose turned{Vec3(0, 0, 3), Quat(Eigen::AngleAxisd(1.2, Vec3::UnitZ()))};
    for (int i = 0; i < 50; ++i) {
        body.moveToward(turned);
        ASSERT_FALSE(oracle.at(body.pose()));
    }
    const double angle = 2 * std::acos(std::min(1.0, std::abs(body.pose().rotation.w())));
    EXPECT_GT(angle, 0.0);
    EXPECT_LT(angle, 0.03);  // 8 mm long and 1 mm wide between walls 1.2 mm apart: 0.0252 rad
}

TEST(ProxySolver, KnowsWhichPosesAroundItAreClear) {
    const TriangleMesh tooth = test::sphere(Vec3(0, 0, 0), 3, 120, 80);
    const TriangleMesh bur = test::cylinder(Vec3(0, 0, 0), 0.6, 4, 12);
    const test::ExactIntersection oracle(tooth, bur);
    ProxySolver body(toolOf(bur));
    body.setSurface(surfaceOf(tooth));
    EXPECT_FALSE(body.isClearAt(at(0, 0, 3.1)).has_value()) << "nothing is known yet";
    body.placeAt(at(0, 0, 3.1));
    (void)settle(body, at(0, 0, 2.99));
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    int clear = 0;
    int blocked = 0;
    for (int i = 0; i < 400; ++i) {
        Vec3 step;
        for (int axis = 0; axis < 3; ++axis) step[axis] = 0.002 * normal(random);
        const Pose pose{body.pose().position + step, body.pose().rotation};
        const auto isClear = body.isClearAt(pose);
        if (!isClear) continue;
        EXPECT_EQ(*isClear, !oracle.at(pose)) << i;
        ++(*isClear ? clear : blocked);
    }
    EXPECT_GT(clear, 50);
    EXPECT_GT(blocked, 50);
    EXPECT_FALSE(body.isClearAt(at(0, 0, 9)).has_value()) << "too far away";
    EXPECT_FALSE(body.isClearAt({body.pose().position, Quat(0, 1, 0, 0)}).has_value()) << "rotated too far";
}

TEST(ProxySolver, SettlesAfterAShiftAsAfterAPlacement) {
    ProxySolver shifted(toolOf(smallBox()));
    ProxySolver placed(toolOf(smallBox()));
    for (ProxySolver* body : {&shifted, &placed}) {
        body->setSurface(surfaceOf(test::box(Vec3(-10, -10, -1), Vec3(10, 10, 0))));
        body->placeAt(at(0, 0, 0.1));
        (void)settle(*body, at(0.2, 0, -0.1));
    }
    shifted.shiftTo(at(0.25, 0.1, 0.003));
    placed.placeAt(at(0.25, 0.1, 0.003));
    EXPECT_EQ(shifted.pose().position, Vec3(0.25, 0.1, 0.003));
    for (ProxySolver* body : {&shifted, &placed}) EXPECT_EQ(settle(*body, at(0.3, 0.1, -0.1)).contactCount, 1);
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
        ProxySolver body(toolOf(bur));
        body.setSurface(surfaceOf(tooth));
        Pose goal = at(0, 0, 4);
        body.placeAt(goal);
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
            const MoveResult result = body.moveToward(goal);
            ASSERT_NE(result.status, MoveStatus::Overlapping);
            held += result.contactCount > 0 ? 1 : 0;
            if (run == 0) {
                ASSERT_FALSE(oracle.at(body.pose())) << tick;
                first.push_back(body.pose());
            } else {
                ASSERT_EQ(body.pose().position, first[tick].position);
                ASSERT_EQ(body.pose().rotation.coeffs(), first[tick].rotation.coeffs());
            }
        }
        EXPECT_GT(held, kTicks / 3);
        EXPECT_LT(held, kTicks / 60 * 59);
    }
}

}  // namespace tactooth
