// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/device_enumeration.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "standin/pen_folder.h"
#include "standin/standin_haply.h"
#include "standin/standin_hd.h"

namespace tactooth {
namespace {

using test::PenFolder;
using test::ScopedVariable;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// No pen is configured.
class DeviceEnumeration : public ::testing::Test {
    PenFolder noPens_{{}};
};

DetectedDevice named(const std::string& name, const std::vector<DetectedDevice>& devices) {
    const auto found = std::ranges::find(devices, name, &DetectedDevice::name);
    return found == devices.end() ? DetectedDevice{} : *found;
}

constexpr const char* kNobody = "localhost:1";  // no service listens here

std::vector<DetectedDevice> devicesWith(const char* library, const std::string& haply = kNobody) {
    const ScopedVariable pen("TACTOOTH_LIBHD", library);
    const ScopedVariable arm("TACTOOTH_HAPLY", haply);
    return enumerateDevices();
}

/// The names of the devices that are pens, in their order.
std::vector<std::string> pensOf(const std::vector<DetectedDevice>& devices) {
    std::vector<std::string> names;
    for (const DetectedDevice& device : devices) {
        if (device.backend.starts_with("OpenHaptics")) names.push_back(device.name);
    }
    return names;
}

DetectedDevice penWith(const char* library) {
    const auto devices = devicesWith(library);
    EXPECT_EQ(devices.front().name, "mouse");
    EXPECT_EQ(devices.front().state, DeviceState::Ready);
    EXPECT_EQ(named("inverse3", devices).state, DeviceState::NotFound);
    EXPECT_THAT(named("inverse3", devices).text, HasSubstr("install and start it"));
    EXPECT_THAT(pensOf(devices), ElementsAre("pen"));
    return named("pen", devices);
}

TEST_F(DeviceEnumeration, ReportsWhatAPenCanDo) {
    const DetectedDevice pen = penWith(TACTOOTH_STANDIN_HD);
    EXPECT_EQ(pen.state, DeviceState::Ready);
    EXPECT_EQ(pen.capabilities.force, 3.3);
    EXPECT_EQ(pen.capabilities.continuousForce, 0.88);
    EXPECT_EQ(pen.capabilities.workspace, Vec3(160, 70, 120));
    EXPECT_EQ(pen.capabilities.stiffness, 0.5);
    EXPECT_EQ(pen.capabilities.buttons, 2);
    EXPECT_EQ(pen.text,
              "Touch (stand-in): force 3.3 N, 0.9 N for ever; workspace 160.0 x 70.0 x 120.0 mm; stiffest wall 0.5 "
              "N/mm; 2 buttons");
}

TEST_F(DeviceEnumeration, ALibraryThatCrashesIsReportedAndHarmless) {
    const DetectedDevice pen = penWith(TACTOOTH_CRASHING_HD);
    EXPECT_EQ(pen.state, DeviceState::Unusable);
    EXPECT_FALSE(pen.capabilities.force);
    EXPECT_THAT(pen.text, HasSubstr("is broken, it crashes"));
}

TEST_F(DeviceEnumeration, ALibraryOfAnotherVersionIsNamed) {
    const DetectedDevice pen = penWith(TACTOOTH_LACKING_HD);
    EXPECT_EQ(pen.state, DeviceState::Unusable);
    EXPECT_THAT(pen.text, HasSubstr("it is another version"));
}

TEST_F(DeviceEnumeration, NoLibraryIsNoPenAndSaysWhatToInstall) {
    const DetectedDevice pen = penWith("libNoSuchHD.so");
    EXPECT_EQ(pen.state, DeviceState::NotFound);
    EXPECT_THAT(pen.text, HasSubstr("install the device's driver"));
}

/// The child process inherits the stand-in's state from this process.
const test::HdStandinControl& standin() {
    static const auto* const control = static_cast<const test::HdStandinControl*>(
        dlsym(dlopen(TACTOOTH_STANDIN_HD, RTLD_LAZY | RTLD_GLOBAL), "standinControl"));
    return *control;
}

TEST_F(DeviceEnumeration, APenInUseIsNotUsableAndOneThatIsUnpluggedIsNotThere) {
    const auto penAt = [](test::HdFault fault) {
        standin().reset();
        standin().setFault(static_cast<int>(fault));
        DetectedDevice pen = penWith(TACTOOTH_STANDIN_HD);
        standin().reset();
        return pen;
    };
    const DetectedDevice held = penAt(test::HdFault::InUse);
    EXPECT_EQ(held.state, DeviceState::Unusable);
    EXPECT_THAT(held.text, HasSubstr("close the other program"));
    const DetectedDevice unplugged = penAt(test::HdFault::Unplugged);
    EXPECT_EQ(unplugged.state, DeviceState::NotFound);
    EXPECT_THAT(unplugged.text, HasSubstr("check its cable"));
}

TEST_F(DeviceEnumeration, HasALineForEachPenThatIsSetUp) {
    const PenFolder pens({"Left", "Default Device", "Right"});
    const auto devices = devicesWith(TACTOOTH_STANDIN_HD);
    EXPECT_THAT(pensOf(devices), ElementsAre("pen", "pen:Left", "pen:Right"));
    EXPECT_TRUE(named("pen", devices).text.starts_with("Touch (stand-in): force 3.3 N"));
    for (const std::string name : {"Left", "Right"}) {
        const DetectedDevice pen = named("pen:" + name, devices);
        EXPECT_EQ(pen.state, DeviceState::Ready);
        EXPECT_TRUE(pen.text.starts_with("Touch (stand-in) '" + name + "': force 3.3 N")) << pen.text;
        EXPECT_EQ(pen.capabilities.force, 3.3);
    }
}

TEST_F(DeviceEnumeration, HasNoLineForADefaultPenThatIsNotSetUpBesideOthers) {
    const PenFolder pens({"Right"});
    EXPECT_THAT(pensOf(devicesWith(TACTOOTH_STANDIN_HD)), ElementsAre("pen:Right"));
}

TEST_F(DeviceEnumeration, EachPenSaysForItselfWhyItIsNotReady) {
    const PenFolder pens({"Left", "Right", "Third"});  // names that the stand-in does not know
    standin().reset();
    standin().setFault(static_cast<int>(test::HdFault::LinkFault));
    standin().setFaultyPen(1);
    const auto devices = devicesWith(TACTOOTH_STANDIN_HD);
    standin().reset();
    EXPECT_EQ(named("pen:Right", devices).state, DeviceState::Ready);
    const DetectedDevice left = named("pen:Left", devices);
    EXPECT_EQ(left.state, DeviceState::NotFound);
    EXPECT_THAT(left.text, HasSubstr("the device 'Left': The device does not answer: check its cable"));
    const DetectedDevice third = named("pen:Third", devices);
    EXPECT_EQ(third.state, DeviceState::Unusable);
    EXPECT_THAT(third.text, HasSubstr("the device 'Third': look its name up in the vendor's setup program"));
    const auto none = devicesWith("libNoSuchHD.so");
    EXPECT_EQ(named("pen:Left", none).state, DeviceState::NotFound);
    EXPECT_THAT(named("pen:Left", none).text, HasSubstr("install the device's driver"));
}

std::vector<DetectedDevice> devicesWith(const test::StandinHaply& service) {
    return devicesWith("libNoSuchHD.so", service.address());
}

TEST_F(DeviceEnumeration, HasALineForEachInverse3) {
    const test::StandinHaply service;
    const auto devices = devicesWith(service);
    const DetectedDevice first = named("inverse3:049D", devices);
    EXPECT_EQ(first.state, DeviceState::Ready);
    EXPECT_EQ(
        first.text,
        "Haply Inverse3 049D: force 10.0 N, 2.5 N for ever; workspace 300.0 x 200.0 x 300.0 mm; stiffest wall 0.8 "
        "N/mm; 3 buttons");
    EXPECT_EQ(first.capabilities.force, 10);
    EXPECT_EQ(first.capabilities.buttons, 3);
    EXPECT_THAT(named("inverse3:0B1C", devices).text, HasSubstr("0 buttons"));
}

TEST_F(DeviceEnumeration, AServiceWithoutAnInverse3IsNoInverse3AndOneOfAnotherVersionIsOfNoUse) {
    test::StandinHaply service;
    service.setFirstMessage(R"({"inverse3": []})");
    const DetectedDevice none = named("inverse3", devicesWith(service));
    EXPECT_EQ(none.state, DeviceState::NotFound);
    EXPECT_THAT(none.text, HasSubstr("check its cable"));
    service.setFirstMessage(R"({"version": "2.0", "inverse3": []})");
    const DetectedDevice old = named("inverse3", devicesWith(service));
    EXPECT_EQ(old.state, DeviceState::Unusable);
    EXPECT_THAT(old.text, HasSubstr("install version 3"));
}

TEST_F(DeviceEnumeration, WhatIsNotPluggedInSaysWhatToDo) {
    const ScopedVariable socket("SPNAV_SOCKET", "/no/such/socket");
    const auto devices = enumerateDevices();
    EXPECT_THAT(named("spacemouse", devices).text, HasSubstr("install spacenavd"));
    for (const char* name : {"gamepad", "pedal"}) {
        const DetectedDevice device = named(name, devices);
        EXPECT_TRUE(device.state == DeviceState::Ready || device.text.starts_with("There is no")) << device.text;
    }
}

}  // namespace
}  // namespace tactooth
