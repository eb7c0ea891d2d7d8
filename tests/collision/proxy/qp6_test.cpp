// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/qp6.h"
#include "support/expect_assert.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace tactooth {
namespace {

Vec6 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    Vec6 direction;
    for (double& component : direction) component = normal(random);
    return direction.normalized();
}

/// Checks the Karush-Kuhn-Tucker conditions. Only the nearest point of a convex set meets them.
void expectNearest(const Qp6Result& result, const std::vector<HalfSpace6>& halfSpaces, const Vec6& target) {
    for (const HalfSpace6& half : halfSpaces) ASSERT_GE(half.normal.dot(result.point), half.offset - 1e-9);
    Vec6 push = Vec6::Zero();
    for (int i = 0; i < result.activeCount; ++i) {
        const HalfSpace6& half = halfSpaces[result.active[i]];
        ASSERT_NEAR(half.normal.dot(result.point), half.offset, 1e-9);
        ASSERT_GE(result.multiplier[i], 0);
        push += result.multiplier[i] * half.normal;
    }
    ASSERT_LT((result.point - target - push).norm(), 1e-9 * (1 + (result.point - target).norm()));
}

}  // namespace

TEST(Qp6, FulfilsTheOptimalityConditionsOnRandomProblems) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> offset(-1.0, 0.0);  // the origin is always feasible
    std::uniform_real_distribution<double> length(0.2, 5.0);
    std::array<int, 7> seen{};
    for (int i = 0; i < 10000; ++i) {
        std::vector<HalfSpace6> halfSpaces(1 + i % 30);
        for (HalfSpace6& half : halfSpaces) half = {length(random) * randomDirection(random), offset(random)};
        const Vec6 target = 4 * randomDirection(random);
        const Qp6Result result = solveQp6(halfSpaces, target, 1e-12);
        ASSERT_TRUE(result.feasible);
        expectNearest(result, halfSpaces, target);
        ++seen[result.activeCount];
    }
    for (int count = 0; count <= 5; ++count) EXPECT_GT(seen[count], 100) << count;
    EXPECT_GT(seen[6], 20);
}

TEST(Qp6, HandlesRepeatedAndDependentPlanes) {
    std::mt19937 random(4);
    for (int i = 0; i < 1000; ++i) {
        std::vector<HalfSpace6> halfSpaces;
        for (int k = 0; k < 3; ++k) halfSpaces.push_back({randomDirection(random), -0.1 * k});
        halfSpaces.push_back(halfSpaces[0]);
        halfSpaces.push_back({halfSpaces[0].normal + halfSpaces[1].normal, -0.05});
        halfSpaces.push_back({2 * halfSpaces[2].normal, -0.3});
        const Vec6 target = 2 * randomDirection(random);
        const Qp6Result result = solveQp6(halfSpaces, target, 1e-12);
        ASSERT_TRUE(result.feasible);
        expectNearest(result, halfSpaces, target);
    }
}

TEST(Qp6, KnowsThatOpposedHalfSpacesHaveNoCommonPoint) {
    const Vec6 x = Vec6::Unit(4);
    EXPECT_FALSE(solveQp6(std::vector<HalfSpace6>{{x, 1}, {-x, 0}}, Vec6::Zero(), 1e-12).feasible);
}

TEST(Qp6, WithoutHalfSpacesIsTheTarget) {
    const Vec6 target = Vec6::LinSpaced(1, 6);
    const Qp6Result result = solveQp6({}, target, 1e-12);
    EXPECT_TRUE(result.feasible);
    EXPECT_EQ(result.point, target);
}

TEST(Qp6, AssertsThatTheTargetIsFiniteAndTheToleranceNotNegative) {
    EXPECT_ASSERT((void)solveQp6({}, Vec6::Zero(), -1));
    EXPECT_ASSERT((void)solveQp6({}, Vec6::Ones() / 0.0, 1e-12));
}

}  // namespace tactooth
