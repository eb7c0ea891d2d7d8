// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "sound/material_sounds.h"
#include "sound/output/audio_libraries.h"
#include "sound/output/openal_output.h"
#include "spectrum.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

void waitForStatus(const SoundOutput& output, SoundStatus status) {
    for (const auto start = Clock::now(); output.status() != status && Clock::now() - start < 5s;) {
        std::this_thread::sleep_for(1ms);
    }
}

TEST(SilentMachine, StartsSaysSoAndStopsWithinASecond) {
    const auto start = Clock::now();
    {
        OpenAlOutput output;
        waitForStatus(output, SoundStatus::Silent);
        EXPECT_EQ(output.status(), SoundStatus::Silent);
        EXPECT_EQ(statusText(output.status()).english, "no sound card: silent");
        EXPECT_EQ(output.playedBlocks(), 0u);
    }
    EXPECT_LT(Clock::now() - start, 1s);
}

TEST(SilentMachine, TakesStatesAndVolumesAsUsual) {
    OpenAlOutput output;
    output.setMixer({.muted = true});
    output.setPlacement({});
    for (int i = 0; i < 100000; ++i) output.publish(test::cutting("enamel", 5.0));
    waitForStatus(output, SoundStatus::Silent);
    EXPECT_EQ(output.status(), SoundStatus::Silent);
}

TEST(SilentMachine, WritesNothingToTheErrorStream) {
    prepareAudioLibraries();
    testing::internal::CaptureStderr();
    {
        OpenAlOutput output;
        waitForStatus(output, SoundStatus::Silent);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace tactooth
