// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/open_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "virtual_pad.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

TEST(OpenDevice, KnowsItsKindsAndTheMouseComesFirst) {
    EXPECT_STREQ(deviceKinds().front().name, "mouse");
    for (const char* name : {"joystick", "", ":", "spacemouse:left", "mouse"}) {
        const auto opened = openDevice(name);
        ASSERT_FALSE(opened) << name;
        for (const DeviceKind& kind : deviceKinds()) EXPECT_THAT(opened.error().message, HasSubstr(kind.name));
    }
}

TEST(OpenDevice, OpensAGamepadByItsName) {
    const test::VirtualPad pad("Test Pad");
    const auto opened = openDevice("gamepad:Test");
    ASSERT_TRUE(opened);
    EXPECT_EQ((*opened)->info().name, "Test Pad");
    EXPECT_FALSE(openDevice("gamepad:Other"));
}

TEST(OpenDevice, SaysWhatIsMissing) {
    setenv("TACTOOTH_LIBHD", "libNoSuchHD.so", 1);
    EXPECT_THAT(openDevice("pen").error().message, HasSubstr("install the device's driver"));
    unsetenv("TACTOOTH_LIBHD");
}

}  // namespace
}  // namespace tactooth
