// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/qp3.h"
#include "support/expect_assert.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace tactooth {
namespace {

Vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    Vec3 direction;
    direction.x() = normal(random);
    direction.y() = normal(random);
    direction.z() = normal(random);
    return direction.normalized();
}

/// Checks the Karush-Kuhn-Tucker conditions. Only the nearest point of a convex set meets them.
void expectNearest(const Qp3Result& result, const std::vector<HalfSpace>& halfSpaces, const Vec3& target) {
    for (const HalfSpace& half : halfSpaces) ASSERT_GE(half.normal.dot(result.point), half.offset - 1e-9);
    Vec3 push = Vec3::Zero();
    for (int i = 0; i < result.activeCount; ++i) {
        const HalfSpace& half = halfSpaces[result.active[i]];
        ASSERT_NEAR(half.normal.dot(result.point), half.offset, 1e-9);
        ASSERT_GE(result.multiplier[i], 0);
        push += result.multiplier[i] * half.normal;
    }
    ASSERT_LT((result.point - target - push).norm(), 1e-7 * (1 + (result.point - target).norm()));
}

}  // namespace

TEST(Qp3, FulfilsTheOptimalityConditionsOnRandomProblems) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> offset(-1.0, 0.0);  // the origin is always feasible
    std::array<int, 4> seen{};
    for (int i = 0; i < 10000; ++i) {
        std::vector<HalfSpace> halfSpaces(1 + i % 12);
        for (HalfSpace& half : halfSpaces) half = {randomDirection(random), offset(random)};
        const Vec3 target = 2 * randomDirection(random);
        const Qp3Result result = solveQp3(halfSpaces, target, 1e-12);
        ASSERT_TRUE(result.feasible);
        expectNearest(result, halfSpaces, target);
        ++seen[result.activeCount];
    }
    for (const int count : seen) EXPECT_GT(count, 300);  // free, plane, edge and corner all occur
}

TEST(Qp3, KnowsThatOpposedHalfSpacesHaveNoCommonPoint) {
    const std::vector<HalfSpace> halfSpaces = {{Vec3::UnitX(), 1}, {-Vec3::UnitX(), 0}};
    EXPECT_FALSE(solveQp3(halfSpaces, Vec3::Zero(), 1e-12).feasible);
}

TEST(Qp3, KnowsThatAnInvertedPrismIsEmpty) {
    std::vector<HalfSpace> halfSpaces;
    for (int i = 0; i < 3; ++i) {
        const double angle = 2 * 3.141592653589793 * i / 3;
        halfSpaces.push_back({Vec3(std::cos(angle), std::sin(angle), 0), 0.1});
    }
    EXPECT_FALSE(solveQp3(halfSpaces, Vec3(1, 2, 3), 1e-12).feasible);
}

TEST(Qp3, TakesTheTighterOfTwoParallelPlanes) {
    const std::vector<HalfSpace> halfSpaces = {{Vec3::UnitZ(), 1}, {Vec3::UnitZ(), 2}, {Vec3::UnitZ(), 1.5}};
    const Qp3Result result = solveQp3(halfSpaces, Vec3(4, 5, -6), 1e-12);
    EXPECT_EQ(result.point, Vec3(4, 5, 2));
    ASSERT_EQ(result.activeCount, 1);
    EXPECT_EQ(result.active[0], 1);
    EXPECT_DOUBLE_EQ(result.multiplier[0], 8);
}

TEST(Qp3, WithoutHalfSpacesIsTheTarget) {
    const Qp3Result result = solveQp3({}, Vec3(1, 2, 3), 1e-12);
    EXPECT_TRUE(result.feasible);
    EXPECT_EQ(result.point, Vec3(1, 2, 3));
}

TEST(Qp3, AssertsThatNormalsAreUnitAndTheTargetIsFinite) {
    const std::vector<HalfSpace> tooLong = {{2 * Vec3::UnitX(), 1}};
    EXPECT_ASSERT((void)solveQp3(tooLong, Vec3::Zero(), 1e-12));
    EXPECT_ASSERT((void)solveQp3({}, Vec3::Zero(), -1));
    EXPECT_ASSERT((void)solveQp3({}, Vec3::UnitX() / 0.0, 1e-12));
}

}  // namespace tactooth
