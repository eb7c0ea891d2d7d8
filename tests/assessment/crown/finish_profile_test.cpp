// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/crown/finish_profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/util/degree.h"

namespace tactooth {
namespace {

TEST(FinishProfile, OfAFlatBurIsAFloorAndAWall) {
    const FinishProfile shoulder(1, 6 * kDegree, 0);
    EXPECT_NEAR(shoulder.above({0.3, 0.2}).value, 0.2, 1e-12);
    EXPECT_NEAR(shoulder.above({-2, -0.4}).value, -0.4, 1e-12);
    EXPECT_NEAR(shoulder.above({1, 0}).value, 0, 1e-12);
    for (const double height : {0.5, 3.0}) {  // on the wall, and 0.1 mm to both sides of it
        const Vec2 wall(1 + height * std::tan(6 * kDegree), height), out(-std::cos(6 * kDegree), std::sin(6 * kDegree));
        EXPECT_NEAR(shoulder.above(wall).value, 0, 1e-12);
        EXPECT_NEAR(shoulder.above(wall + 0.1 * out).value, 0.1, 1e-12);
        EXPECT_NEAR(shoulder.above(wall - 0.1 * out).value, -0.1, 1e-12);
    }
}

TEST(FinishProfile, OfARoundEndTouchesFloorAndWallWithItsRadius) {
    for (const double radius : {0.3, 0.5, 0.8}) {
        const FinishProfile round(0.5, 6 * kDegree, radius);
        // The middle of the bur's end lies its radius above the floor, and as far from the wall.
        const double x = 0.5 - radius * (1 - std::sin(6 * kDegree)) / std::cos(6 * kDegree);
        const double y = x >= 0 ? radius : std::sqrt(radius * radius - x * x);
        EXPECT_NEAR(round.above({x, y}).value, x >= 0 ? radius : std::min(radius, y), 1e-9) << radius;
        EXPECT_NEAR(round.above({0, 0}).value, 0, 1e-9) << "the finish line lies on the profile";
        const Vec2 below(std::sin(40 * kDegree), -std::cos(40 * kDegree));
        EXPECT_NEAR(round.above(Vec2(x, y) + radius * below).value, 0, 1e-9);
        EXPECT_NEAR(round.above(Vec2(x, y) + (radius + 0.1) * below).value, -0.1, 1e-9);
    }
}

TEST(FinishProfile, HasTheGradientOfItsHeight) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(-1, 3), y(-1, 5);
    for (const double radius : {0.0, 0.3, 0.8}) {
        const FinishProfile profile(0.6, 8 * kDegree, radius);
        int hits = 0;
        for (int i = 0; i < 2000; ++i) {
            const Vec2 place(x(random), y(random));
            const auto [value, gradient] = profile.above(place);
            EXPECT_NEAR(gradient.norm(), 1, 1e-9);
            constexpr double kStep = 1e-6;
            const Vec2 measured((profile.above(place + Vec2(kStep, 0)).value - value) / kStep,
                                (profile.above(place + Vec2(0, kStep)).value - value) / kStep);
            if (std::abs(measured.norm() - 1) > 1e-3) continue;  // where two pieces are as near
            EXPECT_LT((measured - gradient).norm(), 1e-3) << place.transpose();
            ++hits;
        }
        EXPECT_GT(hits, 1900);
    }
}

}  // namespace
}  // namespace tactooth
