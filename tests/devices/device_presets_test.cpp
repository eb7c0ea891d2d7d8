// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/device_presets.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(DevicePresets, AreFoundByName) {
    EXPECT_EQ(devicePresets().size(), 5U);
    for (const DevicePreset& preset : devicePresets()) EXPECT_EQ(findDevicePreset(preset.name), &preset);
    for (const HandPreset& preset : handPresets()) EXPECT_EQ(findHandPreset(preset.name), &preset);
    EXPECT_EQ(findDevicePreset("joystick"), nullptr);
    EXPECT_EQ(findHandPreset(""), nullptr);
}

TEST(DevicePresets, TheLimiterKeepsToTheDevicesNumbers) {
    const ForceLimits limits = limitsOf(*findDevicePreset("touch"));
    EXPECT_EQ(limits.force, 3.3);
    EXPECT_EQ(limits.continuousForce, 0.88);
    EXPECT_EQ(limits.slew, 300);
}

TEST(DevicePresets, AFirmerHandIsHeavierStifferAndDampsMore) {
    for (std::size_t i = 1; i < handPresets().size(); ++i) {
        EXPECT_GT(handPresets()[i].mass, handPresets()[i - 1].mass);
        EXPECT_GT(handPresets()[i].stiffness, handPresets()[i - 1].stiffness);
        EXPECT_GT(handPresets()[i].damping, handPresets()[i - 1].damping);
    }
}

}  // namespace
}  // namespace tactooth
