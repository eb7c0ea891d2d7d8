// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// A recording that stops in mid-session goes on in another file, which begins with the tooth as it is then.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>
#include <random>

#include "../journal/fake_journal_file.h"
#include "geometry/files/atomic_file.h"
#include "model/expect_replays.h"
#include "model/model_scene.h"
#include "session/model/session_restore.h"
#include "session/recording/messages.h"
#include "session/recording/session_parts.h"
#include "session/recording/session_recording.h"
#include "session/recording/session_replay.h"
#include "support/test_data.h"
#include "track/stepped_session.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::HasSubstr;

/// A block, and another one beside it that is cut as well.
std::shared_ptr<CutModel> twoBlocks() {
    TriangleMesh outer = test::box(Vec3(-1.5, -1.5, -3), Vec3(1.5, 1.5, 0));
    const auto first = static_cast<std::uint32_t>(outer.triangles.size());
    append(outer, test::box(Vec3(1.55, -1.5, -3), Vec3(4.5, 1.5, 0)));
    auto tooth = LayeredTooth::make(std::move(outer), {}, test::kDentin, {.firstAdjacent = first});
    return std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), test::kVoxel);
}

/// Strokes over both blocks and into them.
void cutAbout(test::SteppedSession& session, double seconds, unsigned seed, bool undoes = false) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> across(-1.3, 1.3), along(-1.3, 3.5), down(-0.8, 0.3);
    Vec3 from(0, 0, 0.5), to = from;
    const int ticks = static_cast<int>(seconds / test::SteppedSession::kPeriod);
    constexpr int kStroke = 150;  // ticks
    for (int i = 0; i < ticks; ++i) {
        if (i % kStroke == 0) from = to, to = Vec3(along(random), across(random), down(random));
        if (i == kStroke) to = Vec3(3, 0, -0.6);  // into the second block at any rate
        const double share = static_cast<double>(i % kStroke) / kStroke;
        session.step({{from + share * (to - from), Quat::Identity()}, 1, true});
        if (undoes && i % 900 == 899) session.edit(Edit::Undo);
    }
}

/// By the number of the part.
std::map<std::uint32_t, fs::path> partsIn(const fs::path& folder) {
    std::map<std::uint32_t, fs::path> parts;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const auto recording = SessionRecording::open(entry.path());
        if (recording) parts[recording->facts().part.number] = entry.path();
    }
    return parts;
}

class RecordingParts : public ::testing::TestWithParam<unsigned> {
protected:
    test::TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(Seeds, RecordingParts, ::testing::Values(1U, 2U));

TEST_P(RecordingParts, AReopenedToothIsRecordedExactly) {
    const auto model = twoBlocks();
    const Instrument bur = test::flatBur();
    const HapticSettings settings;
    test::SteppedSession before(model, bur, settings, std::make_shared<EventLanes>());
    cutAbout(before, 2, GetParam());
    const std::uint64_t hash = model->hash();
    const MaterialVolumes removed = model->removed();
    const TaggedMesh surface = model->exported();
    const CutHistory history = model->history();
    ASSERT_GT(model->loss().beside, 0) << "the sum of volumes is the only one that depends on the order";
    model->reopen();
    EXPECT_EQ(model->hash(), hash);
    EXPECT_EQ(model->removed(), removed);
    EXPECT_EQ(model->exported().mesh.vertices, surface.mesh.vertices);
    EXPECT_EQ(model->exported().mesh.triangles, surface.mesh.triangles);
    EXPECT_EQ(model->history(), history);

    auto recorder = SessionRecorder::create(folder_ / "s.ttsession", *model, "blocks");
    ASSERT_TRUE(recorder) << recorder.error().message();
    test::SteppedSession after(model, bur, settings, (*recorder)->begin({bur, settings}));
    cutAbout(after, 3, 100 + GetParam(), /*undoes=*/true);
    (*recorder)->end();
    ASSERT_TRUE((*recorder)->close(model->hash()));
    EXPECT_NE(model->hash(), hash);
    test::expectReplays(folder_ / "s.ttsession", model->hash());
    while (!model->history().done.empty()) ASSERT_TRUE(model->undo());
    EXPECT_EQ(total(model->removed()), 0) << "what was cut before can be undone as well";
}

/// More ticks than a queue holds come at once.
void overflow(EventLanes& lanes) {
    for (int i = 0; i < 10'000'000 && !lanes.hasOverflowed(); ++i) lanes.servo(TickEvent{});
    ASSERT_TRUE(lanes.hasOverflowed());
}

TEST_P(RecordingParts, AfterAFullQueueTheSessionGoesOnInAnotherFile) {
    const auto model = twoBlocks();
    const Instrument bur = test::flatBur();
    const HapticSettings settings;
    std::uint64_t hash = 0;
    {
        SessionKeeper keeper(test::runInline);
        keeper.setFolder(RecordingFolder(folder_.path()));
        keeper.prepare(model, "Blocks", workText({.title = "Blocks", .exercise = "class-1"}));
        ASSERT_TRUE(keeper.isReady());
        keeper.noteTouch();
        const auto lanes = keeper.begin({bur, settings});
        test::SteppedSession first(model, bur, settings, lanes);
        cutAbout(first, 1, GetParam());
        EXPECT_FALSE(keeper.canBeginPart());
        overflow(*lanes);
        cutAbout(first, 1, 50 + GetParam());  // nobody records it
        keeper.end();
        const auto fault = keeper.takeFault();
        ASSERT_TRUE(fault && fault->contains(msg::kRecordingOverflowed));
        EXPECT_FALSE(keeper.takeFault()) << "it is said once";
        ASSERT_TRUE(keeper.canBeginPart());
        model->reopen();
        keeper.beginPart({.seconds = 2, .isUnsaved = true}, model->history());
        ASSERT_TRUE(keeper.isReady());
        EXPECT_TRUE(keeper.isRecording());
        EXPECT_TRUE(keeper.takeResumed());
        test::SteppedSession second(model, bur, settings, keeper.begin({bur, settings}));
        cutAbout(second, 1, 90 + GetParam());
        keeper.end();
        hash = model->hash();
        keeper.finish();
        EXPECT_FALSE(keeper.takeFault());
    }
    const auto parts = partsIn(folder_.path());
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_THAT(parts.at(1).string(), EndsWith(" Blocks.ttsession"));
    EXPECT_THAT(parts.at(2).string(), EndsWith(" Blocks part 2.ttsession"));
    const auto first = SessionRecording::open(parts.at(1)), second = SessionRecording::open(parts.at(2));
    EXPECT_TRUE(first->end().value().hasGap);
    EXPECT_FALSE(second->end().value().hasGap);
    EXPECT_EQ(first->facts().part.session.size(), 16U);
    EXPECT_EQ(first->facts().part.session, second->facts().part.session);
    EXPECT_EQ(second->work()->exercise, "class-1");
    EXPECT_EQ(second->work()->seconds, 2);
    EXPECT_EQ(neighbourParts(parts.at(1), first->facts().part).behind, parts.at(2));
    EXPECT_FALSE(neighbourParts(parts.at(1), first->facts().part).before);
    EXPECT_EQ(neighbourParts(parts.at(2), second->facts().part).before, parts.at(1));
    EXPECT_FALSE(neighbourParts(parts.at(2), second->facts().part).behind);
    test::expectReplays(parts.at(2), hash);
}

/// The disk takes nothing for minutes: a block of events is lost, and what is recorded later leads nowhere.
TEST(RecordingGap, ALostBlockEndsTheRecording) {
    const auto disk = std::make_shared<test::FakeDisk>();
    const auto model = twoBlocks();
    const Instrument bur = test::flatBur();
    auto recorder = SessionRecorder::start(test::fileOn(disk), "disk", *model, "blocks");
    ASSERT_TRUE(recorder) << recorder.error().message();
    test::SteppedSession before(model, bur, HapticSettings{}, (*recorder)->begin({bur, HapticSettings{}}));
    cutAbout(before, 0.5, 1);
    test::SteppedSession session(model, bur, HapticSettings{}, (*recorder)->begin({bur, HapticSettings{}}));
    ASSERT_TRUE((*recorder)->flush());
    disk->hold();
    (*recorder)->describe("{}");
    ASSERT_TRUE(disk->waitUntilHeld());
    constexpr int kQueue = 1024;  // blocks (JournalWriter::Options)
    for (int i = 0; i < kQueue; ++i) (*recorder)->describe("{}");
    cutAbout(session, 0.5, 2);
    (*recorder)->end();
    EXPECT_FALSE((*recorder)->isWhole());
    ASSERT_TRUE((*recorder)->fault());
    EXPECT_TRUE((*recorder)->fault()->contains(msg::kRecordingOverflowed));
    disk->release();
    EXPECT_FALSE((*recorder)->close(model->hash()));
    const test::TemporaryFolder folder;
    const std::vector<std::byte> bytes = disk->bytes();
    ASSERT_TRUE(writeFile(folder / "s.ttsession", std::span<const std::byte>(bytes)));
    const auto recording = SessionRecording::open(folder / "s.ttsession");
    ASSERT_TRUE(recording) << recording.error().message();
    EXPECT_TRUE(recording->end().value().hasGap);
    auto replay = SessionReplay::start(*recording);
    ASSERT_TRUE(replay && replay->playUntil({}, {}));
    EXPECT_FALSE(replay->differsAt());
    EXPECT_GT(replay->ticks(), 0U);
}

/// A session of the window whose recording stops.
class StoppedRecording : public ::testing::Test {
protected:
    void begin() {
        model_.recordTo(RecordingFolder(place_));
        model_.install(test::blockTooth());
        model_.install(test::flatSessionBur());
        (void)model_.step(0);
        ASSERT_TRUE(model_.runner() != nullptr && model_.isRecording());
        model_.setCutting(true);
        press(-0.9);
    }
    /// Cuts into the block at this place along x, and lifts the bur.
    void press(double x) {
        const auto at = [&](double time, double z) {
            return DeviceKeyframe{time, {.hand = {Vec3(x, 0, z), Quat::Identity()}, .pedal = 1}};
        };
        const double before = removed();
        std::vector<DeviceKeyframe> script{at(0, 1), at(0.2, 1), at(0.4, -0.4), at(0.8, -0.4), at(1, 1)};
        model_.install(DeviceSlot::First, std::make_unique<ScriptedDevice>(std::move(script), "press", true));
        ASSERT_TRUE(step([&] {
            return model_.runner() != nullptr && removed() > before + 0.01 && model_.log().newest().time > 1.2;
        }));
    }
    bool step(const std::function<bool()>& condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (std::chrono::steady_clock::now() < end) {
            const SessionModel::StepResult result = model_.step(0.01);
            faults_ += result.recordingFault ? 1 : 0;
            resumed_ += result.recordingResumed ? 1 : 0;
            if (condition()) return true;
            std::this_thread::yield();
        }
        return false;
    }
    double removed() {
        return total(model_.runner() != nullptr ? model_.runner()->feed().removed() : model_.tooth()->piece->removed());
    }
    bool stopAndGoOn(const std::function<void()>& stop, const std::function<void()>& mend) {
        stop();
        if (!step([&] { return faults_ > 0; })) return false;
        EXPECT_FALSE(model_.isRecording());
        mend();
        return step([&] { return resumed_ > 0 && model_.isRecording() && model_.runner() != nullptr; });
    }

    test::TemporaryFolder home_;
    fs::path place_ = home_ / "recordings";
    test::SpySound sound_;
    SessionModel model_{sound_, test::runInline};
    int faults_ = 0, resumed_ = 0;
};

TEST_F(StoppedRecording, GoesOnInAFolderThatWasDeletedMeanwhile) {
    begin();
    ASSERT_TRUE(stopAndGoOn([&] { fs::remove_all(place_); }, [] {}));
    press(0.9);
    EXPECT_EQ(faults_, 1);
    model_.finishRecording();
    const auto parts = partsIn(place_);
    ASSERT_EQ(parts.size(), 1U) << "nobody brings back what the user has deleted";
    test::expectReplays(parts.at(2), model_.tooth()->piece->hash());
}

TEST_F(StoppedRecording, GoesOnWhenAFullDiskIsFreeAgain) {
    begin();
    struct rlimit before {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit few = before;
    few.rlim_cur = 1000;
    ASSERT_TRUE(stopAndGoOn(
        [&] {
            (void)::setrlimit(RLIMIT_FSIZE, &few);
            press(0);
        },
        [&] { (void)::setrlimit(RLIMIT_FSIZE, &before); }));
    std::signal(SIGXFSZ, handler);
    press(0.9);
    EXPECT_EQ(faults_, 1);
    model_.finishRecording();
    const auto parts = partsIn(place_);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_FALSE(SessionRecording::open(parts.at(1)).value().journal().isComplete());
    test::expectReplays(parts.at(2), model_.tooth()->piece->hash());
}

TEST_F(StoppedRecording, ComesBackAfterACrashWithAllThatWasCut) {
    begin();
    ASSERT_TRUE(stopAndGoOn([&] { fs::remove_all(place_); }, [] {}));
    const double seconds = model_.log().seconds();
    press(0.9);
    ASSERT_FALSE(model_.log().events().all().empty());
    const fs::path live = model_.writtenRecording();
    ASSERT_FALSE(live.empty());
    fs::create_directory(home_ / "crashed");
    fs::copy_file(live, home_ / "crashed/live-1-0.ttsession");
    const RecordingFolder folder(home_ / "crashed");
    const std::vector<Leftover> found = folder.leftovers();
    ASSERT_EQ(found.size(), 1U);
    ASSERT_TRUE(examine(found.front(), folder));
    RestoreProgress progress;
    const auto tooth = restoreSession(found.front(), progress);
    ASSERT_TRUE(tooth) << tooth.error().message();
    EXPECT_EQ(tooth->piece->hash(), model_.tooth()->piece->hash());
    EXPECT_GT(tooth->work.seconds, seconds);
    ASSERT_FALSE(tooth->work.events.empty());
    EXPECT_EQ(tooth->work.events.front().time, model_.log().events().all().front().time);
    EXPECT_TRUE(tooth->importNotes.empty());
}

/// What was cut before a part began is not in its file as a step. Undoing it ends that part, and another one begins.
TEST_F(StoppedRecording, WhatWasCutBeforeCanBeUndoneAndRedone) {
    begin();
    ASSERT_TRUE(stopAndGoOn([&] { fs::remove_all(place_); }, [] {}));
    const double first = removed();
    press(0.9);
    const double both = removed();
    const auto undoTo = [&](double left) {
        model_.undo();
        return step([&] { return model_.runner() != nullptr && removed() == left && model_.isRecording(); });
    };
    ASSERT_TRUE(undoTo(first)) << "the same file";
    ASSERT_TRUE(undoTo(0));
    model_.redo();
    ASSERT_TRUE(step([&] { return model_.runner() != nullptr && removed() == first; }));
    model_.redo();
    ASSERT_TRUE(step([&] { return model_.runner() != nullptr && removed() == both && model_.isRecording(); }));
    EXPECT_EQ(faults_, 1);
    model_.finishRecording();
    const auto parts = partsIn(place_);
    ASSERT_GE(parts.size(), 2U);
    EXPECT_EQ(parts.begin()->first, 2U);
    for (const auto& [number, file] : parts) {
        const auto recording = SessionRecording::open(file);
        EXPECT_EQ(recording->end().value().hasGap, number != parts.rbegin()->first) << number;
        auto replay = SessionReplay::start(*recording);
        ASSERT_TRUE(replay && replay->playUntil({}, {}));
        EXPECT_FALSE(replay->differsAt()) << number;
    }
    test::expectReplays(parts.rbegin()->second, model_.tooth()->piece->hash());
}

/// Notes the longest time between two ticks of the servo.
class WatchedDevice final : public HapticDevice {
public:
    using Clock = std::chrono::steady_clock;
    [[nodiscard]] const DeviceInfo& info() const override { return info_; }
    [[nodiscard]] Expected<void> open() override { return {}; }
    void close() override {}
    [[nodiscard]] DeviceSample read(double) override {
        const Clock::time_point now = Clock::now();
        if (last_ && watches) longest = std::max(longest.load(), std::chrono::duration<double>(now - *last_).count());
        last_ = now;
        return {.hand = {Vec3(0, 0, 20), Quat::Identity()}};
    }
    void write(const SafeWrench&) override {}

    std::atomic<bool> watches{false};
    std::atomic<double> longest{0};  // s

private:
    DeviceInfo info_;
    std::optional<Clock::time_point> last_;
};

/// The servo begins anew with the part, as with another bur, while the hand is off the tooth and feels no force. The
/// bound is for a busy machine; the property says how long it was.
TEST(RecordingPause, OfTheServoIsShort) {
    const test::TemporaryFolder home;
    test::SpySound sound;
    SessionModel model(sound);  // with its threads
    model.recordTo(RecordingFolder(home / "recordings"));
    model.install(makeSessionTooth(kBuiltinTeeth.front()).value());
    model.install(test::flatSessionBur());
    auto owned = std::make_unique<WatchedDevice>();
    WatchedDevice& device = *owned;
    model.install(DeviceSlot::First, std::move(owned));
    const auto until = [&](const std::function<bool(const SessionModel::StepResult&)>& condition) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (std::chrono::steady_clock::now() < end) {
            if (condition(model.step(0.01))) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    };
    ASSERT_TRUE(until([&](const auto&) { return model.isRecording() && model.log().newest().time > 1; }));
    fs::remove_all(home / "recordings");
    device.watches = true;
    ASSERT_TRUE(until([](const SessionModel::StepResult& step) { return step.recordingResumed; }));
    ASSERT_TRUE(until([&](const auto&) { return model.log().newest().time > 0.5; }));
    RecordProperty("pause_ms", static_cast<int>(1e3 * device.longest));
    EXPECT_LT(device.longest, 5);
    EXPECT_EQ(partsIn(home / "recordings").size(), 1U);
}

}  // namespace
}  // namespace tactooth
