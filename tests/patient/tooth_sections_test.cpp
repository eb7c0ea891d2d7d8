// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/tooth_sections.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(ToothSections, AreasAreThoseOfTheBody) {
    const SectionProfile profile = sectionProfile(test::box(Vec3(1, 2, 3), Vec3(4, 4, 9)), 12);
    EXPECT_EQ(profile.bottom, 3);
    EXPECT_EQ(profile.step, 0.5);
    for (const double area : profile.areas) EXPECT_NEAR(area, 6, 1e-9);
}

TEST(ToothSections, ASphereShrinksTowardItsPoles) {
    const SectionProfile profile = sectionProfile(test::sphere(Vec3(7, 0, 0), 5, 120, 60), 10);
    EXPECT_NEAR(profile.areas[5], std::numbers::pi * (25 - 0.25), 0.5);
    EXPECT_LT(profile.areas.back(), profile.areas[5] / 4);
}

TEST(ToothSections, TheNeckIsWhereTheCrownEnds) {
    SectionProfile profile{-14, 1, {}};
    for (int i = 0; i < 21; ++i) profile.areas.push_back(i < 14 ? 10 + i : 80);
    EXPECT_NEAR(neckHeight(profile), 0, 1);
}

TEST(ToothSections, AForkOfTheRootsIsNoNeck) {
    SectionProfile profile{0, 1, {}};  // as wide as its crown down to the furcation
    for (int i = 0; i < 20; ++i) profile.areas.push_back(i < 6 ? 4 * i : 80);
    EXPECT_NEAR(neckHeight(profile), 10.4, 1e-9);
}

TEST(ToothSections, ACrownAloneHasItsNeckAtTheBottom) {
    EXPECT_EQ(neckHeight({2, 1, {90, 95, 100, 99, 98, 90, 80}}), 2);
}

}  // namespace
}  // namespace tactooth
