// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A session in which nothing can be taken back, and whose recording is signed.
#include <gtest/gtest.h>

#include <algorithm>

#include "live/udp_listener.h"
#include "model/model_scene.h"
#include "session/live/live_stream.h"
#include "session/model/session_model.h"
#include "session/recording/recording_seal.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

class ExaminationSession : public ::testing::Test {
protected:
    void begin() {
        model_.setExamination(true);
        model_.recordTo(RecordingFolder(folder_.path()), key_);
        model_.install(test::blockTooth());
        model_.install(test::flatSessionBur());
        (void)model_.step(0);
        ASSERT_TRUE(model_.runner() != nullptr);
    }
    [[nodiscard]] double removed() { return total(model_.runner()->feed().removed()); }
    void goOnFor(double seconds) {
        const double since = model_.log().seconds();
        ASSERT_TRUE(test::stepUntil(model_, [&] { return model_.log().seconds() > since + seconds; }));
    }

    test::TemporaryFolder folder_;
    const std::shared_ptr<const SigningKey> key_ = SigningKey::make();
    test::SpySound sound_;
    SessionModel model_{sound_, test::runInline};
};

TEST_F(ExaminationSession, NothingIsTakenBackAndTheRecordingIsSigned) {
    begin();
    EXPECT_TRUE(model_.isSealing());
    EXPECT_FALSE(model_.isTouched());
    test::cutBlock(model_);
    EXPECT_TRUE(model_.isTouched());
    const double cut = removed();
    model_.undo();
    model_.goTo(0);
    model_.redo();
    model_.resetTooth();
    goOnFor(0.3);
    EXPECT_EQ(removed(), cut);
    model_.finishRecording();
    const fs::path file = fs::directory_iterator(folder_.path())->path();
    const auto recording = SessionRecording::open(file);
    ASSERT_TRUE(recording) << recording.error().message();
    EXPECT_EQ(checkRecordingSeal(*recording, key_->publicKey()).value().verdict, SealReport::Verdict::Intact);
    int edits = 0;
    ASSERT_TRUE(recording->forEach([&](const SessionEvent& event) {
        edits += std::holds_alternative<EditEvent>(event) ? 1 : 0;
        return true;
    }));
    EXPECT_EQ(edits, 0);
}

TEST_F(ExaminationSession, AfterwardsUndoWorksAgain) {
    begin();
    test::cutBlock(model_);
    model_.setExamination(false);
    model_.undo();
    EXPECT_TRUE(test::stepUntil(model_, [&] { return removed() == 0; }));
}

TEST_F(ExaminationSession, ARecordingThatRunsUnsignedIsReplacedByASignedOneIfNothingWasTouched) {
    model_.recordTo(RecordingFolder(folder_.path()));
    model_.install(test::blockTooth());
    model_.install(test::flatSessionBur());
    (void)model_.step(0);
    ASSERT_TRUE(model_.isRecording() && !model_.isSealing());
    model_.recordTo(RecordingFolder(folder_.path()), key_);
    EXPECT_TRUE(test::stepUntil(model_, [&] { return model_.runner() != nullptr && model_.isSealing(); }));
    test::cutBlock(model_);
    model_.finishRecording();
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

/// No numbers: neither on the screen nor anywhere else.
TEST_F(ExaminationSession, SendsNoTicks) {
    const test::UdpListener listener;
    auto stream = LiveStream::open(listener.url());
    ASSERT_TRUE(stream) << stream.error().message();
    model_.streamTo(std::move(*stream));
    begin();
    goOnFor(0.2);
    EXPECT_FALSE(listener.hasDatagram());
    model_.setExamination(false);
    EXPECT_EQ(listener.next().size(), kStreamBytes);
}

}  // namespace
}  // namespace tactooth
