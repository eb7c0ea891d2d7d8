// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/simulation/mirror_glass.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tactooth {
namespace {

MirrorGlass inMouthFor(double seconds) {
    MirrorGlass glass;
    for (int i = 0; i < 100; ++i) glass.advance({.isInMouth = true}, seconds / 100);
    return glass;
}

TEST(MirrorGlass, BreathComesSlowlyInTheMouth) {
    EXPECT_EQ(inMouthFor(0.99 * MirrorGlass::kBegins).fog(), 0);
    EXPECT_NEAR(inMouthFor((MirrorGlass::kBegins + MirrorGlass::kFull) / 2).fog(), 0.5, 1e-9);
    EXPECT_EQ(inMouthFor(2 * MirrorGlass::kFull).fog(), 1);
}

TEST(MirrorGlass, AToothWithoutAMouthLeavesItClear) {
    MirrorGlass glass;
    for (int i = 0; i < 100; ++i) glass.advance({.ground = 1.0 * i}, 1);
    EXPECT_EQ(glass.fog(), 0);
    EXPECT_EQ(glass.dirt(), 0);
}

TEST(MirrorGlass, TheSprayRinsesBreathOff) {
    MirrorGlass glass = inMouthFor(2 * MirrorGlass::kFull);
    glass.advance({.isInMouth = true, .sprayRuns = true}, MirrorGlass::kRinses / 2);
    EXPECT_GT(glass.fog(), 0.1);
    EXPECT_LT(glass.fog(), 0.5);
    glass.advance({.isInMouth = true, .sprayRuns = true}, MirrorGlass::kRinses / 2);
    EXPECT_EQ(glass.fog(), 0);
}

TEST(MirrorGlass, WhatIsGroundOffSoilsItUntilItIsWiped) {
    MirrorGlass glass;
    glass.advance({.isInMouth = true, .ground = 7}, 0.1);
    EXPECT_EQ(glass.dirt(), 0) << "cut before";
    for (int i = 1; i <= 10; ++i) {
        glass.advance({.isInMouth = true, .sprayRuns = true, .ground = 7 + 0.1 * i * MirrorGlass::kSoils}, 0.1);
    }
    EXPECT_NEAR(glass.dirt(), 1 - std::exp(-1.0), 1e-9);
    glass.wipe();
    EXPECT_EQ(glass.dirt(), 0);
    EXPECT_EQ(glass.fog(), 0);
}

}  // namespace
}  // namespace tactooth
