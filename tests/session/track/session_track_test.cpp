// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/track/session_track.h"

#include <gmock/gmock.h>

#include <random>
#include <set>

#include "session/recording/session_replay.h"
#include "session/track/make_track.h"
#include "session/track/tooth_follower.h"
#include "session/track/track_tooth.h"
#include "support/test_data.h"
#include "track/recorded_strokes.h"

namespace tactooth {
namespace {

using test::RecordedStrokes;

struct Made {
    SessionRecording recording;
    std::shared_ptr<SessionTrack> track;
};

Made trackOf(const std::filesystem::path& file) {
    auto recording = SessionRecording::open(file);
    EXPECT_TRUE(recording) << recording.error().message();
    auto model = recording->makeModel();
    EXPECT_TRUE(model) << model.error().message();
    auto track = emptyTrack(*recording, **model);
    EXPECT_TRUE(track) << track.error().message();
    makeTrack(*recording, *model, **track);
    return {std::move(*recording), std::move(*track)};
}

/// The state of a replay at some moments, as an oracle.
struct Oracle {
    std::vector<std::uint64_t> moments;
    std::vector<std::uint64_t> hashes;
    std::vector<TaggedMesh> teeth;
    std::vector<ToothLoss> losses;
};

/// One replay for each moment: what `tactooth replay --until` does.
Oracle oracleOf(const Made& made, int count, unsigned seed) {
    std::mt19937 random(seed);
    Oracle oracle;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t moment = random() % (made.track->ticks() + 1);
        auto replay = SessionReplay::start(made.recording);
        const double time = made.track->tickBefore(moment).time;
        EXPECT_TRUE(replay->playUntil(moment == 0 ? -1 : time, {}));
        EXPECT_EQ(replay->ticks(), moment);
        oracle.moments.push_back(moment);
        oracle.hashes.push_back(replay->model().hash());
        oracle.teeth.push_back(replay->model().exported());
        oracle.losses.push_back(replay->model().loss());
    }
    return oracle;
}

TEST(SessionTrack, HasEachTickOfTheReplayBitForBit) {
    const test::TemporaryFolder folder;
    (void)RecordedStrokes().writeTo(folder / "s.ttsession");
    const Made made = trackOf(folder / "s.ttsession");
    EXPECT_TRUE(made.track->isFinished());
    EXPECT_FALSE(made.track->differsAt());
    EXPECT_FALSE(made.track->fault());
    auto replay = SessionReplay::start(made.recording);
    std::uint64_t moment = 0;
    bool same = true;
    const auto played = replay->playUntil({}, [&](double time, const Tick& tick) {
        const TrackTick kept = made.track->tickBefore(++moment);
        const Tick again = kept.tick();
        same = same && kept.time == time && again.contact.proxy.position == tick.contact.proxy.position &&
               again.contact.proxy.rotation.coeffs() == tick.contact.proxy.rotation.coeffs() &&
               again.force.wrench.force == tick.force.wrench.force && again.contact.depth == tick.contact.depth &&
               again.spindle.speedRpm == tick.spindle.speedRpm && again.contact.triangles == tick.contact.triangles &&
               again.input.cutting == tick.input.cutting && again.contact.placed == tick.contact.placed;
    });
    ASSERT_TRUE(played) << played.error().message();
    EXPECT_TRUE(same);
    EXPECT_EQ(made.track->ticks(), moment);
    EXPECT_EQ(made.track->seconds(), replay->seconds());
    EXPECT_EQ(made.track->expectedSeconds(), replay->seconds());
    EXPECT_GT(made.track->bytes(), moment * sizeof(TrackTick));
}

TEST(TrackTick, KeepsTheImpactsAndPullOutsThatAreHeard) {
    Tick tick;
    tick.contact.onsets = 4;
    tick.contact.impactSpeed = 12.5;
    tick.contact.pullOuts = 3;
    tick.contact.pullOutForce = 0.25;
    const Tick again = TrackTick::of(1, tick).tick();
    EXPECT_EQ(again.contact.onsets, 4U);
    EXPECT_EQ(again.contact.impactSpeed, 12.5);
    EXPECT_EQ(again.contact.pullOuts, 3U);
    EXPECT_EQ(again.contact.pullOutForce, 0.25);
}

TEST(SessionTrack, ReachesTheToothOfAnyMomentBitForBit) {
    const test::TemporaryFolder folder;
    const std::uint64_t end = RecordedStrokes().writeTo(folder / "s.ttsession");
    const Made made = trackOf(folder / "s.ttsession");
    const Oracle oracle = oracleOf(made, 12, 3);
    TrackTooth tooth(made.track);
    std::mt19937 random(4);
    for (int jump = 0; jump < 60; ++jump) {  // forward and back, near and far
        const std::size_t i = random() % oracle.moments.size();
        tooth.moveTo(oracle.moments[i]);
        ASSERT_EQ(tooth.model().hash(), oracle.hashes[i]) << "moment " << oracle.moments[i];
        const TaggedMesh surface = tooth.model().exported();
        ASSERT_EQ(surface.mesh.vertices, oracle.teeth[i].mesh.vertices) << "moment " << oracle.moments[i];
        ASSERT_EQ(surface.mesh.triangles, oracle.teeth[i].mesh.triangles);
        ASSERT_EQ(surface.tags, oracle.teeth[i].tags);
        ASSERT_EQ(tooth.model().removed(), oracle.losses[i].removed);
        tooth.model().volume().validate();
    }
    tooth.moveTo(made.track->ticks());
    EXPECT_EQ(tooth.model().hash(), end);
    tooth.moveTo(0);
    EXPECT_EQ(tooth.model().hash(), made.track->startModel()->hash());
}

TEST(SessionTrack, StepsThroughASecondTickByTick) {
    const test::TemporaryFolder folder;
    (void)RecordedStrokes{.seconds = 1.2, .undoEach = 0.3, .resetAt = 0.9}.writeTo(folder / "s.ttsession");
    const Made made = trackOf(folder / "s.ttsession");
    std::vector<std::uint64_t> hashes;
    TrackTooth tooth(made.track);
    for (std::uint64_t moment = 0; moment <= made.track->ticks(); moment += 3) {
        tooth.moveTo(moment);
        hashes.push_back(tooth.model().hash());
    }
    for (std::size_t i = hashes.size(); i-- > 0;) {
        tooth.moveTo(3 * i);
        ASSERT_EQ(tooth.model().hash(), hashes[i]) << "moment " << 3 * i;
    }
    EXPECT_GT((std::set<std::uint64_t>(hashes.begin(), hashes.end()).size()), 20U);
}

TEST(SessionTrack, NamesTheEventsAndTheBurs) {
    const test::TemporaryFolder folder;
    (void)RecordedStrokes().writeTo(folder / "s.ttsession");
    const Made made = trackOf(folder / "s.ttsession");
    std::vector<std::string_view> texts;
    double before = 0;
    for (const TrackEvent& event : made.track->events()) {
        EXPECT_GE(event.time, before);
        before = event.time;
        texts.push_back(event.text->english);
    }
    EXPECT_EQ(std::ranges::count(texts, "bur put in"), 2);
    EXPECT_EQ(std::ranges::count(texts, "tooth put back"), 1);
    EXPECT_GT(std::ranges::count(texts, "undo"), 1);
    EXPECT_EQ(std::ranges::count(texts, "first contact"), 1);
    const std::uint64_t second = made.track->burAt(made.track->ticks())->afterTicks;
    EXPECT_NEAR(made.track->tickBefore(second).time, 2, 0.01);
    EXPECT_EQ(made.track->burAt(second - 1)->begin.settings.freedom, Freedom::Translation);
    EXPECT_EQ(made.track->burAt(second)->begin.settings.freedom, Freedom::TranslationAndRotation);
}

TEST(SessionTrack, FindsTheMomentOfATime) {
    const test::TemporaryFolder folder;
    (void)RecordedStrokes{.seconds = 2.3, .cutShare = 0}.writeTo(folder / "s.ttsession");
    const Made made = trackOf(folder / "s.ttsession");
    EXPECT_EQ(made.track->momentAt(-1), 0U);
    EXPECT_EQ(made.track->momentAt(0), 0U);
    EXPECT_EQ(made.track->momentAt(1e9), made.track->ticks());
    for (std::uint64_t moment = 1; moment <= made.track->ticks(); moment += 37) {
        const double time = made.track->tickBefore(moment).time;
        EXPECT_EQ(made.track->momentAt(time), moment);
        EXPECT_EQ(made.track->momentAt(time - 1e-6), moment - 1);
    }
    std::uint64_t visited = 500;
    made.track->forEachTick(
        500, 1700, [&](const TrackTick& tick) { EXPECT_EQ(tick.time, made.track->tickBefore(++visited).time); });
    EXPECT_EQ(visited, 1700U);
}

/// What a crash leaves, and what a bad disk makes of it.
TEST(SessionTrack, OfARecordingThatWasCutOffHasWhatIsLeft) {
    const test::TemporaryFolder folder;
    (void)RecordedStrokes().writeTo(folder / "s.ttsession");
    const auto whole = std::filesystem::file_size(folder / "s.ttsession");
    std::mt19937 random(5);
    int made = 0;
    for (int i = 0; i < 8; ++i) {
        const auto file = folder / "cut.ttsession";
        std::filesystem::copy_file(folder / "s.ttsession", file, std::filesystem::copy_options::overwrite_existing);
        std::filesystem::resize_file(file, whole / 2 + random() % (whole / 2));
        const auto recording = SessionRecording::open(file);
        if (!recording) continue;
        const auto model = recording->makeModel();
        if (!model) continue;  // the tooth itself is cut off
        const auto track = emptyTrack(*recording, **model);
        ASSERT_TRUE(track) << track.error().message();
        makeTrack(*recording, *model, **track);
        EXPECT_TRUE((*track)->isFinished());
        EXPECT_FALSE((*track)->differsAt());
        EXPECT_EQ((*track)->ticks(), recording->ticks());
        TrackTooth tooth(*track);
        tooth.moveTo((*track)->ticks());
        EXPECT_EQ(tooth.model().hash(), (*model)->hash());
        tooth.moveTo((*track)->ticks() / 3);
        tooth.moveTo(0);
        EXPECT_EQ(tooth.model().hash(), (*track)->startModel()->hash());
        ++made;
    }
    EXPECT_GT(made, 3);
}

SessionTrack trackOfABlock() {
    auto block = LayeredTooth::make(test::box(Vec3(-1, -1, -1), Vec3(1, 1, 0)), {}, test::kDentin);
    return {CutModel(std::make_shared<const LayeredTooth>(std::move(*block)), 0.1), 1};
}

TEST(SessionTrack, ShowsTheMirrorAsItWasHeldLast) {
    // On the grid: what comes back is what went in, to the last bit.
    const Pose held{Vec3(1.5, -8.25, 3), Quat(0.5, 0.5, -0.5, 0.5)};
    const Vec3 eye(10.75, 200, 150);
    const MirrorSight first = MirrorSight::of(held, 10.25, eye), last = MirrorSight::of({}, 8.25, eye);
    SessionTrack track = trackOfABlock();
    EXPECT_EQ(track.mirrorAt(0), MirrorSight()) << "not recorded";
    EXPECT_EQ(track.mirrorAt(7), MirrorSight());
    track.setMirror({{5, last}, {5, first}, {9, MirrorSight()}, {12, last}});
    for (std::uint64_t moment = 0; moment < 5; ++moment) EXPECT_FALSE(track.mirrorAt(moment).isShown) << moment;
    for (std::uint64_t moment = 5; moment < 9; ++moment) {
        const MirrorSight sight = track.mirrorAt(moment);
        ASSERT_TRUE(sight.isShown) << moment;
        EXPECT_EQ(sight.mirror().position, held.position);
        EXPECT_EQ(sight.mirror().rotation.coeffs(), held.rotation.coeffs());
        EXPECT_EQ(sight.radiusMm(), 10.25);
        EXPECT_EQ(sight.eyePlace(), eye);
    }
    for (std::uint64_t moment = 9; moment < 12; ++moment) EXPECT_FALSE(track.mirrorAt(moment).isShown) << moment;
    for (const std::uint64_t moment : {12U, 13U, 1'000'000U}) EXPECT_EQ(track.mirrorAt(moment), last) << moment;
}

TEST(SessionTrack, SaysWhereTheReplayDiffers) {
    const test::TemporaryFolder folder;
    (void)RecordedStrokes{.seconds = 1}.writeTo(folder / "s.ttsession");
    const auto recording = SessionRecording::open(folder / "s.ttsession");
    const auto model = recording->makeModel();
    const auto track = emptyTrack(*recording, **model);
    (*model)->sweep(test::flatBur().cutting, test::at(0, 0, 0.2), test::at(0, 0, -0.7));  // another tooth
    (*model)->refreshSurface();
    makeTrack(*recording, *model, **track);
    EXPECT_TRUE((*track)->isFinished());
    EXPECT_TRUE((*track)->differsAt());
}

TEST(SessionTrack, EndsOnRequest) {
    const test::TemporaryFolder folder;
    (void)RecordedStrokes{.seconds = 1}.writeTo(folder / "s.ttsession");
    const auto recording = SessionRecording::open(folder / "s.ttsession");
    const auto model = recording->makeModel();
    const auto track = emptyTrack(*recording, **model);
    std::stop_source stop;
    stop.request_stop();
    makeTrack(*recording, *model, **track, stop.get_token());
    EXPECT_TRUE((*track)->isFinished());
    EXPECT_EQ((*track)->ticks(), 0U);
}

TEST(ToothFollower, ShowsTheMomentThatWasAskedForLast) {
    const test::TemporaryFolder folder;
    const std::uint64_t end = RecordedStrokes{.seconds = 2, .resetAt = 9}.writeTo(folder / "s.ttsession");
    const Made made = trackOf(folder / "s.ttsession");
    ToothFollower follower(made.track);
    EXPECT_TRUE(follower.isThere());
    EXPECT_EQ(follower.shown().moment, 0U);
    const auto uncut = follower.shown().surface;
    ASSERT_NE(uncut, nullptr);
    for (std::uint64_t moment = 0; moment < made.track->ticks(); moment += 50) follower.follow(moment);
    follower.follow(made.track->ticks());
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!follower.isThere() && std::chrono::steady_clock::now() < limit) std::this_thread::yield();
    const ToothFollower::Shown shown = follower.shown();
    EXPECT_EQ(shown.moment, made.track->ticks());
    EXPECT_NE(shown.surface, uncut);
    TrackTooth tooth(made.track);
    tooth.moveTo(made.track->ticks());
    EXPECT_EQ(tooth.model().hash(), end);
    EXPECT_EQ(visibleMesh(*shown.surface).mesh.vertices, visibleMesh(*tooth.model().surface()).mesh.vertices);
}

}  // namespace
}  // namespace tactooth
