// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <random>
#include <thread>

#include "bench_scene.h"
#include "devices/simulated/scripted_device.h"
#include "geometry/util/messages.h"
#include "journal/file/messages.h"
#include "session/live/live_runner.h"
#include "session/recording/session_recorder.h"
#include "session/recording/session_recording.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr double kSeconds = 30;

/// A live session that cuts a block all the time.
void record(const fs::path& file) {
    const auto block = test::blockOnTheBench();
    auto recorder = SessionRecorder::create(file, *block, "block");
    ASSERT_TRUE(recorder) << recorder.error().message();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> across(-1.3, 1.3), down(-0.8, 0.4);
    std::vector<DeviceKeyframe> strokes = {{0, {test::at(0, 0, 0.4), 1, 0, true}}};
    for (double time = 0.1; time < kSeconds; time += 0.12)
        strokes.push_back({time, {test::at(across(random), across(random), down(random)), 1, 0, true}});
    ScriptedDevice device(std::move(strokes));
    const Instrument bur = test::flatBur();
    const auto lanes = (*recorder)->begin({bur, HapticSettings{}});
    SessionControls controls;
    controls.cutting = true;
    std::atomic<double> time = 0;
    {
        const LiveRunner runner(
            block, bur, {}, device, [&](const Tick& tick) { time = tick.time; }, 1000, {}, nullptr, controls, lanes);
        while (time < kSeconds) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    (*recorder)->end();
    ASSERT_GT(total(block->removed()), 1);
    ASSERT_TRUE((*recorder)->close(block->hash()));
}

/// Half a minute of cutting, and what a crash could leave of it: the file opens up to its last whole block, and without
/// a whole header it is refused. The blocks are only checked here; `OfAnyLengthOpensAndReplaysWhatIsLeft` plays them.
TEST(CutAtEveryByte, ARecordingOpensToItsLastWholeBlock) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "s.ttsession";
    ASSERT_NO_FATAL_FAILURE(record(file));
    const auto whole = SessionRecording::open(file);
    ASSERT_TRUE(whole) << whole.error().message();
    ASSERT_TRUE(whole->journal().isComplete());
    ASSERT_GE(whole->seconds().value(), kSeconds);
    const std::span<const BlockPlace> blocks = whole->journal().blocks();
    ASSERT_GT(blocks.size(), 60U) << "two blocks of events for each second";
    const std::uint64_t header = blocks.front().offset, bytes = whole->journal().bytes();
    std::size_t left = blocks.size();
    for (std::uint64_t size = bytes; size-- > 0;) {
        ASSERT_EQ(::truncate(file.c_str(), static_cast<off_t>(size)), 0);
        while (left > 0 && blocks[left - 1].end() > size) --left;
        const auto cut = SessionRecording::open(file);
        ASSERT_EQ(cut.has_value(), size >= header) << size;
        if (!cut) {
            EXPECT_TRUE(cut.error().contains(size == 0 ? msg::kNoJournal : msg::kJournalHeadDamaged)) << size;
            continue;
        }
        const JournalReader& journal = cut->journal();
        ASSERT_EQ(journal.blocks().size(), left) << size;
        const std::uint64_t end = left == 0 ? header : blocks[left - 1].end();
        ASSERT_EQ(journal.cutOffAt(), end == size ? std::nullopt : std::optional(end)) << size;
        ASSERT_FALSE(journal.isComplete()) << size;
    }
    RecordProperty("bytes", static_cast<int>(bytes));
    RecordProperty("blocks", static_cast<int>(blocks.size()));
}

}  // namespace
}  // namespace tactooth
