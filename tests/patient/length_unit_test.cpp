// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/length_unit.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(LengthUnit, TheLongestSideDecidesTheUnit) {
    for (const auto& [longest, mm] : {std::pair(21.0, 1.0),
                                      {17.9, 1.0},
                                      {8.0, 1.0},
                                      {2.17, 10.0},
                                      {0.9, 25.4},
                                      {0.0221, 1000.0},
                                      {22300.0, 0.001},
                                      {0.85 * 10, 1.0}}) {
        EXPECT_EQ(guessScale(longest).mmPerUnit, mm) << longest;
    }
}

TEST(LengthUnit, WhatNoUnitExplainsBecomesAnAverageTooth) {
    const ScaleGuess guess = guessScale(502);
    EXPECT_NEAR(guess.mmPerUnit * 502, 21, 1e-9);
    EXPECT_EQ(
        inWords(guess.why),
        "No unit of length makes this a tooth (longest side 502.00): scaled by 0.04183 to the 21 mm of an average "
        "tooth.");
}

TEST(LengthUnit, TheReasonIsSaid) {
    EXPECT_EQ(inWords(guessScale(2.17).why),
              "Units taken as cm, because the longest side would be 21.7 mm, as that of a whole tooth.");
}

TEST(LengthUnit, AMeshIsScaledAndOneInMmKeepsEveryBit) {
    TriangleMesh mesh;
    mesh.vertices = {Vec3f(1.5F, -2, 0.1F)};
    scaleToMm(mesh, 1);
    EXPECT_EQ(mesh.vertices[0], Vec3f(1.5F, -2, 0.1F));
    scaleToMm(mesh, 25.4);
    EXPECT_EQ(mesh.vertices[0], (25.4 * Vec3f(1.5F, -2, 0.1F).cast<double>()).cast<float>());
}

TEST(LengthUnit, IsFoundByItsName) {
    EXPECT_EQ(lengthUnitFromName("inch")->mm, 25.4);
    EXPECT_FALSE(lengthUnitFromName("cubit"));
}

}  // namespace
}  // namespace tactooth
