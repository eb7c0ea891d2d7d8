// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/dental_arch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tactooth {
namespace {

TEST(DentalArch, ItsMiddleIsThatOfTheCircle) {
    std::vector<Vec3> crowns;
    for (int i = 0; i < 7; ++i) crowns.emplace_back(3 + 25 * std::cos(0.3 * i), 4 + 25 * std::sin(0.3 * i), 9);
    const auto middle = archCentre(crowns);
    ASSERT_TRUE(middle);
    EXPECT_LT((*middle - Vec3(3, 4, 9)).norm(), 1e-6);
}

TEST(DentalArch, ARowHasNone) {
    EXPECT_FALSE(archCentre(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}));
    EXPECT_FALSE(archCentre(std::vector<Vec3>{{0, 0, 0}, {8, 0, 0}, {16, 0, 0}, {24, 0.01, 0}}));
}

}  // namespace
}  // namespace tactooth
