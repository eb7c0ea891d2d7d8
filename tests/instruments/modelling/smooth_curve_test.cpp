// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/modelling/smooth_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tactooth {
namespace {

std::vector<SmoothCurve::Point> randomPoints(std::mt19937& random) {
    std::uniform_real_distribution<double> step(0.1, 2), value(-3, 3);
    std::vector<SmoothCurve::Point> points;
    double at = -4;
    for (int i = 0; i < 8; ++i) points.push_back({at += step(random), value(random)});
    return points;
}

TEST(SmoothCurve, GoesThroughItsPoints) {
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        const auto points = randomPoints(random);
        const SmoothCurve curve(points);
        for (const SmoothCurve::Point& point : points) EXPECT_NEAR(curve(point.at).value, point.value, 1e-12);
    }
}

TEST(SmoothCurve, StaysBetweenTwoNeighbouringPoints) {
    std::mt19937 random(2);
    for (int i = 0; i < 100; ++i) {
        const auto points = randomPoints(random);
        const SmoothCurve curve(points);
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            const auto [low, high] = std::minmax(points[k].value, points[k + 1].value);
            for (double part = 0; part <= 1; part += 0.05) {
                const double value = curve(std::lerp(points[k].at, points[k + 1].at, part)).value;
                EXPECT_GE(value, low - 1e-12);
                EXPECT_LE(value, high + 1e-12);
            }
        }
    }
}

TEST(SmoothCurve, HasTheSlopeThatItStates) {
    std::mt19937 random(3);
    const auto points = randomPoints(random);
    const SmoothCurve curve(points);
    constexpr double kStep = 1e-6;
    for (double at = points.front().at - 1; at < points.back().at + 1; at += 0.037) {
        const double slope = (curve(at + kStep).value - curve(at - kStep).value) / (2 * kStep);
        EXPECT_NEAR(curve(at).slope, slope, 1e-4);
    }
}

TEST(SmoothCurve, GoesStraightOnBeyondItsEnds) {
    const std::vector<SmoothCurve::Point> points = {{0, 1}, {2, 2}, {3, 0}};
    const SmoothCurve curve(points);
    EXPECT_DOUBLE_EQ(curve(-4).value, -1);
    EXPECT_DOUBLE_EQ(curve(5).value, -4);
}

}  // namespace
}  // namespace tactooth
