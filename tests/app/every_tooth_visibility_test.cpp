// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The bur's head and the place where it lands are visible in every standard view of every tooth.
#include <gtest/gtest.h>

#include "app/tip_visibility_scene.h"

namespace tactooth {
namespace {

class EveryToothVisibility : public test::TipVisibilityTest, public ::testing::WithParamInterface<int> {};

TEST_P(EveryToothVisibility, InEveryStandardViewWithASmallAndALongBur) {
    for (const char* bur : {"2", "245"}) expectSeen(GetParam(), bur);
}

INSTANTIATE_TEST_SUITE_P(All, EveryToothVisibility,
                         ::testing::Values(11, 12, 13, 14, 15, 16, 17, 18, 21, 22, 23, 24, 25, 26, 27, 28, 31, 32, 33,
                                           34, 35, 36, 37, 38, 41, 42, 43, 44, 45, 46, 47, 48));

}  // namespace
}  // namespace tactooth
