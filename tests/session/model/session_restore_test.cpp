// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/session_restore.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "model/expect_replays.h"
#include "model/model_scene.h"
#include "session/recording/session_recording.h"
#include "session/recording/session_replay.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    return files;
}

/// A session that is recorded; its hand cuts the block.
class RecordedSession : public ::testing::Test {
protected:
    void begin(SessionModel& model) {
        model.recordTo(RecordingFolder(folder_.path()));
        model.install(test::blockTooth());
        model.install(test::flatSessionBur());
        (void)model.step(0);
        ASSERT_TRUE(model.runner() != nullptr && model.isRecording());
        model.describeWork(R"({"title":"Own block","bur":"Flat","seconds":7,"events":[]})");
    }
    /// What a crash would leave: a copy of the recording while it is written.
    fs::path copyOfLive() const {
        const fs::path copy = crashed_ / "live-1-0.ttsession";
        for (const fs::path& file : filesIn(folder_.path())) fs::copy_file(file, copy);
        return copy;
    }

    test::TemporaryFolder folder_, crashed_;
    test::SpySound sound_;
};

TEST_F(RecordedSession, IsKeptUnderTheNameOfItsToothAndReplays) {
    std::uint64_t hash = 0;
    {
        SessionModel model(sound_, test::runInline);
        begin(model);
        test::cutBlock(model);
        model.finishRecording();
        hash = model.tooth()->piece->hash();
    }
    ASSERT_EQ(filesIn(folder_.path()).size(), 1U);
    const fs::path file = filesIn(folder_.path()).front();
    EXPECT_THAT(file.string(), EndsWith(" Block.ttsession"));
    test::expectReplays(file, hash);
}

TEST_F(RecordedSession, InWhichNothingWasTouchedLeavesNothing) {
    {
        SessionModel model(sound_, test::runInline);
        begin(model);
    }
    EXPECT_TRUE(filesIn(folder_.path()).empty());
}

TEST_F(RecordedSession, AnotherToothGetsAnotherRecordingAndABurDoesNot) {
    SessionModel model(sound_, test::runInline);
    begin(model);
    test::cutBlock(model);
    model.install(test::flatSessionBur());
    (void)model.step(0);
    EXPECT_EQ(filesIn(folder_.path()).size(), 1U);
    model.install(test::blockTooth());
    ASSERT_TRUE(test::stepUntil(model, [&] { return !model.isPreparing(); }));
    EXPECT_EQ(filesIn(folder_.path()).size(), 2U) << "the one before is complete";
    EXPECT_TRUE(model.isRecording());
    model.stopRecording();
    EXPECT_FALSE(model.isRecording());
    EXPECT_EQ(filesIn(folder_.path()).size(), 1U) << "nothing was touched in the second one";
}

TEST_F(RecordedSession, GoesOnInAnotherModel) {
    SessionModel model(sound_, test::runInline);
    begin(model);
    test::cutBlock(model);
    const SessionTooth tooth = *model.tooth();
    {
        SessionModel other(sound_, test::runInline);
        other.adopt(model.releaseKeeper());
        other.install(tooth);
        other.install(test::flatSessionBur());
        (void)other.step(0);
        EXPECT_TRUE(other.isRecording());
        EXPECT_EQ(filesIn(folder_.path()).size(), 1U);
    }
    const auto recording = SessionRecording::open(filesIn(folder_.path()).front());
    ASSERT_TRUE(recording) << recording.error().message();
    auto replay = SessionReplay::start(*recording);
    ASSERT_TRUE(replay && replay->playUntil({}, {}));
    EXPECT_FALSE(replay->differsAt());
}

TEST_F(RecordedSession, AFolderThatCannotBeUsedIsSaidOnceAndTheSessionGoesOn) {
    SessionModel model(sound_, test::runInline);
    model.recordTo(RecordingFolder("/proc/nowhere"));
    model.install(test::blockTooth());
    model.install(test::flatSessionBur());
    int sentences = 0;
    EXPECT_TRUE(test::stepUntil(model, [&] { return model.runner() != nullptr && !model.log().ticks().empty(); }));
    for (int i = 0; i < 3; ++i) sentences += model.step(0).recordingFault ? 1 : 0;
    EXPECT_LE(sentences, 1);
    EXPECT_FALSE(model.isRecording());
    test::cutBlock(model);
}

TEST_F(RecordedSession, ComesBackAfterACrashWithItsCutsTimeAndEvents) {
    double removed = 0;
    std::vector<CutEvent> events;
    {
        SessionModel model(sound_, test::runInline);
        begin(model);
        test::cutBlock(model);
        removed = total(model.runner()->feed().removed());
        events = model.log().events().all();
        // The recorder writes each half second, on a busy machine later.
        const double since = model.log().seconds(), cut = model.log().newest().time;
        const auto isWritten = [&] {
            const auto recording = SessionRecording::open(filesIn(folder_.path()).front());
            if (!recording) return false;
            const auto seconds = recording->seconds();
            return seconds && *seconds > cut + 0.5;
        };
        ASSERT_TRUE(test::stepUntil(model, [&] { return model.log().seconds() > since + 1 && isWritten(); }));
        (void)copyOfLive();
    }
    const RecordingFolder folder(crashed_.path());
    std::vector<Leftover> found = folder.leftovers();
    ASSERT_EQ(found.size(), 1U);
    const auto facts = examine(found.front(), folder);
    ASSERT_TRUE(facts);
    EXPECT_EQ(facts->title, "Own block");
    RestoreProgress progress;
    const auto tooth = restoreSession(found.front(), progress);
    ASSERT_TRUE(tooth) << tooth.error().message();
    EXPECT_EQ(total(tooth->piece->removed()), removed);
    EXPECT_EQ(tooth->name, "Own block");
    EXPECT_GT(tooth->work.seconds, 0.5);
    ASSERT_FALSE(tooth->work.events.empty());
    EXPECT_EQ(tooth->work.events.front().kind, events.front().kind);
    EXPECT_TRUE(tooth->importNotes.empty());
    ASSERT_TRUE(tooth->bur);
    EXPECT_GT(progress.part, 0.5);

    SessionModel again(sound_, test::runInline);
    again.install(*tooth);
    (void)again.step(0);
    ASSERT_NE(again.runner(), nullptr) << "with its bur";
    EXPECT_TRUE(again.isModified()) << "no file of the user holds the cuts";
    EXPECT_GE(again.log().seconds(), tooth->work.seconds);
    again.markSaved(again.runner()->feed().removed());
    EXPECT_FALSE(again.isModified());
}

TEST_F(RecordedSession, WithoutCutsIsNotOfferedAndGoes) {
    {
        SessionModel model(sound_, test::runInline);
        begin(model);
        (void)copyOfLive();
    }
    const RecordingFolder folder(crashed_.path());
    for (const Leftover& leftover : folder.leftovers()) EXPECT_FALSE(examine(leftover, folder));
    EXPECT_TRUE(filesIn(crashed_.path()).empty());
}

TEST_F(RecordedSession, ARestorationCanBeStopped) {
    {
        SessionModel model(sound_, test::runInline);
        begin(model);
        test::cutBlock(model);
        (void)copyOfLive();
    }
    const std::vector<Leftover> found = RecordingFolder(crashed_.path()).leftovers();
    ASSERT_EQ(found.size(), 1U);
    RestoreProgress progress;
    progress.stops = true;
    EXPECT_FALSE(restoreSession(found.front(), progress));
    EXPECT_EQ(filesIn(crashed_.path()).size(), 1U) << "the file stays";
}

TEST_F(RecordedSession, IsModifiedFromTheFirstCutUntilItIsSavedOrUndone) {
    SessionModel model(sound_, test::runInline);
    EXPECT_FALSE(model.isModified());
    begin(model);
    EXPECT_FALSE(model.isModified());
    test::cutBlock(model);
    EXPECT_TRUE(model.isModified());
    model.markSaved(model.runner()->feed().removed());
    EXPECT_FALSE(model.isModified());
    model.undo();
    const auto removed = [&] { return total(model.runner()->feed().removed()); };
    EXPECT_TRUE(test::stepUntil(model, [&] { return removed() == 0; }));
    EXPECT_FALSE(model.isModified()) << "a whole tooth is no loss";
    model.redo();
    EXPECT_TRUE(test::stepUntil(model, [&] { return removed() > 0; }));
    EXPECT_FALSE(model.isModified()) << "it is that of the file";
    const MaterialVolumes before = model.runner()->feed().removed();
    test::cutBlock(model);
    EXPECT_TRUE(model.isModified());
    model.markSaved(before);
    EXPECT_TRUE(model.isModified()) << "what was cut while the file was written is not in it";
}

TEST_F(RecordedSession, ASavedToothGoesOnWhereOneStopped) {
    SessionModel model(sound_, test::runInline);
    begin(model);
    test::cutBlock(model);
    const SessionWork work{.title = "Block",
                           .bur = burCatalogue().front().name,
                           .seconds = model.log().seconds(),
                           .events = model.log().events().all()};
    const fs::path file = crashed_ / "a.tactooth";
    ASSERT_TRUE(saveTooth(*model.tooth()->piece, {}, file));
    EXPECT_EQ(loadSessionTooth({.outer = file, .layers = {}}).value().work.seconds, 0) << "an old file";
    const auto bytes = savedToothBytes(model.runner()->snapshot().get(), {}, workText(work));
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const auto tooth = loadSessionTooth({.outer = file, .layers = {}});
    ASSERT_TRUE(tooth) << tooth.error().message();
    EXPECT_EQ(tooth->work.seconds, work.seconds);
    EXPECT_EQ(tooth->work.events.size(), work.events.size());
    ASSERT_TRUE(tooth->bur);
    EXPECT_EQ(tooth->bur->name, work.bur);
    SessionModel again(sound_, test::runInline);
    again.install(*tooth);
    (void)again.step(0);
    EXPECT_FALSE(again.isModified());
    EXPECT_EQ(again.log().events().all().size(), work.events.size());
    EXPECT_GE(again.log().seconds(), work.seconds);
}

}  // namespace
}  // namespace tactooth
