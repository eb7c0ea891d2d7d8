// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The proxy with six degrees of freedom: contacts hold it where the distance to the goal is least.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "collision/contact_checks.h"
#include "collision/proxy/proxy_solver.h"
#include "support/heap_counter.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

ProxySolver rotatingProxy(const TriangleMesh& tool, const TriangleMesh& tooth) {
    ProxySolver body(test::toolOf(tool), Freedom::TranslationAndRotation);
    body.setSurface(test::surfaceOf(tooth));
    return body;
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

Imbalance imbalance(const ProxySolver& body, const Pose& goal, const MoveResult& move) {
    const Vec3 centre = body.pose() * body.tool().centre();
    Vec3 shift = centre - goal * body.tool().centre();
    Vec3 turn = body.characteristicLength() * rotationBetween(goal.rotation, body.pose().rotation);
    for (int i = 0; i < move.contactCount; ++i) {
        const BodyContact& contact = move.contacts[i];
        EXPECT_GE(contact.share, 0);
        shift -= contact.share * contact.normal;
        turn -= contact.share * (contact.point - centre).cross(contact.normal) / body.characteristicLength();
    }
    return {shift.norm(), turn.norm()};
}

/// Moves toward `goal` until the proxy comes to rest.
MoveResult settle(ProxySolver& body, const Pose& goal) {
    MoveResult move;
    for (int i = 0; i < 50; ++i) {
        move = body.moveToward(goal);
        if (move.status != MoveStatus::OutOfIterations) break;
    }
    return move;
}

}  // namespace

TEST(RotatingProxy, FollowsAFreeGoalExactly) {
    ProxySolver body =
        rotatingProxy(test::box(Vec3(-1, -0.5, 0), Vec3(1, 0.5, 6)), test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0)));
    body.placeAt({Vec3(0, 0, 9), Quat::Identity()});
    std::mt19937 random(1);
    for (int i = 0; i < 50; ++i) {
        const Pose goal{Vec3(0.1 * i, 0, 9), randomRotation(random)};
        EXPECT_EQ(settle(body, goal).status, MoveStatus::Reached);
        EXPECT_LT((body.pose().position - goal.position).norm(), 1e-12);
        EXPECT_LT(rotationBetween(body.pose().rotation, goal.rotation).norm(), 1e-12);
    }
}

TEST(RotatingProxy, PressedOnAPlateMeetsGaussCondition) {
    const TriangleMesh plank = test::box(Vec3(-1, -0.5, 0), Vec3(1, 0.5, 6));
    ProxySolver body = rotatingProxy(plank, test::box(Vec3(-9, -9, -5), Vec3(9, 9, 0)));
    std::mt19937 random(2);
    std::uniform_real_distribution<double> share(-1, 1);
    std::array<int, 7> held{};
    for (int i = 0; i < 300; ++i) {
        const double tilt = (i % 3 == 0 ? 0.02 : 3) * kDegree;
        const Quat rotation(Eigen::AngleAxisd(share(random) * tilt, Vec3::UnitX()) *
                            Eigen::AngleAxisd(share(random) * tilt, Vec3::UnitY()));
        const Pose goal{Vec3(share(random), share(random), -0.02 + 0.05 * share(random)), rotation};
        body.placeAt({goal.position + Vec3(0, 0, 1), rotation});
        const MoveResult move = settle(body, goal);
        SCOPED_TRACE(i);
        if (move.status == MoveStatus::Reached) continue;
        ASSERT_EQ(move.status, MoveStatus::InContact);
        ++held[move.contactCount];
        for (const Vec3f& corner : plank.vertices) ASSERT_GT((body.pose() * corner.cast<double>()).z(), 0);
        for (int k = 0; k < move.contactCount; ++k) EXPECT_LT(move.contacts[k].point.z(), 20 * body.margin());
        const Imbalance left = imbalance(body, goal, move);
        EXPECT_LT(left.shift, 1e-5);  // 10 nm: the last iteration does not converge further
        EXPECT_LT(left.turn, 1e-5);
    }
    for (int count = 1; count <= 3; ++count) EXPECT_GT(held[count], 10) << count;  // corner, edge and face
}

/// If the planes did not follow a rotation, the corners of the tool would be held in the air.
TEST(RotatingProxy, OverEdgesAndCornersIsHeldOnlyWhereItTouches) {
    const Vec3 low(-9, -9, -5), high(0, 0, 0);
    ProxySolver body = rotatingProxy(test::box(Vec3(-1, -0.5, 0), Vec3(1, 0.5, 6)), test::box(low, high));
    std::mt19937 random(6);
    std::uniform_real_distribution<double> share(-1, 1);
    std::array<int, 7> held{};
    int turned = 0;
    for (int i = 0; i < 300; ++i) {
        const Quat rotation(Eigen::AngleAxisd(0.1 * share(random), Vec3::UnitX()) *
                            Eigen::AngleAxisd(0.1 * share(random), Vec3::UnitY()) *
                            Eigen::AngleAxisd(3 * share(random), Vec3::UnitZ()));
        const Pose goal{Vec3(0.8 * share(random), i % 2 == 0 ? -3 : 0.6 * share(random), -0.05), rotation};
        body.placeAt({goal.position + Vec3(0, 0, 1), rotation});
        const MoveResult move = settle(body, goal);
        SCOPED_TRACE(i);
        if (move.status == MoveStatus::Reached) continue;
        ASSERT_EQ(move.status, MoveStatus::InContact);
        ++held[move.contactCount];
        for (int k = 0; k < move.contactCount; ++k) {
            const Vec3 point = move.contacts[k].point;
            EXPECT_LT((point - point.cwiseMax(low).cwiseMin(high)).norm(), 20 * body.margin()) << point.transpose();
        }
        const Imbalance left = imbalance(body, goal, move);
        EXPECT_LT(left.shift, 1e-5);
        EXPECT_LT(left.turn, 1e-5);
        if (rotationBetween(goal.rotation, body.pose().rotation).norm() > 1e-3) ++turned;
    }
    for (int count = 1; count <= 2; ++count) EXPECT_GT(held[count], 10) << count;
    EXPECT_GT(turned, 100);
}

TEST(RotatingProxy, InASlotRotatesUntilItsCornersMeetBothWalls) {
    constexpr double kWidth = 1.0, kHeight = 4.0, kGap = 1.2;
    TriangleMesh slot = test::box(Vec3(-kGap / 2 - 2, -9, -9), Vec3(-kGap / 2, 9, 9));
    const TriangleMesh other = test::box(Vec3(kGap / 2, -9, -9), Vec3(kGap / 2 + 2, 9, 9));
    const auto first = static_cast<std::uint32_t>(slot.vertices.size());
    slot.vertices.insert(slot.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Triangle& t : other.triangles) slot.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    ProxySolver body =
        rotatingProxy(test::box(Vec3(-kWidth / 2, -0.5, -kHeight / 2), Vec3(kWidth / 2, 0.5, kHeight / 2)), slot);
    body.placeAt({Vec3::Zero(), Quat::Identity()});
    const Pose goal{Vec3::Zero(), Quat(Eigen::AngleAxisd(20 * kDegree, Vec3::UnitY()))};
    const MoveResult move = settle(body, goal);
    EXPECT_EQ(move.status, MoveStatus::InContact);
    // Across the slot, the width of a box tilted by t is width * cos t + height * sin t.
    const double tilt = rotationBetween(Quat::Identity(), body.pose().rotation).norm();
    EXPECT_NEAR(kWidth * std::cos(tilt) + kHeight * std::sin(tilt), kGap, 1e-5);
    EXPECT_LT(body.pose().position.norm(), 1e-5);
}

TEST(RotatingProxy, NeverEntersATooth) {
    for (std::size_t which = 0; which < test::oracleTeeth().size(); ++which) {
        const TriangleMesh& tooth = test::oracleTeeth()[which].mesh;
        const TriangleMesh& tool = test::oracleTools()[1].mesh;
        const test::Oracle oracle(tooth, tool);
        ProxySolver body = rotatingProxy(tool, tooth);
        std::mt19937 random(static_cast<unsigned>(which));
        int held = 0, turned = 0;
        for (int stroke = 0; stroke < 4; ++stroke) {
            const Pose deep = test::randomPoseNear(tooth, 0.3, random);
            const Vec3 out = (deep.position - Vec3(tooth.vertices[0].cast<double>())).normalized();
            Pose hand{deep.position + 12 * (deep.rotation * Vec3::UnitZ()), deep.rotation};
            if (!oracle.isFree(hand)) continue;
            body.placeAt(hand);
            const Vec3 step = (deep.position - hand.position) / 100;
            const Quat turn(Eigen::AngleAxisd(0.002, out));
            for (int tick = 0; tick < 150; ++tick) {
                hand = {hand.position + (tick < 100 ? step : Vec3(0.01 * out.cross(step).normalized())),
                        turn * hand.rotation};
                const MoveResult move = body.moveToward(hand);
                ASSERT_NE(move.status, MoveStatus::Overlapping);
                if (move.contactCount > 0) ++held;
                if (rotationBetween(hand.rotation, body.pose().rotation).norm() > 1e-4) ++turned;
                if (tick % 5 == 0) {
                    ASSERT_TRUE(oracle.isFree(body.pose())) << which << " " << stroke << " " << tick;
                }
            }
        }
        EXPECT_GT(held, 50);
        EXPECT_GT(turned, 30);
    }
}

TEST(RotatingProxy, AllocatesNothing) {
    ProxySolver body = rotatingProxy(test::oracleTools()[1].mesh, test::oracleTeeth()[2].mesh);
    std::mt19937 random(8);
    int held = 0;
    for (int stroke = 0; stroke < 12; ++stroke) {
        const Pose deep = test::randomPoseNear(test::oracleTeeth()[2].mesh, 0.2, random);
        Pose hand{deep.position + 12 * (deep.rotation * Vec3::UnitZ()), deep.rotation};
        body.placeAt(hand);
        const long before = test::heapCalls();
        for (int tick = 0; tick < 200; ++tick) {
            hand.position += (deep.position - hand.position) * 0.05;
            hand.rotation = Quat(Eigen::AngleAxisd(0.001, Vec3::UnitX())) * hand.rotation;
            if (body.moveToward(hand).contactCount > 1) ++held;
        }
        EXPECT_EQ(test::heapCalls(), before);
    }
    EXPECT_GT(held, 10);
}

}  // namespace tactooth
