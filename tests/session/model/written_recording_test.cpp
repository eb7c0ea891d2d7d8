// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The recording of a work can be read while the session pauses, and goes on afterwards.
#include <gtest/gtest.h>

#include "model/model_scene.h"
#include "session/model/session_model.h"
#include "session/recording/session_recording.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

class WrittenRecording : public ::testing::Test {
protected:
    void cutBlock() {
        model_.install(test::blockTooth());
        model_.install(test::flatSessionBur());
        (void)model_.step(0);
        ASSERT_TRUE(model_.runner() != nullptr);
        test::cutBlock(model_);
    }

    test::TemporaryFolder folder_;
    test::SpySound sound_;
    SessionModel model_{sound_, test::runInline};
};

TEST_F(WrittenRecording, HoldsAllThatHasHappenedSoFar) {
    model_.recordTo(RecordingFolder(folder_.path()));
    cutBlock();
    model_.setPaused(true);
    const std::filesystem::path file = model_.writtenRecording();
    const auto recording = SessionRecording::open(file);
    ASSERT_TRUE(recording) << recording.error().message();
    EXPECT_TRUE(*recording->hasChanges());
    EXPECT_GE(*recording->seconds(), model_.log().newest().time);
}

TEST_F(WrittenRecording, GoesOnAfterwards) {
    model_.recordTo(RecordingFolder(folder_.path()));
    cutBlock();
    model_.setPaused(true);
    const std::uint64_t before = SessionRecording::open(model_.writtenRecording()).value().ticks();
    model_.setPaused(false);
    ASSERT_TRUE(test::stepUntil(model_, [&] {  // a busy machine leaves ticks out
        return model_.runner() != nullptr && model_.runner()->feed().timing().ticks > 200 &&
               model_.log().newest().time > 0.2;
    }));
    EXPECT_TRUE(model_.isRecording());
    EXPECT_GT(SessionRecording::open(model_.writtenRecording()).value().ticks(), before + 100);
    EXPECT_TRUE(test::stepUntil(model_, [&] { return model_.runner() != nullptr; }));
}

TEST_F(WrittenRecording, IsThatOfTheSameToothAfterItsEnd) {
    model_.recordTo(RecordingFolder(folder_.path()));
    cutBlock();
    const std::filesystem::path live = model_.writtenRecording();
    model_.stopRecording();
    const std::filesystem::path ended = model_.writtenRecording();
    EXPECT_NE(ended, live);
    EXPECT_TRUE(SessionRecording::open(ended));
    model_.install(test::blockTooth());
    (void)model_.step(0);
    EXPECT_TRUE(model_.writtenRecording().empty());
}

/// Who listens learns the final name once, and gets back what it prepared when the recording ended.
TEST_F(WrittenRecording, ItsEndIsHeardWithTheFinalName) {
    int endings = 0;
    std::vector<std::pair<int, std::filesystem::path>> heard;
    model_.setRecordingEnding([&] {
        return [&, number = ++endings](const std::filesystem::path& file) { heard.emplace_back(number, file); };
    });
    model_.recordTo(RecordingFolder(folder_.path()));
    cutBlock();
    EXPECT_EQ(endings, 0);
    model_.install(test::blockTooth());
    (void)model_.step(0);
    (void)model_.writtenRecording();
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(heard.front().first, 1);
    EXPECT_EQ(RecordingFolder(folder_.path()).finished(), std::vector{heard.front().second});
    model_.finishRecording();
    EXPECT_EQ(heard.size(), 1U) << "nothing was touched, so that nothing was kept";
}

TEST_F(WrittenRecording, ItsEndIsHeardByTheModelThatGoesOn) {
    int first = 0, second = 0;
    model_.setRecordingEnding([&] { return [&](const std::filesystem::path&) { ++first; }; });
    model_.recordTo(RecordingFolder(folder_.path()));
    cutBlock();
    std::unique_ptr<SessionKeeper> keeper = model_.releaseKeeper();
    SessionModel other(sound_, test::runInline);
    other.setRecordingEnding([&] { return [&](const std::filesystem::path&) { ++second; }; });
    other.adopt(std::move(keeper));
    other.finishRecording();
    EXPECT_EQ(first, 0);
    EXPECT_EQ(second, 1);
}

TEST_F(WrittenRecording, IsEmptyWhereNothingIsRecorded) {
    cutBlock();
    EXPECT_TRUE(model_.writtenRecording().empty());
}

}  // namespace
}  // namespace tactooth
