// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/device_survey.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "standin/standin_haply.h"
#include "standin/standin_hd.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

SurveyedDevice named(const std::string& name, const std::vector<SurveyedDevice>& devices) {
    const auto found = std::ranges::find(devices, name, &SurveyedDevice::name);
    return found == devices.end() ? SurveyedDevice{} : *found;
}

SurveyedDevice penWith(const char* library) {
    setenv("TACTOOTH_LIBHD", library, 1);
    setenv("TACTOOTH_HAPLY", "localhost:1", 1);  // where nobody listens
    const auto devices = surveyDevices();
    unsetenv("TACTOOTH_LIBHD");
    unsetenv("TACTOOTH_HAPLY");
    EXPECT_EQ(devices.front().name, "mouse");
    EXPECT_EQ(devices.front().state, DeviceState::Ready);
    EXPECT_EQ(named("inverse3", devices).state, DeviceState::NotThere);
    EXPECT_THAT(named("inverse3", devices).text, HasSubstr("install and start it"));
    return named("pen", devices);
}

TEST(DeviceSurvey, TellsWhatAPenCanDo) {
    const SurveyedDevice pen = penWith(TACTOOTH_STANDIN_HD);
    EXPECT_EQ(pen.state, DeviceState::Ready);
    EXPECT_EQ(pen.abilities.force, 3.3);
    EXPECT_EQ(pen.abilities.continuousForce, 0.88);
    EXPECT_EQ(pen.abilities.workspace, Vec3(160, 70, 120));
    EXPECT_EQ(pen.abilities.stiffness, 0.5);
    EXPECT_EQ(pen.abilities.buttons, 2);
    EXPECT_EQ(pen.text,
              "Touch (stand-in): force 3.3 N, 0.9 N for ever; workspace 160.0 x 70.0 x 120.0 mm; stiffest wall 0.5 "
              "N/mm; 2 buttons");
}

TEST(DeviceSurvey, ALibraryThatCrashesIsReportedAndHarmless) {
    const SurveyedDevice pen = penWith(TACTOOTH_CRASHING_HD);
    EXPECT_EQ(pen.state, DeviceState::NotUsable);
    EXPECT_FALSE(pen.abilities.force);
    EXPECT_THAT(pen.text, HasSubstr("is broken, it crashes"));
}

TEST(DeviceSurvey, ALibraryOfAnotherVersionIsNamed) {
    const SurveyedDevice pen = penWith(TACTOOTH_LACKING_HD);
    EXPECT_EQ(pen.state, DeviceState::NotUsable);
    EXPECT_THAT(pen.text, HasSubstr("it is another version"));
}

TEST(DeviceSurvey, NoLibraryIsNoPenAndSaysWhatToInstall) {
    const SurveyedDevice pen = penWith("libNoSuchHD.so");
    EXPECT_EQ(pen.state, DeviceState::NotThere);
    EXPECT_THAT(pen.text, HasSubstr("install the device's driver"));
}

/// The child has the stand-in as it is here.
TEST(DeviceSurvey, APenInUseIsNotUsableAndOneThatIsUnpluggedIsNotThere) {
    const auto* const standin = static_cast<const test::HdStandinControl*>(
        dlsym(dlopen(TACTOOTH_STANDIN_HD, RTLD_LAZY | RTLD_GLOBAL), "standinControl"));
    const auto penAt = [&](test::HdFault fault) {
        standin->reset();
        standin->setFault(static_cast<int>(fault));
        SurveyedDevice pen = penWith(TACTOOTH_STANDIN_HD);
        standin->reset();
        return pen;
    };
    const SurveyedDevice held = penAt(test::HdFault::InUse);
    EXPECT_EQ(held.state, DeviceState::NotUsable);
    EXPECT_THAT(held.text, HasSubstr("close the other program"));
    const SurveyedDevice unplugged = penAt(test::HdFault::Unplugged);
    EXPECT_EQ(unplugged.state, DeviceState::NotThere);
    EXPECT_THAT(unplugged.text, HasSubstr("check its cable"));
}

std::vector<SurveyedDevice> devicesWith(const test::StandinHaply& service) {
    setenv("TACTOOTH_LIBHD", "libNoSuchHD.so", 1);
    setenv("TACTOOTH_HAPLY", service.address().c_str(), 1);
    auto devices = surveyDevices();
    unsetenv("TACTOOTH_LIBHD");
    unsetenv("TACTOOTH_HAPLY");
    return devices;
}

TEST(DeviceSurvey, HasALineForEachInverse3) {
    const test::StandinHaply service;
    const auto devices = devicesWith(service);
    const SurveyedDevice first = named("inverse3:049D", devices);
    EXPECT_EQ(first.state, DeviceState::Ready);
    EXPECT_EQ(
        first.text,
        "Haply Inverse3 049D: force 10.0 N, 2.5 N for ever; workspace 300.0 x 200.0 x 300.0 mm; stiffest wall 0.8 "
        "N/mm; 3 buttons");
    EXPECT_EQ(first.abilities.force, 10);
    EXPECT_EQ(first.abilities.buttons, 3);
    EXPECT_THAT(named("inverse3:0B1C", devices).text, HasSubstr("0 buttons"));
}

TEST(DeviceSurvey, AServiceWithoutAnInverse3IsNoInverse3AndOneOfAnotherVersionIsOfNoUse) {
    test::StandinHaply service;
    service.setFirstMessage(R"({"inverse3": []})");
    const SurveyedDevice none = named("inverse3", devicesWith(service));
    EXPECT_EQ(none.state, DeviceState::NotThere);
    EXPECT_THAT(none.text, HasSubstr("check its cable"));
    service.setFirstMessage(R"({"version": "2.0", "inverse3": []})");
    const SurveyedDevice old = named("inverse3", devicesWith(service));
    EXPECT_EQ(old.state, DeviceState::NotUsable);
    EXPECT_THAT(old.text, HasSubstr("install version 3"));
}

TEST(DeviceSurvey, WhatIsNotPluggedInSaysWhatToDo) {
    setenv("SPNAV_SOCKET", "/no/such/socket", 1);
    const auto devices = surveyDevices();
    unsetenv("SPNAV_SOCKET");
    EXPECT_THAT(named("spacemouse", devices).text, HasSubstr("install spacenavd"));
    for (const char* name : {"gamepad", "pedal"}) {
        const SurveyedDevice device = named(name, devices);
        EXPECT_TRUE(device.state == DeviceState::Ready || device.text.starts_with("There is no")) << device.text;
    }
}

}  // namespace
}  // namespace tactooth
