// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/device_survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "standin/standin_haply.h"

namespace tactooth {
namespace {

using ::testing::HasSubstr;

SurveyedDevice penWith(const char* library) {
    setenv("TACTOOTH_LIBHD", library, 1);
    setenv("TACTOOTH_HAPLY", "localhost:1", 1);  // where nobody listens
    const auto devices = surveyDevices();
    unsetenv("TACTOOTH_LIBHD");
    unsetenv("TACTOOTH_HAPLY");
    EXPECT_EQ(devices.size(), 3U);
    EXPECT_EQ(devices[0].name, "mouse");
    EXPECT_TRUE(devices[0].ready);
    EXPECT_EQ(devices[1].name, "pen");
    EXPECT_EQ(devices[2].name, "inverse3");
    EXPECT_FALSE(devices[2].ready);
    EXPECT_THAT(devices[2].text, HasSubstr("install and start it"));
    return devices[1];
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
    ASSERT_EQ(devices.size(), 4U);
    EXPECT_EQ(devices[2].name, "inverse3:049D");
    EXPECT_TRUE(devices[2].ready);
    EXPECT_EQ(
        devices[2].text,
        "Haply Inverse3 049D: force 10.0 N, 2.5 N for ever; workspace 300.0 x 200.0 x 300.0 mm; stiffest wall 0.8 "
        "N/mm; 3 buttons");
    EXPECT_EQ(devices[3].name, "inverse3:0B1C");
    EXPECT_THAT(devices[3].text, HasSubstr("0 buttons"));
}

}  // namespace
}  // namespace tactooth
