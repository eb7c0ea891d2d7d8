// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A session in which nothing can be taken back, and whose recording is signed.
#include <gtest/gtest.h>

#include <algorithm>

#include "devices/simulated/scripted_device.h"
#include "model/model_scene.h"
#include "session/model/session_model.h"
#include "session/recording/recording_seal.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

class ExaminationSession : public ::testing::Test {
protected:
    void begin() {
        model_.setEditsAllowed(false);
        model_.recordTo(RecordingFolder(folder_.path()), key_);
        model_.install(test::blockTooth());
        model_.install(test::flatSessionBur());
        (void)model_.step(0);
        ASSERT_TRUE(model_.runner() != nullptr);
    }
    void cut() {
        const auto at = [](double time, double z) {
            return DeviceKeyframe{time, {.hand = {Vec3(0, 0, z), Quat::Identity()}, .pedal = 1}};
        };
        std::vector<DeviceKeyframe> script{at(0, 1), at(0.2, 1), at(0.4, -0.4), at(0.8, -0.4), at(1, 1)};
        model_.setCutting(true);
        model_.install(DeviceSlot::First, std::make_unique<ScriptedDevice>(std::move(script), "press", true));
        ASSERT_TRUE(test::stepUntil(model_, [&] { return model_.runner() != nullptr && removed() > 0.01; }));
        waitForCarving();
    }
    [[nodiscard]] double removed() { return total(model_.runner()->feed().removed()); }
    /// The hand has left the tooth, and a long time (in ticks) has passed since anything was removed.
    void waitForCarving() {
        constexpr std::uint32_t kQuiet = 300;
        double before = -1;
        std::uint32_t since = 0;
        ASSERT_TRUE(test::stepUntil(model_, [&] {
            const Tick& tick = model_.log().newest();
            const double now = removed();
            if (now != before || tick.contacts > 0 || tick.hand.position.z() < 0.9) before = now, since = tick.number;
            return tick.number > since + kQuiet;
        }));
    }
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
    cut();
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
    EXPECT_EQ(checkRecordingSeal(*recording, key_->publicKey())->verdict, SealReport::Verdict::Intact);
    int edits = 0;
    ASSERT_TRUE(recording->forEach([&](const SessionEvent& event) {
        edits += std::holds_alternative<EditEvent>(event) ? 1 : 0;
        return true;
    }));
    EXPECT_EQ(edits, 0);
}

TEST_F(ExaminationSession, AfterwardsUndoWorksAgain) {
    begin();
    cut();
    model_.setEditsAllowed(true);
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
    cut();
    model_.finishRecording();
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace tactooth
