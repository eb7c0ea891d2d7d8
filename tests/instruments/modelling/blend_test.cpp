// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/modelling/blend.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(Blend, UnionIsExactAwayFromTheSeamAndFillsIt) {
    EXPECT_EQ(smoothUnion(-1.0, 2.0, 0.5), -1.0);
    EXPECT_EQ(smoothUnion(3.0, 0.5, 0.5), 0.5);
    EXPECT_DOUBLE_EQ(smoothUnion(0.2, 0.2, 0.4), 0.2 - 0.4 / 4);
}

TEST(Blend, IntersectionMirrorsTheUnion) {
    EXPECT_EQ(smoothIntersection(-1.0, 2.0, 0.5), 2.0);
    EXPECT_DOUBLE_EQ(smoothIntersection(0.2, 0.2, 0.4), 0.2 + 0.4 / 4);
}

TEST(Blend, StepRunsEitherWay) {
    EXPECT_EQ(smoothStep(1, 3, 0), 0);
    EXPECT_EQ(smoothStep(1, 3, 2), 0.5);
    EXPECT_EQ(smoothStep(1, 3, 4), 1);
    EXPECT_EQ(smoothStep(3, 1, 4), 0);
    EXPECT_EQ(smoothStep(3, 1, 0), 1);
}

TEST(Blend, TaperedCapsuleHasItsRadiusAtEitherEnd) {
    const Vec3 a(0, 0, 0), b(0, 0, 4);
    EXPECT_DOUBLE_EQ(taperedCapsule(Vec3(1, 0, 0), a, 1, b, 0.5), 0);
    EXPECT_DOUBLE_EQ(taperedCapsule(Vec3(0.5, 0, 4), a, 1, b, 0.5), 0);
    EXPECT_DOUBLE_EQ(taperedCapsule(Vec3(0, 0, 5), a, 1, b, 0.5), 0.5);
}

TEST(Blend, EllipsoidIsZeroOnItsAxesAndExactForABall) {
    const Vec3 axes(1, 2, 3);
    EXPECT_NEAR(ellipsoid(Vec3(1, 0, 0), axes), 0, 1e-12);
    EXPECT_NEAR(ellipsoid(Vec3(0, 0, 3), axes), 0, 1e-12);
    EXPECT_NEAR(ellipsoid(Vec3(3, 4, 0), Vec3::Constant(2)), 3, 1e-12);
    EXPECT_EQ(ellipsoid(Vec3::Zero(), axes), -1);
}

}  // namespace
}  // namespace tactooth
