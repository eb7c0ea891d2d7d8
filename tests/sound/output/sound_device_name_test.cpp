// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Runs beside openal_output_test.cpp, which has selected OpenAL's null driver for this program.
#include "sound/output/sound_device_name.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(SoundDeviceName, TheNullDriverIsKnown) {
    EXPECT_TRUE(isNullSoundDevice(defaultSoundDevice())) << defaultSoundDevice();
    EXPECT_FALSE(isNullSoundDevice("Built-in Audio Analog Stereo"));
    EXPECT_FALSE(isNullSoundDevice(""));
}

}  // namespace
}  // namespace tactooth
