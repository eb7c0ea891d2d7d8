// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/distance_colour.h"

#include <gtest/gtest.h>

#include "view/scene/appearance.h"

namespace tactooth {
namespace {

/// The colour that a colour-blind eye sees, in linear light: the plane of colours that protanopes and deuteranopes
/// confuse. F. Vienot, H. Brettel, J. Mollon, Digital video colourmaps for checking the legibility of displays by
/// dichromats, Color Research and Application 24(4), 1999.
Vec3f seenBy(const Vec3f& srgb, bool protanope) {
    const Vec3f c = linearColour(srgb);
    const float red = protanope ? 0.11238F * c.x() + 0.88762F * c.y() : 0.29275F * c.x() + 0.70725F * c.y();
    const float blue = protanope ? 0.00401F * (c.x() - c.y()) + c.z() : -0.02234F * (c.x() - c.y()) + c.z();
    return {red, red, blue};
}

TEST(DistanceColour, TooDeepAndStillToCutDifferForColourBlindEyes) {
    for (const bool protanope : {true, false}) {
        for (double share = 0.25; share <= 1; share += 0.25) {
            const Vec3f deep = seenBy(distanceColour(-share), protanope);
            const Vec3f left = seenBy(distanceColour(share), protanope);
            // The share of blue in the light distinguishes the sides, whatever their lightness.
            EXPECT_LT(deep.z() / deep.x(), 0.75F * left.z() / left.x()) << share;
        }
    }
}

TEST(DistanceScale, RunsEvenlyWithoutATolerance) {
    const DistanceScale scale{0.5};
    EXPECT_DOUBLE_EQ(scale.shareOf(0.25), 0.5);
    EXPECT_DOUBLE_EQ(scale.shareOf(-0.125), -0.25);
    EXPECT_DOUBLE_EQ(scale.shareOf(7), 1);
}

TEST(DistanceScale, HasAnEdgeAtTheTolerance) {
    const DistanceScale scale{0.5, 0.1};
    for (const double within : {0.0, 0.05, -0.05, 0.1, -0.1}) EXPECT_EQ(scale.shareOf(within), 0);
    EXPECT_NEAR(scale.shareOf(0.1 + 1e-9), kToleranceStep, 1e-6);
    EXPECT_NEAR(scale.shareOf(-0.1 - 1e-9), -kToleranceStep, 1e-6);
    EXPECT_NEAR(scale.shareOf(0.3), (1 + kToleranceStep) / 2, 1e-12);
    EXPECT_DOUBLE_EQ(scale.shareOf(-0.5), -1);
    EXPECT_DOUBLE_EQ(scale.shareOf(-3), -1);
}

TEST(DistanceColour, GetsDarkerToBothEnds) {
    const auto lightness = [](double share) {
        const Vec3f c = linearColour(distanceColour(share));
        return 0.2126F * c.x() + 0.7152F * c.y() + 0.0722F * c.z();
    };
    for (double share = 0; share < 0.99; share += 0.05) {
        EXPECT_GT(lightness(share), lightness(share + 0.05));
        EXPECT_GT(lightness(-share), lightness(-share - 0.05));
    }
    EXPECT_EQ(distanceColour(-7), distanceColour(-1));
}

}  // namespace
}  // namespace tactooth
