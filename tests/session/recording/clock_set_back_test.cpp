// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The clock of the computer is set back while sessions are recorded: names, orders and lengths stay right, and nothing
// is overwritten.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bench_scene.h"
#include "recording/aged_file.h"
#include "session/recording/kept_recording.h"
#include "session/recording/session_recording.h"
#include "session/recording/session_replay.h"
#include "support/test_data.h"
#include "track/stepped_session.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::EndsWith;

/// A clock that a test sets.
class SetClock {
public:
    [[nodiscard]] RecordingFolder::Now now() {
        return [this] { return time_; };
    }
    void advance(std::chrono::seconds by) { time_ += by; }

private:
    std::chrono::system_clock::time_point time_ = std::chrono::system_clock::now();
};

constexpr std::size_t kBytes = 900;  // of a file

/// So many ticks above the block and into it.
void work(SessionRecorder& recorder, const std::shared_ptr<CutModel>& block, int from, int to,
          std::unique_ptr<test::SteppedSession>& session) {
    const HapticSettings settings;
    if (session == nullptr) {
        session = std::make_unique<test::SteppedSession>(block, test::flatBur(), settings,
                                                         recorder.begin({test::flatBur(), settings}));
    }
    for (int i = from; i < to; ++i) session->step({test::at(0, 0, 0.5 - 1e-3 * i), 1, true});
}

TEST(ClockSetBack, EachRecordingHasItsOwnNameAndItsLength) {
    const test::TemporaryFolder home;
    SetClock clock;
    const RecordingFolder folder(home.path(), RecordingFolder::kUsualBytes, clock.now());
    std::vector<fs::path> files;
    std::vector<std::uint64_t> hashes;
    for (const int ticks :
         {600, 800, 1000}) {  // the second begins in the minute of the first, the third an hour before
        const auto block = test::blockOnTheBench();
        const auto kept = KeptRecording::begin(folder, block, "Block", "{}");
        ASSERT_TRUE(kept) << kept.error().message();
        (*kept)->noteTouch();
        std::unique_ptr<test::SteppedSession> session;
        work((*kept)->recorder(), block, 0, ticks / 2, session);
        clock.advance(-1h);  // in mid-session
        work((*kept)->recorder(), block, ticks / 2, ticks, session);
        (*kept)->recorder().end();
        clock.advance(ticks == 600 ? 1h : 0h);
        ASSERT_TRUE((*kept)->finish());
        files.push_back((*kept)->file());
        hashes.push_back(block->hash());
    }
    EXPECT_EQ(std::ranges::count_if(files, [](const fs::path& file) { return fs::exists(file); }), 3);
    EXPECT_THAT(files[1].string(), EndsWith(" Block (2).ttsession"));
    int i = 0;
    for (const double seconds : {0.6, 0.8, 1.0}) {
        const auto recording = SessionRecording::open(files[i]);
        ASSERT_TRUE(recording) << recording.error().message();
        EXPECT_TRUE(recording->journal().isComplete());
        EXPECT_NEAR(recording->seconds().value(), seconds, 0.002);
        auto replay = SessionReplay::start(*recording);
        ASSERT_TRUE(replay && replay->playUntil({}, {}));
        EXPECT_FALSE(replay->differsAt());
        EXPECT_EQ(replay->model().hash(), hashes[i++]);
    }
    auto newestFirst = files;
    std::ranges::reverse(newestFirst);
    EXPECT_EQ(folder.finished(), newestFirst);
}

/// Its file seems to be the oldest, and the folder is full.
TEST(ClockSetBack, TheNewestRecordingIsNotRemovedForTheOldest) {
    const test::TemporaryFolder home;
    SetClock clock;
    const RecordingFolder folder(home.path(), 2000, clock.now());
    test::makeFile(home / "2026-11-24 10.00 Molar.ttsession", kBytes, 2h);
    test::makeFile(home / "2026-11-25 10.00 Molar.ttsession", kBytes, 1h);
    test::makeFile(home / "live-1-0.ttsession", kBytes, 48h);
    clock.advance(-48h);
    const auto kept = folder.keep(home / "live-1-0.ttsession", clock.now()(), "Block");
    ASSERT_TRUE(kept) << kept.error().message();
    EXPECT_THAT(folder.finished(), ElementsAre(*kept, home / "2026-11-25 10.00 Molar.ttsession",
                                               home / "2026-11-24 10.00 Molar.ttsession"));
    folder.tidy();
    EXPECT_THAT(folder.finished(), ElementsAre(*kept, home / "2026-11-25 10.00 Molar.ttsession"));
}

/// Two sessions crashed, the second one after the clock was set back.
TEST(ClockSetBack, TheSessionThatBeganLastIsOfferedFirst) {
    const test::TemporaryFolder home;
    const RecordingFolder folder(home.path());
    const fs::path first = folder.liveName().value();
    test::makeFile(first, kBytes, 1h);
    const fs::path second = folder.liveName().value();
    test::makeFile(second, kBytes, 48h);
    const fs::path third = folder.autosaveName().value();
    test::makeFile(third, kBytes, 72h);
    std::vector<fs::path> offered;
    for (const Leftover& leftover : folder.leftovers()) offered.push_back(leftover.file());
    EXPECT_THAT(offered, ElementsAre(third, second, first));
}

}  // namespace
}  // namespace tactooth
