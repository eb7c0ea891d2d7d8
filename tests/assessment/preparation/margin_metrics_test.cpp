// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assessment/preparation/prepared_blocks.h"
#include "support/shapes.h"

// The margin and the inner angles of cavities whose lines are known.

namespace tactooth {
namespace {

using namespace test;

constexpr double kLength = 0.02;  // what has to be reached, mm

const TriangleMesh kIdeal = blockWithBox(-2, 2, -1.5, 1.5, 3);  // 4 x 3 mm, 2 mm deep

TEST(MarginMetrics, OfARoundCavityIsSmooth) {
    for (const double radius : {1.5, 3.0}) {
        const TriangleMesh round = blockWithRoundCavity(radius, 0, 0, 3);
        const PreparationMeasures measures(blockPreparation(round, round));
        EXPECT_LT(valueOf(measures, "finish_line_roughness"), 0.01) << radius;
        EXPECT_EQ(reasonOf(measures, "finish_line_width"), "no_crown_preparation");
    }
}

TEST(MarginMetrics, OfAWaveIsWhatSmoothingTakesAway) {
    // 12 waves of 0.1 mm round a circle of 3 mm: smoothing with a Gaussian leaves a share g of them, and what is off
    // the line that is smoothed and corrected is (1 - g)^2 of them.
    const double length = 2 * std::numbers::pi * 3 / 12, turns = 2 * std::numbers::pi * 0.5 / length;
    const double g = std::exp(-turns * turns / 2);
    const TriangleMesh wavy = blockWithRoundCavity(3, 0.1, 12, 3);
    const PreparationMeasures measures(blockPreparation(wavy, wavy));
    EXPECT_NEAR(valueOf(measures, "finish_line_roughness"), (1 - g) * (1 - g) * 0.1 / std::numbers::sqrt2, 0.01);
}

TEST(MarginMetrics, AWaveLongerThanTheSmoothingIsAForm) {
    const TriangleMesh oval = blockWithRoundCavity(3, 0.1, 2, 3);
    const PreparationMeasures measures(blockPreparation(oval, oval));
    EXPECT_LT(valueOf(measures, "finish_line_roughness"), 0.01);
}

TEST(MarginMetrics, WithoutACutThereIsNoMargin) {
    const TriangleMesh uncut = box(Vec3(-5, -5, -5), Vec3(5, 5, 5));
    const PreparationMeasures measures(blockPreparation(uncut, blockWithBox(-3, 3, -3, 3, 3)));
    EXPECT_EQ(reasonOf(measures, "finish_line_roughness"), "no_margin_line");
}

TEST(MarginMetrics, OfAStumpHaveTheWidthOfItsShoulder) {
    const TriangleMesh stump =
        preparedBlock(0, Rectangle::level(-4, 4, -4, 4, 0), Rectangle::level(-3.7, 3.7, -3.7, 3.7, 4));
    const PreparationMeasures measures(blockPreparation(stump, stump));
    EXPECT_NEAR(valueOf(measures, "finish_line_width"), 1, kLength);
    // Only at the corners is it farther, up to the diagonal.
    EXPECT_LT(valueOf(measures, "finish_line_width_sd"), 0.1);
    EXPECT_GT(valueOf(measures, "finish_line_width_sd"), 0.01);
}

PreparationMeasures measured(const TriangleMesh& student, const TriangleMesh& ideal = kIdeal) {
    return PreparationMeasures(blockPreparation(student, ideal));
}

TEST(InnerAngles, HaveTheRadiusOfTheirRounding) {
    EXPECT_NEAR(valueOf(measured(kIdeal), "inner_angle_radius"), 0, kLength);
    const double out = 2 * std::tan(12 * std::numbers::pi / 180);  // of a wall that leans outwards by 12 degrees
    const TriangleMesh leaning =
        blockWithCavityTo(Rectangle::level(-2, 2 + out, -1.5, 1.5, 5), Rectangle::level(-2, 2, -1.5, 1.5, 3));
    EXPECT_NEAR(valueOf(measured(leaning), "inner_angle_radius"), 0, kLength);
    for (const double radius : {0.1, 0.2, 0.4}) {
        const TriangleMesh rounded = blockWithRoundedAngle(2, radius, 3);
        EXPECT_NEAR(valueOf(measured(rounded, rounded), "inner_angle_radius"), std::min(radius, 0.3), kLength);
    }
    EXPECT_EQ(reasonOf(measured(box(Vec3(-5, -5, -5), Vec3(5, 5, 5))), "inner_angle_radius"), "nothing_cut");
}

}  // namespace
}  // namespace tactooth
