// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The bur's head and the place where it lands are visible in every standard view of every tooth.
#include <gtest/gtest.h>

#include "app/tip_visibility_scene.h"

namespace tactooth {
namespace {

using TipVisibilityTest = test::TipVisibilityTest;

/// With three burs: short, thin and long.
void expectSeenOnQuadrant(int quadrant, void (*expectSeen)(int fdi, const char* bur)) {
    for (int place = 1; place <= 8; ++place) {
        for (const char* bur : {"4", "330", "58"}) expectSeen(10 * quadrant + place, bur);
    }
}

TEST_F(TipVisibilityTest, OnEveryUpperRightToothInEveryStandardView) { expectSeenOnQuadrant(1, &expectSeen); }
TEST_F(TipVisibilityTest, OnEveryUpperLeftToothInEveryStandardView) { expectSeenOnQuadrant(2, &expectSeen); }
TEST_F(TipVisibilityTest, OnEveryLowerLeftToothInEveryStandardView) { expectSeenOnQuadrant(3, &expectSeen); }
TEST_F(TipVisibilityTest, OnEveryLowerRightToothInEveryStandardView) { expectSeenOnQuadrant(4, &expectSeen); }

}  // namespace
}  // namespace tactooth
