// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The proxy with six degrees of freedom: contacts hold it where the distance to the goal is least.
#include <gtest/gtest.h>

#include <cmath>

#include "collision/contact_checks.h"
#include "collision/proxy/proxy_fixture.h"
#include "geometry/util/degree.h"
#include "support/heap_counter.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using test::settle;

ProxySolver rotatingProxy(const TriangleMesh& tool, const TriangleMesh& tooth) {
    ProxySolver solver(test::toolOf(tool), Freedom::TranslationAndRotation);
    solver.setSurface(test::surfaceOf(tooth));
    return solver;
}

Quat randomRotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double w = normal(random), x = normal(random), y = normal(random);
    return Quat(w, x, y, normal(random)).normalized();
}

Vec3 rotationBetween(const Quat& from, const Quat& to) {
    const Eigen::AngleAxisd turn(to * from.conjugate());
    return turn.angle() * turn.axis();
}

/// The residual of Gauss' condition: the sum of the contacts minus the displacement from goal to pose, of the shift and
/// of the rotation, mm.
struct Imbalance {
    double shift, turn;
};

Imbalance imbalance(const ProxySolver& solver, const Pose& goal, const MoveResult& move) {
    const Vec3 centre = solver.pose() * solver.tool().centre();
    Vec3 shift = centre - goal * solver.tool().centre();
    Vec3 turn = solver.characteristicLength() * rotationBetween(goal.rotation, solver.pose().rotation);
    for (int i = 0; i < move.contactCount; ++i) {
        const ProxyContact& contact = move.contacts[i];
        EXPECT_GE(contact.multiplier, 0);
        shift -= contact.multiplier * contact.normal;
        turn -= contact.multiplier * (contact.point - centre).cross(contact.normal) / solver.characteristicLength();
    }
    return {shift.norm(), turn.norm()};
}

}  // namespace

TEST(RotatingProxy, FollowsAFreeGoalExactly) {
    ProxySolver solver =
        rotatingProxy(test::box(Vec3(-1, -0.5, 0), Vec3(1, 0.5, 6)), test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0)));
    solver.placeAt({Vec3(0, 0, 9), Quat::Identity()});
    std::mt19937 random(1);
    for (int i = 0; i < 50; ++i) {
        const Pose goal{Vec3(0.1 * i, 0, 9), randomRotation(random)};
        EXPECT_EQ(settle(solver, goal).status, MoveStatus::Reached);
        EXPECT_LT((solver.pose().position - goal.position).norm(), 1e-12);
        EXPECT_LT(rotationBetween(solver.pose().rotation, goal.rotation).norm(), 1e-12);
    }
}

TEST(RotatingProxy, PressedOnAPlateMeetsGaussCondition) {
    const TriangleMesh plank = test::box(Vec3(-1, -0.5, 0), Vec3(1, 0.5, 6));
    ProxySolver solver = rotatingProxy(plank, test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0)));
    std::mt19937 random(2);
    std::uniform_real_distribution<double> share(-1, 1);
    std::array<int, 7> held{};
    for (int i = 0; i < 300; ++i) {
        const double tilt = (i % 3 == 0 ? 0.02 : 3) * kDegree;
        const Quat rotation(Eigen::AngleAxisd(share(random) * tilt, Vec3::UnitX()) *
                            Eigen::AngleAxisd(share(random) * tilt, Vec3::UnitY()));
        const Pose goal{Vec3(share(random), share(random), -0.02 + 0.05 * share(random)), rotation};
        solver.placeAt({goal.position + Vec3(0, 0, 1), rotation});
        const MoveResult move = settle(solver, goal);
        SCOPED_TRACE(i);
        if (move.status == MoveStatus::Reached) continue;
        ASSERT_EQ(move.status, MoveStatus::InContact);
        ++held[move.contactCount];
        for (const Vec3f& corner : plank.vertices) ASSERT_GT((solver.pose() * corner.cast<double>()).z(), 0);
        for (int k = 0; k < move.contactCount; ++k) EXPECT_LT(move.contacts[k].point.z(), 20 * solver.margin());
        const Imbalance left = imbalance(solver, goal, move);
        EXPECT_LT(left.shift, 1e-5);  // 10 nm: the last iteration does not converge further
        EXPECT_LT(left.turn, 1e-5);
    }
    for (int count = 1; count <= 3; ++count) EXPECT_GT(held[count], 10) << count;  // corner, edge and face
}

/// If the planes did not follow a rotation, the corners of the tool would be held in the air.
TEST(RotatingProxy, OverEdgesAndCornersIsHeldOnlyWhereItTouches) {
    const Vec3 low(-9, -9, -5), high(0, 0, 0);
    ProxySolver solver = rotatingProxy(test::box(Vec3(-1, -0.5, 0), Vec3(1, 0.5, 6)), test::box(low, high));
    std::mt19937 random(6);
    std::uniform_real_distribution<double> share(-1, 1);
    std::array<int, 7> held{};
    int turned = 0;
    for (int i = 0; i < 300; ++i) {
        const Quat rotation(Eigen::AngleAxisd(0.1 * share(random), Vec3::UnitX()) *
                            Eigen::AngleAxisd(0.1 * share(random), Vec3::UnitY()) *
                            Eigen::AngleAxisd(3 * share(random), Vec3::UnitZ()));
        const Pose goal{Vec3(0.8 * share(random), i % 2 == 0 ? -3 : 0.6 * share(random), -0.05), rotation};
        solver.placeAt({goal.position + Vec3(0, 0, 1), rotation});
        const MoveResult move = settle(solver, goal);
        SCOPED_TRACE(i);
        if (move.status == MoveStatus::Reached) continue;
        ASSERT_EQ(move.status, MoveStatus::InContact);
        ++held[move.contactCount];
        for (int k = 0; k < move.contactCount; ++k) {
            const Vec3 point = move.contacts[k].point;
            EXPECT_LT((point - point.cwiseMax(low).cwiseMin(high)).norm(), 20 * solver.margin()) << point.transpose();
        }
        const Imbalance left = imbalance(solver, goal, move);
        EXPECT_LT(left.shift, 1e-5);
        EXPECT_LT(left.turn, 1e-5);
        if (rotationBetween(goal.rotation, solver.pose().rotation).norm() > 1e-3) ++turned;
    }
    for (int count = 1; count <= 2; ++count) EXPECT_GT(held[count], 10) << count;
    EXPECT_GT(turned, 100);
}

TEST(RotatingProxy, InASlotRotatesUntilItsCornersMeetBothWalls) {
    constexpr double kWidth = 1.0, kHeight = 4.0, kGap = 1.2;
    TriangleMesh slot = test::box(Vec3(-kGap / 2 - 2, -9, -9), Vec3(-kGap / 2, 9, 9));
    append(slot, test::box(Vec3(kGap / 2, -9, -9), Vec3(kGap / 2 + 2, 9, 9)));
    ProxySolver solver =
        rotatingProxy(test::box(Vec3(-kWidth / 2, -0.5, -kHeight / 2), Vec3(kWidth / 2, 0.5, kHeight / 2)), slot);
    solver.placeAt({Vec3::Zero(), Quat::Identity()});
    const Pose goal{Vec3::Zero(), Quat(Eigen::AngleAxisd(20 * kDegree, Vec3::UnitY()))};
    const MoveResult move = settle(solver, goal);
    EXPECT_EQ(move.status, MoveStatus::InContact);
    // Across the slot, the width of a box tilted by t is width * cos t + height * sin t.
    const double tilt = rotationBetween(Quat::Identity(), solver.pose().rotation).norm();
    EXPECT_NEAR(kWidth * std::cos(tilt) + kHeight * std::sin(tilt), kGap, 1e-5);
    EXPECT_LT(solver.pose().position.norm(), 1e-5);
}

TEST(RotatingProxy, NeverEntersATooth) {
    for (std::size_t which = 0; which < test::oracleTeeth().size(); ++which) {
        const TriangleMesh& tooth = test::oracleTeeth()[which].mesh;
        const TriangleMesh& tool = test::oracleTools()[1].mesh;
        const test::Oracle oracle(tooth, tool);
        ProxySolver solver = rotatingProxy(tool, tooth);
        std::mt19937 random(static_cast<unsigned>(which));
        int held = 0, turned = 0;
        for (int stroke = 0; stroke < 4; ++stroke) {
            const Pose deep = test::randomPoseNear(tooth, 0.3, random);
            const Vec3 out = (deep.position - Vec3(tooth.vertices[0].cast<double>())).normalized();
            Pose goal{deep.position + 12 * (deep.rotation * Vec3::UnitZ()), deep.rotation};
            if (!oracle.isFree(goal)) continue;
            solver.placeAt(goal);
            const Vec3 step = (deep.position - goal.position) / 100;
            const Quat turn(Eigen::AngleAxisd(0.002, out));
            for (int tick = 0; tick < 150; ++tick) {
                goal = {goal.position + (tick < 100 ? step : Vec3(0.01 * out.cross(step).normalized())),
                        turn * goal.rotation};
                const MoveResult move = solver.moveToward(goal);
                ASSERT_NE(move.status, MoveStatus::Overlapping);
                if (move.contactCount > 0) ++held;
                if (rotationBetween(goal.rotation, solver.pose().rotation).norm() > 1e-4) ++turned;
                if (tick % 5 == 0) {
                    ASSERT_TRUE(oracle.isFree(solver.pose())) << which << " " << stroke << " " << tick;
                }
            }
        }
        EXPECT_GT(held, 50);
        EXPECT_GT(turned, 30);
    }
}

TEST(RotatingProxy, AllocatesNothing) {
    ProxySolver solver = rotatingProxy(test::oracleTools()[1].mesh, test::oracleTeeth()[2].mesh);
    std::mt19937 random(8);
    int held = 0;
    for (int stroke = 0; stroke < 12; ++stroke) {
        const Pose deep = test::randomPoseNear(test::oracleTeeth()[2].mesh, 0.2, random);
        Pose goal{deep.position + 12 * (deep.rotation * Vec3::UnitZ()), deep.rotation};
        solver.placeAt(goal);
        const long before = test::heapCalls();
        for (int tick = 0; tick < 200; ++tick) {
            goal.position += (deep.position - goal.position) * 0.05;
            goal.rotation = Quat(Eigen::AngleAxisd(0.001, Vec3::UnitX())) * goal.rotation;
            if (solver.moveToward(goal).contactCount > 1) ++held;
        }
        EXPECT_EQ(test::heapCalls(), before);
    }
    EXPECT_GT(held, 10);
}

}  // namespace tactooth
