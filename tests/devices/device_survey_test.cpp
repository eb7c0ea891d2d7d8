// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/device_survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "standin/standin_haply.h"

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
    EXPECT_TRUE(devices.front().ready);
    EXPECT_FALSE(named("inverse3", devices).ready);
    EXPECT_THAT(named("inverse3", devices).text, HasSubstr("install and start it"));
    return named("pen", devices);
}

TEST(DeviceSurvey, TellsWhatAPenCanDo) {
    const SurveyedDevice pen = penWith(TACTOOTH_STANDIN_HD);
    EXPECT_TRUE(pen.ready);
    EXPECT_EQ(pen.text,
              "Touch (stand-in): force 3.3 N, 0.9 N for ever; workspace 160.0 x 70.0 x 120.0 mm; stiffest wall 0.5 "
              "N/mm; 2 buttons");
}

TEST(DeviceSurvey, ALibraryThatCrashesIsReportedAndHarmless) {
    const SurveyedDevice pen = penWith(TACTOOTH_CRASHING_HD);
    EXPECT_FALSE(pen.ready);
    EXPECT_THAT(pen.text, HasSubstr("is broken, it crashes"));
}

TEST(DeviceSurvey, ALibraryOfAnotherVersionIsNamed) {
    EXPECT_THAT(penWith(TACTOOTH_LACKING_HD).text, HasSubstr("it is another version"));
}

TEST(DeviceSurvey, NoLibraryIsNoPenAndSaysWhatToInstall) {
    const SurveyedDevice pen = penWith("libNoSuchHD.so");
    EXPECT_FALSE(pen.ready);
    EXPECT_THAT(pen.text, HasSubstr("install the device's driver"));
}

TEST(DeviceSurvey, HasALineForEachInverse3) {
    const test::StandinHaply service;
    setenv("TACTOOTH_LIBHD", "libNoSuchHD.so", 1);
    setenv("TACTOOTH_HAPLY", service.address().c_str(), 1);
    const auto devices = surveyDevices();
    unsetenv("TACTOOTH_LIBHD");
    unsetenv("TACTOOTH_HAPLY");
    const SurveyedDevice first = named("inverse3:049D", devices);
    EXPECT_TRUE(first.ready);
    EXPECT_EQ(
        first.text,
        "Haply Inverse3 049D: force 10.0 N, 2.5 N for ever; workspace 300.0 x 200.0 x 300.0 mm; stiffest wall 0.8 "
        "N/mm; 3 buttons");
    EXPECT_THAT(named("inverse3:0B1C", devices).text, HasSubstr("0 buttons"));
}

TEST(DeviceSurvey, WhatIsNotPluggedInSaysWhatToDo) {
    setenv("SPNAV_SOCKET", "/no/such/socket", 1);
    const auto devices = surveyDevices();
    unsetenv("SPNAV_SOCKET");
    EXPECT_THAT(named("spacemouse", devices).text, HasSubstr("install spacenavd"));
    for (const char* name : {"gamepad", "pedal"}) {
        const SurveyedDevice device = named(name, devices);
        EXPECT_TRUE(device.ready || device.text.starts_with("There is no")) << device.text;
    }
}

}  // namespace
}  // namespace tactooth
