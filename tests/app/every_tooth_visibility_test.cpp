// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The bur's head and the place where it lands are visible in every standard view of every tooth.
#include <gtest/gtest.h>

#include "app/tip_visibility_scene.h"

namespace tactooth {
namespace {

class EveryToothVisibility : public test::TipVisibilityTest, public ::testing::WithParamInterface<int> {};

/// The teeth of the left side are mirror images: two of them stand for all.
TEST_P(EveryToothVisibility, InEveryStandardView) { expectSeen(GetParam(), GetParam() % 2 == 0 ? "2" : "245"); }

INSTANTIATE_TEST_SUITE_P(All, EveryToothVisibility,
                         ::testing::Values(11, 12, 13, 14, 15, 16, 17, 18, 26, 36, 41, 42, 43, 44, 45, 46, 47, 48));

}  // namespace
}  // namespace tactooth
