// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/narrow/gjk.h"

#include <gtest/gtest.h>

#include <random>
#include <span>

#include "support/expect_assert.h"
#include "triangle_oracle.h"

namespace tactooth {
namespace {

Triangle3 randomTriangle(std::mt19937& random, double reach) {
    std::uniform_real_distribution<double> coordinate(-reach, reach);
    Triangle3 triangle;
    for (Vec3& corner : triangle) {
        corner.x() = coordinate(random);
        corner.y() = coordinate(random);
        corner.z() = coordinate(random);
    }
    return triangle;
}

void expectAgreement(const Triangle3& a, const Triangle3& b, double scale) {
    const double expected = test::triangleDistance(a, b);
    const GjkResult result = distanceBetween(a, b, b[0] - a[0]);
    ASSERT_NEAR(result.distance, expected, 1e-12 * scale);
    ASSERT_EQ(result.separated, expected > 1e-12 * scale);
    if (!result.separated) return;
    ASSERT_NEAR(result.normal.norm(), 1, 1e-12);
    ASSERT_NEAR((result.onB - result.onA).norm(), expected, 1e-11 * scale);
    // The proof: the slab is really empty, and as wide as the distance.
    ASSERT_LE(result.gap, lowestAlong(b, result.normal) - highestAlong(a, result.normal));
    ASSERT_NEAR(result.gap, expected, 1e-9 * scale);
}

}  // namespace

TEST(Gjk, AgreesWithBruteForceOverFeaturesAtThreeScales) {
    std::mt19937 random(1);
    int apart = 0;
    constexpr int kPairs = 10000;
    for (int i = 0; i < kPairs; ++i) {
        const double scale = i % 3 == 0 ? 1e-3 : i % 3 == 1 ? 1.0 : 1e3;
        const Triangle3 a = randomTriangle(random, scale);
        Triangle3 b = randomTriangle(random, scale);
        for (Vec3& corner : b) corner += Vec3(0.15, 0.1, 0.05) * scale;
        expectAgreement(a, b, scale);
        apart += test::triangleDistance(a, b) > 0 ? 1 : 0;
    }
    EXPECT_GT(apart, kPairs * 3 / 10);  // the sample contains both disjoint and crossing pairs
    EXPECT_LT(apart, kPairs * 9 / 10);
}

TEST(Gjk, SeparatesByASlabNearlyAsWideAsTheDistance) {
    std::mt19937 random(11);
    constexpr double kLeast = 0.01;
    int sooner = 0;
    int wide = 0;
    for (int i = 0; i < 10000; ++i) {
        const Triangle3 a = randomTriangle(random, 1);
        Triangle3 b = randomTriangle(random, 1);
        for (Vec3& corner : b) corner += Vec3(0.3, 0.2, 0.1);
        const GjkResult exact = distanceBetween(a, b, b[0] - a[0]);
        const GjkResult found = separateConvex(a, b, b[0] - a[0], kLeast);
        ASSERT_EQ(found.separated, exact.separated) << i;
        if (!exact.separated) continue;
        ASSERT_LE(found.gap, lowestAlong(b, found.normal) - highestAlong(a, found.normal));
        ASSERT_GE(found.gap, 0.7 * exact.distance * (1 - 1e-12)) << i;
        if (exact.distance <= kLeast) {
            ASSERT_EQ(found.gap, exact.gap) << i;
        }
        sooner += found.iterations < exact.iterations ? 1 : 0;
        ++wide;
    }
    EXPECT_GT(wide, 3000);
    EXPECT_GT(sooner, wide / 3) << "else it saves little";
}

// A corner a nanometre over the long edge that two triangles share: the features there define no normal.
TEST(Gjk, SeesThatACornerOverALongEdgeIsApart) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> along(0.05, 0.95), tilt(-0.5, 0.5);
    const Triangle3 floor = {Vec3(-40, -40, 0), Vec3(40, -40, 0), Vec3(40, 40, 0)};
    for (int i = 0; i < 10000; ++i) {
        const double place = -40 + 80 * along(random);
        const double height = i % 2 == 0 ? 1e-6 : 1e-5;
        const Vec3 corner(place, place, height);
        const Triangle3 above = {corner, corner + Vec3(0.3, tilt(random), 0.4), corner + Vec3(tilt(random), 0.3, 0.5)};
        for (const bool swapped : {false, true}) {
            const GjkResult result = swapped ? distanceBetween(above, floor, Vec3(tilt(random), tilt(random), -1))
                                             : distanceBetween(floor, above, Vec3(tilt(random), tilt(random), 1));
            ASSERT_TRUE(result.separated) << i;
            ASSERT_NEAR(result.distance, height, 1e-12);
            ASSERT_GE(result.gap, 0.5 * height) << i;
        }
    }
}

TEST(Gjk, MeasuresATinyGapToTheLastDigits) {
    const Triangle3 floor = {Vec3(10, 10, 20), Vec3(11, 10, 20), Vec3(10, 11, 20)};
    for (const double gap : {1e-3, 1e-6, 1e-9}) {
        const Triangle3 above = {Vec3(10.2, 10.2, 20 + gap), Vec3(10.3, 10.25, 20.5), Vec3(10.1, 10.4, 20.7)};
        const GjkResult result = distanceBetween(floor, above, Vec3::UnitX());
        ASSERT_TRUE(result.separated);
        EXPECT_NEAR(result.gap, gap, 8e-15);
        EXPECT_NEAR(result.normal.z(), 1, 1e-9);
    }
}

TEST(Gjk, TrianglesThatShareACornerTouch) {
    const Triangle3 a = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const Triangle3 b = {Vec3(0, 0, 0), Vec3(-1, 0, 1), Vec3(0, -1, 1)};
    EXPECT_FALSE(distanceBetween(a, b, Vec3::UnitZ()).separated);
}

TEST(Gjk, HandlesNeedlesPointsAndCoincidence) {
    const Triangle3 point = {Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(1, 2, 3)};
    const Triangle3 needle = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0, 0)};
    const Triangle3 flat = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    EXPECT_NEAR(distanceBetween(point, needle, Vec3::Zero()).distance, std::sqrt(13.0), 1e-12);
    EXPECT_FALSE(distanceBetween(flat, flat, Vec3::UnitZ()).separated);
    EXPECT_FALSE(distanceBetween(point, point, Vec3::UnitZ()).separated);
    EXPECT_FALSE(distanceBetween(needle, flat, Vec3::UnitZ()).separated);
}

TEST(Gjk, NeedsFewIterationsFromAGoodGuess) {
    std::mt19937 random(5);
    int iterations = 0;
    constexpr int kPairs = 1000;
    for (int i = 0; i < kPairs; ++i) {
        const Triangle3 a = randomTriangle(random, 1);
        Triangle3 b = randomTriangle(random, 1);
        for (Vec3& corner : b) corner.x() += 2.5;
        const GjkResult cold = distanceBetween(a, b, b[0] - a[0]);
        iterations += distanceBetween(a, b, cold.normal).iterations;
    }
    EXPECT_LT(iterations, 5 * kPairs);
}

TEST(Gjk, AssertsThatThereAreTrianglesAndTheGuessIsFinite) {
    const Triangle3 triangle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const Vec3 guess = Vec3::UnitZ();
    EXPECT_ASSERT((void)distanceBetween(triangle, std::span(triangle).first(2), guess));
    EXPECT_ASSERT((void)distanceBetween(triangle, triangle, guess / 0.0));
    EXPECT_ASSERT((void)separateConvex(triangle, triangle, guess, -1));
    EXPECT_ASSERT((void)lowestAlong({}, guess));
}

}  // namespace tactooth
