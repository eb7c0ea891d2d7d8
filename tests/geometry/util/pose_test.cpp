// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tactooth {
namespace {

TEST(Pose, InverseUndoesAndProductsChain) {
    const Pose a{{1, -2, 3}, Quat(0.5, 0.5, -0.5, 0.5)};
    const Pose b{{-4, 0.5, 2}, Quat(0.6, 0, 0.8, 0)};
    const Vec3 point(7, 8, -9);
    EXPECT_LT(((a * b) * point - a * (b * point)).norm(), 1e-14);
    EXPECT_LT((a.inverse() * (a * point) - point).norm(), 1e-14);
}

TEST(ShortestRotation, BringsOneDirectionOntoTheOtherByTheAngleBetween) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto any = [&] { return Vec3(normal(random), normal(random), normal(random)); };
    for (int i = 0; i < 1000; ++i) {
        const Vec3 from = any();
        const Vec3 to = any();
        const Quat turn = shortestRotation(from, to);
        EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-12);
        const double between = std::atan2(from.cross(to).norm(), from.dot(to));
        EXPECT_NEAR(2 * std::atan2(turn.vec().norm(), std::abs(turn.w())), between, 1e-12);
    }
}

TEST(ShortestRotation, OfOppositeDirectionsIsHalfATurnAboutAnAxisAcross) {
    for (const Vec3& from : {Vec3(0, 0, 1), Vec3(2, 0, 0), Vec3(1, -3, 0.2)}) {
        const Quat turn = shortestRotation(from, -from);
        EXPECT_NEAR(turn.norm(), 1, 1e-12);
        EXPECT_LT((turn * from + from).norm(), 1e-7 * from.norm());
        EXPECT_NEAR(turn.vec().dot(from), 0, 1e-7 * from.norm());
    }
    EXPECT_TRUE(shortestRotation(Vec3(0, 3, 0), Vec3(0, 1, 0)).isApprox(Quat::Identity()));
}

}  // namespace
}  // namespace tactooth
