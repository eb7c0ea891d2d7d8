// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "devices/device_survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace tactooth {
namespace {

using ::testing::HasSubstr;

SurveyedDevice penWith(const char* library) {
    setenv("TACTOOTH_LIBHD", library, 1);
    const auto devices = surveyDevices();
    unsetenv("TACTOOTH_LIBHD");
    EXPECT_EQ(devices.size(), 2U);
    EXPECT_EQ(devices[0].name, "mouse");
    EXPECT_TRUE(devices[0].ready);
    EXPECT_EQ(devices[1].name, "pen");
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

}  // namespace
}  // namespace tactooth
