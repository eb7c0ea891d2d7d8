// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/exact_sign.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tactooth {
namespace {

TEST(ExactSign, APointAboveACounterClockwiseTriangleIsPositive) {
    const Vec3f a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    EXPECT_EQ(orientationSign(a, b, c, Vec3f(0, 0, 1)), 1);
    EXPECT_EQ(orientationSign(a, b, c, Vec3f(0, 0, -1)), -1);
    EXPECT_EQ(orientationSign(a, b, c, Vec3f(7, -3, 0)), 0);
}

TEST(ExactSign, SeesTheLastBitOfACoordinate) {
    const Vec3f a(10.1F, 20.2F, 30.3F), b(11.7F, 20.9F, 30.3F), c(10.3F, 22.2F, 30.3F);
    const float height = 30.3F;
    EXPECT_EQ(orientationSign(a, b, c, Vec3f(10.9F, 21.1F, std::nextafter(height, 100.0F))), 1);
    EXPECT_EQ(orientationSign(a, b, c, Vec3f(10.9F, 21.1F, std::nextafter(height, 0.0F))), -1);
    EXPECT_EQ(orientationSign(a, b, c, Vec3f(10.9F, 21.1F, height)), 0);
}

TEST(ExactSign, SwappingTwoPointsTurnsTheSignEvenForNearlyFlatFours) {
    std::mt19937 random(20);
    std::uniform_real_distribution<float> place(-20, 20);
    std::uniform_int_distribution<int> ulps(-2, 2);
    int nonZero = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Vec3f a(place(random), place(random), place(random));
        const Vec3f b(place(random), place(random), place(random));
        const Vec3f c(place(random), place(random), place(random));
        Vec3f d = (a + b + c) / 3.0F;
        for (int n = ulps(random); n != 0; n += n < 0 ? 1 : -1) d.x() = std::nextafter(d.x(), n < 0 ? -99.F : 99.F);
        const int sign = orientationSign(a, b, c, d);
        ASSERT_EQ(orientationSign(b, a, c, d), -sign);
        ASSERT_EQ(orientationSign(a, c, b, d), -sign);
        ASSERT_EQ(orientationSign(a, b, d, c), -sign);
        ASSERT_EQ(orientationSign(c, d, a, b), sign);
        nonZero += sign != 0;
    }
    EXPECT_GT(nonZero, 15'000);
}

TEST(ExactSign, TinyAndLargeCoordinatesTogetherStayExact) {
    const float tiny = 1e-30F;
    const Vec3f a(0, 0, 0), b(30, 0, 0), c(0, 30, 0);
    EXPECT_EQ(orientationSign(a, b, c, Vec3f(30, 30, tiny)), 1);
    EXPECT_EQ(orientationSign(Vec3f(0, 0, tiny), Vec3f(30, 0, tiny), Vec3f(0, 30, tiny), Vec3f(9, 9, 0)), -1);
}

TEST(ExactSign, CrossProductComponents) {
    const Vec3f o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
    EXPECT_EQ(crossProductSign(o, x, o, y, 2), 1);
    EXPECT_EQ(crossProductSign(o, y, o, x, 2), -1);
    EXPECT_EQ(crossProductSign(o, x, o, y, 0), 0);
    EXPECT_EQ(crossProductSign(o, Vec3f(3, 3, 0), o, Vec3f(1, std::nextafter(1.0F, 2.0F), 0), 2), 1);
}

}  // namespace
}  // namespace tactooth
