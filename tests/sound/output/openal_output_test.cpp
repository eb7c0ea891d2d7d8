// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Runs on OpenAL's own "No Output" device: the complete path of the samples in real time, without sound.
#include "sound/output/openal_output.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "sound/files/sound_format.h"
#include "sound/material_sounds.h"
#include "sound/output/audio_libraries.h"
#include "spectrum.h"
#include "support/heap_counter.h"
#include "support/sanitizer.h"

namespace tactooth {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

[[maybe_unused]] const bool isPrepared = [] {
    setenv("ALSOFT_DRIVERS", "null", 1);
    prepareAudioLibraries();
    return true;
}();

void waitForBlocks(const OpenAlOutput& output, std::uint64_t blocks) {
    for (const auto start = Clock::now(); output.playedBlocks() < blocks && Clock::now() - start < 5s;) {
        std::this_thread::sleep_for(1ms);
    }
}

TEST(OpenAlOutput, PlaysInRealTime) {
    OpenAlOutput output;
    waitForBlocks(output, 10);
    ASSERT_EQ(output.status(), SoundStatus::Playing);
    const auto start = Clock::now();
    const std::uint64_t before = output.playedBlocks();
    while (Clock::now() - start < 1s) {
        output.publish(test::cutting("enamel", 5.0));
        std::this_thread::sleep_for(1ms);
    }
    const double seconds = static_cast<double>(output.playedBlocks() - before) * kSoundBlock / kSoundRate;
    const double passed = std::chrono::duration<double>(Clock::now() - start).count();
    EXPECT_NEAR(seconds, passed, 0.1);
    EXPECT_LE(output.underruns(), 2u);  // a busy machine may wake the thread late
}

TEST(OpenAlOutput, StartsAndStopsWithinASecondAgainAndAgain) {
    const auto start = Clock::now();
    for (int i = 0; i < 5; ++i) {
        OpenAlOutput output;
        waitForBlocks(output, 1);
        EXPECT_EQ(output.status(), SoundStatus::Playing);
    }
    EXPECT_LT(Clock::now() - start, 5s);
}

TEST(OpenAlOutput, StopsAtOnceEvenBeforeItHasStarted) {
    const auto start = Clock::now();
    for (int i = 0; i < 5; ++i) const OpenAlOutput output;
    EXPECT_LT(Clock::now() - start, 2s);
}

TEST(OpenAlOutput, TakesStatesVolumesAndPlacesFromTwoThreads) {
    OpenAlOutput output({.seed = 3, .headphones = true});
    std::jthread servo([&](const std::stop_token& stop) {
        for (int i = 0; !stop.stop_requested(); ++i) {
            output.publish(test::cutting(i % 100 < 50 ? "enamel" : "caries", 0.1 * (i % 100)));
            std::this_thread::sleep_for(200us);
        }
    });
    std::uint64_t before = 0;
    for (int i = 0; i < 100; ++i) {
        output.setMixer({.master = 0.01 * i, .muted = i % 10 == 0});
        output.setPlacement({{0.1 * i, 0.0, -100.0}, {}});
        std::this_thread::sleep_for(5ms);
        EXPECT_GE(output.playedBlocks(), before);
        before = output.playedBlocks();
    }
    EXPECT_GT(before, 50u);
}

TEST(OpenAlOutput, FromAParameterToItsSampleItTakesAtMostThirtyMilliseconds) {
    OpenAlOutput output;
    waitForBlocks(output, 20);
    std::vector<double> latencies;
    for (int i = 0; i < 1000; ++i) {
        output.publish(test::cutting("enamel", 5.0));
        latencies.push_back(output.latency());
        std::this_thread::sleep_for(1ms);
    }
    std::sort(latencies.begin(), latencies.end());
    EXPECT_GT(latencies.front(), 0.005);  // less than the buffer of the device would be a wrong measurement
    EXPECT_LT(latencies[latencies.size() / 2], 0.030);
    if (test::isSanitized()) return;  // its threads come late
    EXPECT_LT(latencies[latencies.size() * 95 / 100], 0.030);
}

TEST(OpenAlOutput, PlayingUsesNoHeapOfOurs) {
    OpenAlOutput output;
    waitForBlocks(output, 50);
    const long before = test::heapCalls();
    const std::uint64_t played = output.playedBlocks();
    for (int i = 0; i < 300; ++i) {
        output.publish(test::cutting(i % 2 == 0 ? "enamel" : "caries", 0.1 * i));
        output.setMixer({.master = 0.001 * i});
        output.setPlacement({{0.1 * i, 0.0, -100.0}, {}});
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_GT(output.playedBlocks(), played + 50);
    EXPECT_EQ(test::heapCalls(), before);
}

TEST(OpenAlOutput, ChangesToHeadphonesAndBackWhilePlaying) {
    OpenAlOutput output;
    for (const bool headphones : {true, false}) {
        output.setHeadphones(headphones);
        waitForBlocks(output, output.playedBlocks() + 50);
        EXPECT_EQ(output.status(), SoundStatus::Playing);
    }
    EXPECT_GE(output.playedBlocks(), 100u);
}

TEST(OpenAlOutput, TwoOutputsDoNotDisturbEachOther) {
    OpenAlOutput first, second;
    waitForBlocks(first, 50);
    waitForBlocks(second, 50);
    EXPECT_GE(first.playedBlocks(), 50u);
    EXPECT_GE(second.playedBlocks(), 50u);
}

}  // namespace
}  // namespace tactooth
