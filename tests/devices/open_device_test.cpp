// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/open_device.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <span>
#include <string>

#include "devices/probe/device_backend.h"
#include "devices/process/hand_process_device.h"
#include "standin/pen_folder.h"
#include "standin/standin_hd.h"
#include "support/scoped_variable.h"
#include "support/test_data.h"
#include "virtual_pad.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

/// The names of these kinds as a message lists them.
std::string listed(std::span<const DeviceBackend> kinds) {
    std::string names;
    for (const DeviceBackend& kind : kinds) names += (names.empty() ? "" : ", ") + std::string(kind.name);
    return names;
}

TEST(OpenDevice, KnowsItsKindsAndTheMouseComesFirst) {
    EXPECT_STREQ(deviceBackends().front().name, "mouse");
    for (const char* name : {"joystick", "", ":", "spacemouse:left", "mouse"}) {
        const auto opened = openDevice(name);
        ASSERT_FALSE(opened) << name;
        for (const DeviceBackend& kind : deviceBackends()) EXPECT_THAT(opened.error().message(), HasSubstr(kind.name));
    }
}

TEST(OpenDevice, KnowsANameWithoutOpeningIt) {
    for (const char* name : {"mouse", "pen", "pen:Left", "inverse3:049D", "gamepad:Wireless", "spacemouse"}) {
        EXPECT_TRUE(checkDeviceName(name, "--device")) << name;
    }
    for (const char* name : {"joystick", "", ":", "spacemouse:left", "mouse:2", "none", "Pen"}) {
        const auto known = checkDeviceName(name, "--device");
        ASSERT_FALSE(known) << name;
        EXPECT_THAT(known.error().message(), HasSubstr("--device takes " + listed(deviceBackends())));
    }
}

TEST(OpenDevice, KnowsThatTheSecondHandHasNoMouse) {
    for (const char* name : {"none", "pen:Left", "spacemouse"}) {
        EXPECT_TRUE(checkDeviceName(name, "--second-device", true)) << name;
    }
    for (const char* name : {"mouse", "bogus"}) {
        EXPECT_THAT(checkDeviceName(name, "--second-device", true).error().message(),
                    HasSubstr("--second-device takes none, " + listed(deviceBackends().subspan(1))))
            << name;
    }
}

TEST(OpenDevice, OpensAGamepadByItsName) {
    const test::VirtualPad pad("Test Pad");  // there is none in another process
    const test::ScopedVariable here("TACTOOTH_DEVICE_IN_PROCESS", "1");
    const auto opened = openDevice("gamepad:Test");
    ASSERT_TRUE(opened);
    EXPECT_EQ((*opened)->info().name, "Test Pad");
    EXPECT_FALSE(openDevice("gamepad:Other"));
}

TEST(OpenDevice, OpensADeviceInAProcessOfItsOwn) {
    const test::PenFolder noPens({});
    const test::ScopedVariable library("TACTOOTH_LIBHD", TACTOOTH_STANDIN_HD);
    for (const bool isInProcess : {false, true}) {
        const test::ScopedVariable host("TACTOOTH_DEVICE_IN_PROCESS", isInProcess ? "1" : "0");
        const auto opened = openDevice("pen");
        ASSERT_TRUE(opened);
        EXPECT_EQ(dynamic_cast<const HandProcessDevice*>(opened->get()) == nullptr, isInProcess);
        EXPECT_EQ((*opened)->info().name, "Touch (stand-in)");
        EXPECT_TRUE((*opened)->drivesServoRate());
    }
}

TEST(OpenDevice, SaysWhatIsMissing) {
    setenv("TACTOOTH_LIBHD", "libNoSuchHD.so", 1);
    EXPECT_THAT(openDevice("pen").error().message(), HasSubstr("install the device's driver"));
    unsetenv("TACTOOTH_LIBHD");
}

/// Error of openDevice with another library for the pen.
std::string penError(const std::string& library) {
    setenv("TACTOOTH_LIBHD", library.c_str(), 1);
    const auto opened = openDevice("pen");
    unsetenv("TACTOOTH_LIBHD");
    return opened ? "" : opened.error().message();
}

TEST(OpenDevice, ALibraryThatCrashesDoesNotTakeTheProgramWithIt) {
    EXPECT_THAT(penError(TACTOOTH_CRASHING_HD), HasSubstr("is broken, it crashes"));
    EXPECT_THAT(penError(TACTOOTH_CRASHING_HD), HasSubstr("install the device's driver anew"))
        << "and not later, either";
}

TEST(OpenDevice, ALibraryThatCrashesWhenItStartsADeviceDoesNotEither) {
    const test::ScopedVariable here("TACTOOTH_DEVICE_IN_PROCESS", "1");  // the test steers the library
    const test::TemporaryFolder folder;
    const auto library = folder / "crashing_start_hd.so";
    std::filesystem::create_symlink(TACTOOTH_STANDIN_HD, library);
    const auto& standin = *static_cast<const test::HdStandinControl*>(
        dlsym(dlopen(TACTOOTH_STANDIN_HD, RTLD_LAZY | RTLD_GLOBAL), "standinControl"));
    standin.reset();
    standin.setFault(static_cast<int>(test::HdFault::CrashAtStart));
    EXPECT_THAT(penError(library), HasSubstr("is broken, it crashes"));
    EXPECT_EQ(standin.startedPens(), 0);
    standin.reset();
    EXPECT_EQ(penError(library), "") << "mended";
}

}  // namespace
}  // namespace tactooth
