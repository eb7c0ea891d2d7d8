// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The bur's head and the place where it lands are visible in every standard view of every tooth.
#include <gtest/gtest.h>

#include "app/tip_visibility_scene.h"

namespace tactooth {
namespace {

using TipVisibilityTest = test::TipVisibilityTest;

TEST_F(TipVisibilityTest, OnEveryToothInEveryStandardViewWithThreeBurs) {
    for (int quadrant = 1; quadrant <= 4; ++quadrant) {
        for (int place = 1; place <= 8; ++place) {
            for (const char* bur : {"4", "330", "58"}) expectSeen(10 * quadrant + place, bur);
        }
    }
}

}  // namespace
}  // namespace tactooth
