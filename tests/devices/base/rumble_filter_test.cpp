// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/rumble_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

using test::kTick;

TEST(RumbleFilter, ASteadyForceShakesNothing) {
    RumbleFilter sense;
    for (int i = 0; i < 2000; ++i) sense.add(Vec3(0, 0, 2), kTick);  // the onset counts as vibration for a while
    EXPECT_NEAR(sense.steady(), 2, 1e-6);
    EXPECT_NEAR(sense.vibration(), 0, 1e-6);
}

TEST(RumbleFilter, ACuttingBursShakingIsFoundOnTopOfTheForce) {
    RumbleFilter sense;
    constexpr double kAmplitude = 0.08, kHz = 208;  // the vibration of a turbine at 2 N
    for (int i = 0; i < 500; ++i) {
        sense.add(Vec3(kAmplitude * std::sin(2 * std::numbers::pi * kHz * i * kTick), 0, 2), kTick);
    }
    EXPECT_NEAR(sense.steady(), 2, 0.01);
    EXPECT_NEAR(sense.vibration(), kAmplitude / std::sqrt(2), 0.01);
}

TEST(RumbleFilter, ATapShakesForAMoment) {
    RumbleFilter sense;
    for (int i = 0; i < 5; ++i) sense.add(Vec3(0, 0, 0.3 * i), kTick);
    EXPECT_GT(sense.vibration(), 0.2);
    for (int i = 0; i < 300; ++i) sense.add(Vec3(0, 0, 1.2), kTick);
    EXPECT_LT(sense.vibration(), 0.01);
}

TEST(RumbleFilter, WhatIsNoNumberIsPassedOver) {
    RumbleFilter sense;
    sense.add(Vec3(0, 0, 1), kTick);
    const double before = sense.steady();
    sense.add(Vec3(0, 0, std::nan("")), kTick);
    sense.add(Vec3(0, 0, 9), 0);
    sense.add(Vec3(0, 0, 9), std::nan(""));
    EXPECT_EQ(sense.steady(), before);
}

}  // namespace
}  // namespace tactooth
