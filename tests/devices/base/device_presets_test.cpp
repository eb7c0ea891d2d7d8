// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/base/device_presets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tactooth {
namespace {

TEST(DevicePresets, AreFoundByName) {
    EXPECT_EQ(devicePresets().size(), 5U);
    for (const DevicePreset& preset : devicePresets()) EXPECT_EQ(findDevicePreset(preset.name), &preset);
    for (const HandImpedance& preset : handImpedances()) EXPECT_EQ(findHandImpedance(preset.name), &preset);
    EXPECT_EQ(findDevicePreset("joystick"), nullptr);
    EXPECT_EQ(findHandImpedance(""), nullptr);
}

TEST(DevicePresets, TheLimiterKeepsToTheDevicesNumbers) {
    const ForceLimits limits = limitsOf(*findDevicePreset("touch"));
    EXPECT_EQ(limits.force, 3.3);
    EXPECT_EQ(limits.continuousForce, 0.88);
    EXPECT_EQ(limits.slew, 300);
}

TEST(DevicePresets, OfDriverAndModelTheSmallerForceCounts) {
    const DevicePreset& touch = *findDevicePreset("touch");
    EXPECT_EQ(limitsOf(touch, 2, 0.5).force, 2);
    EXPECT_EQ(limitsOf(touch, 2, 0.5).continuousForce, 0.5);
    EXPECT_EQ(limitsOf(touch, 50, 40).force, 3.3);
    EXPECT_EQ(limitsOf(touch, 50, 40).continuousForce, 0.88);
    EXPECT_EQ(limitsOf(touch, 0.2, 0.88).force, 0.2) << "however small";
    EXPECT_EQ(limitsOf(touch, 0.2, 0.88).continuousForce, 0.2) << "no force for ever beyond that for a moment";
    for (const double none : {0.0, -3.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(limitsOf(touch, none, none).force, 3.3) << none;
        EXPECT_EQ(limitsOf(touch, none, none).continuousForce, 0.88) << none;
    }
    EXPECT_LT(limitsOf(touch, 2, 0.5).power, limitsOf(touch).power);
}

/// A bare arm that the stiffest wall throws back, from the point where its force is the peak force: numerical
/// integration against the formula.
TEST(DevicePresets, ThePowerIsTwiceThatOfAWallThatThrowsTheBareArmBack) {
    for (const DevicePreset& preset : devicePresets()) {
        double depth = preset.peakForce / preset.stiffness;
        double speed = 0;
        double most = 0;
        constexpr double kStep = 1e-6;
        while (depth > 0) {
            speed += kStep * preset.stiffness * depth / preset.inertia;
            depth -= kStep * speed;
            most = std::max(most, preset.stiffness * depth * speed);
        }
        EXPECT_NEAR(limitsOf(preset).power, 2 * most, 1e-3 * most) << preset.name;
        EXPECT_GT(limitsOf(preset).power / preset.peakForce, 500) << "mm/s: full force at any speed of a working hand";
    }
    EXPECT_NEAR(ForceLimits{}.power, limitsOf(*findDevicePreset("touch")).power, 1);
}

TEST(DevicePresets, AFirmerHandIsHeavierStifferAndDampsMore) {
    for (std::size_t i = 1; i < handImpedances().size(); ++i) {
        EXPECT_GT(handImpedances()[i].mass, handImpedances()[i - 1].mass);
        EXPECT_GT(handImpedances()[i].stiffness, handImpedances()[i - 1].stiffness);
        EXPECT_GT(handImpedances()[i].damping, handImpedances()[i - 1].damping);
    }
}

}  // namespace
}  // namespace tactooth
