// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/motor_thermal_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/servo_tick.h"

namespace tactooth {
namespace {

constexpr double kPeak = 3.3;
constexpr double kContinuous = 0.88;
using test::kTick;

TEST(MotorThermalModel, ColdMotorsMayRenderThePeakForce) {
    const MotorThermalModel heat(kPeak, kContinuous);
    EXPECT_EQ(heat.heat(), 0);
    EXPECT_EQ(heat.bound(), kPeak);
}

TEST(MotorThermalModel, TheContinuousForceLastsForEver) {
    MotorThermalModel heat(kPeak, kContinuous);
    for (int i = 0; i < 600'000; ++i) heat.add(kContinuous, kTick, 0);
    EXPECT_NEAR(heat.heat(), 1, 1e-4);
    EXPECT_LE(heat.heat(), 1);
    EXPECT_GE(heat.bound(), kContinuous);
}

TEST(MotorThermalModel, AFullPressFallsToTheContinuousForceAndHeatsNoFurther) {
    MotorThermalModel heat(kPeak, kContinuous);
    double last = kPeak;
    double warmest = 0;
    for (int i = 0; i < 600'000; ++i) {
        const double force = heat.bound();
        ASSERT_LE(force, last + 1e-12);
        ASSERT_GT(force, last - 0.005) << "no step that a hand feels";
        heat.add(force, kTick, 0);
        warmest = std::max(warmest, heat.heat());
        last = force;
    }
    EXPECT_NEAR(last, kContinuous, 0.02);
    EXPECT_LE(warmest, 1);
}

TEST(MotorThermalModel, ThreeSecondsOfFullForceAreAllowed) {
    MotorThermalModel heat(kPeak, kContinuous);
    for (int i = 0; i < 3000; ++i) heat.add(kPeak, kTick, 0);
    EXPECT_EQ(heat.bound(), kPeak);
}

TEST(MotorThermalModel, CoolsWithoutForce) {
    MotorThermalModel heat(kPeak, kContinuous);
    for (int i = 0; i < 60'000; ++i) heat.add(heat.bound(), kTick, 0);
    EXPECT_LT(heat.bound(), kPeak);
    for (int i = 0; i < 60'000; ++i) heat.add(0, kTick, 0);
    EXPECT_EQ(heat.bound(), kPeak);
}

TEST(MotorThermalModel, TheReportedTemperatureCountsIfItIsHigher) {
    MotorThermalModel heat(kPeak, kContinuous);
    heat.add(0, kTick, 1.0);
    EXPECT_EQ(heat.bound(), kContinuous);
    heat.add(0, kTick, 0.9);
    EXPECT_NEAR(heat.bound(), (kPeak + kContinuous) / 2, 1e-12);
    heat.add(0, kTick, 0.2);
    EXPECT_EQ(heat.bound(), kPeak);
}

TEST(MotorThermalModel, WithoutAContinuousForceThereIsNoLimit) {
    MotorThermalModel heat(kPeak, std::numeric_limits<double>::infinity());
    for (int i = 0; i < 600'000; ++i) heat.add(kPeak, kTick, 0);
    EXPECT_EQ(heat.bound(), kPeak);
}

TEST(MotorThermalModel, ANumberThatIsNotFiniteMakesTheMotorsWarmUntilTheyCool) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        for (int place = 0; place < 3; ++place) {
            MotorThermalModel heat(kPeak, kContinuous);
            EXPECT_FALSE(heat.add(place == 0 ? bad : 1, place == 1 ? bad : kTick, place == 2 ? bad : 0));
            EXPECT_EQ(heat.bound(), kContinuous);
            for (int i = 0; i < 60'000; ++i) EXPECT_TRUE(heat.add(0, kTick, 0));
            EXPECT_EQ(heat.bound(), kPeak);
        }
    }
}

}  // namespace
}  // namespace tactooth
