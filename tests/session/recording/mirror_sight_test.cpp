// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/mirror_sight.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

#include "recording/recorded_touches.h"
#include "session/recording/session_replay.h"
#include "session/track/make_track.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

TEST(MirrorSight, KeepsAPoseToItsGrid) {
    const Pose pose{Vec3(1.23456, -20.5, 7), Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
    const MirrorSight sight = MirrorSight::of(pose, 10.2, Vec3(-100, 250, 30.3));
    ASSERT_TRUE(sight.isShown);
    EXPECT_LT((sight.mirror().position - pose.position).norm(), 0.0005);
    EXPECT_LT(sight.mirror().rotation.angularDistance(pose.rotation), 1e-6);
    EXPECT_NEAR(sight.radiusMm(), 10.2, 0.0002);
    EXPECT_LT((sight.eyePlace() - Vec3(-100, 250, 30.3)).norm(), 0.0005);
}

TEST(MirrorSight, OfNoPoseIsNotShown) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Pose pose;
    EXPECT_EQ(MirrorSight::of({Vec3(nan, 0, 0), Quat::Identity()}, 10, Vec3::UnitZ()), MirrorSight());
    EXPECT_EQ(MirrorSight::of(pose, 10, Vec3(0, 1e9, 0)), MirrorSight());
    for (const double radius : {nan, 0.0, -1.0, 1e9})
        EXPECT_EQ(MirrorSight::of(pose, radius, Vec3::UnitZ()), MirrorSight());
}

/// The glass lies at the origin and leans by 45 degrees: an eye along +x sees what is along +z.
TEST(MirrorSight, ShowsWhatTheReflectedLineOfSightMeets) {
    const Pose glass{Vec3::Zero(), Quat(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitY()))};
    const MirrorSight sight = MirrorSight::of(glass, 10, Vec3(300, 0, 0));
    EXPECT_TRUE(sight.shows(Vec3(0, 0, 20)));
    EXPECT_TRUE(sight.shows(Vec3(0, 9, 20)));
    // From the eye, 300 mm away, to the image, 20 mm behind: the line crosses the glass at 300/320 of y.
    EXPECT_TRUE(sight.shows(Vec3(0, 10 * 320 / 300.0 - 0.05, 20)));
    EXPECT_FALSE(sight.shows(Vec3(0, 10 * 320 / 300.0 + 0.05, 20))) << "beside the glass";
    EXPECT_FALSE(sight.shows(Vec3(0, 0, -20))) << "behind the glass";
    EXPECT_FALSE(MirrorSight::of(glass, 10, Vec3(-300, 0, 0)).shows(Vec3(0, 0, 20))) << "the eye is behind it";
    EXPECT_FALSE(MirrorSight().shows(Vec3(0, 0, 20)));
    EXPECT_FALSE(sight.shows(Vec3::Constant(std::numeric_limits<double>::quiet_NaN())));
}

std::vector<MirrorMoment> randomMoments(std::size_t count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-50, 50);
    std::vector<MirrorMoment> moments;
    for (std::size_t i = 0; i < count; ++i) {
        const Pose pose{Vec3(any(random), any(random), any(random)),
                        Quat(any(random), any(random), any(random), any(random)).normalized()};
        const Vec3 eye(any(random), any(random), any(random));
        moments.push_back({17 * i, i % 5 == 0 ? MirrorSight() : MirrorSight::of(pose, 11, eye)});
    }
    return moments;
}

TEST(MirrorCodec, GivesBackWhatItGot) {
    const std::vector<MirrorMoment> moments = randomMoments(100);
    EXPECT_EQ(decodeMirror(encodeMirror(moments)), moments);
    EXPECT_EQ(decodeMirror(encodeMirror({})), std::vector<MirrorMoment>());
}

TEST(MirrorCodec, RefusesEachCutAndWhatNoMirrorHas) {
    const std::vector<std::byte> whole = encodeMirror(randomMoments(5));
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_FALSE(decodeMirror(std::span(whole).first(size))) << size;
    std::vector<std::byte> more = whole;
    more.push_back({});
    EXPECT_FALSE(decodeMirror(more));
    std::vector<MirrorMoment> moments = randomMoments(3);
    moments[1].sight.radius = -1;
    EXPECT_FALSE(decodeMirror(encodeMirror(moments)));
    moments = randomMoments(3);
    moments[1].sight.eye[2] = std::numeric_limits<std::int64_t>::max();
    EXPECT_FALSE(decodeMirror(encodeMirror(moments)));
    moments = randomMoments(3);
    std::swap(moments[0].tick, moments[2].tick);
    EXPECT_FALSE(decodeMirror(encodeMirror(moments))) << "back in time";
}

TEST(MirrorRecording, HoldsEachChangeWithItsTickAndReplaysTheSame) {
    const test::TemporaryFolder folder;
    const std::vector<MirrorMoment> moments = randomMoments(5);
    std::vector<MirrorMoment> wanted;
    (void)test::recordTouches(folder / "with.ttsession", [&](SessionRecorder& recorder, int ticks) {
        const auto number = static_cast<std::size_t>(ticks / 400);
        if (ticks % 400 == 0) wanted.push_back({static_cast<std::uint64_t>(ticks), moments[number].sight});
        recorder.noteMirror(moments[number].sight, test::atTick(ticks));
    });
    (void)test::recordTouches(folder / "without.ttsession", [](SessionRecorder&, int) {});
    const auto with = SessionRecording::open(folder / "with.ttsession");
    const auto without = SessionRecording::open(folder / "without.ttsession");
    ASSERT_TRUE(with && without);
    ASSERT_EQ(wanted.size(), 4U);
    EXPECT_EQ(with->mirror().value(), wanted);
    EXPECT_TRUE(without->mirror().value().empty());
    EXPECT_EQ(with->end().value().toothHash, without->end().value().toothHash);
    std::vector<std::uint64_t> hashes;
    for (const SessionRecording* each : {&*with, &*without}) {
        auto model = each->makeModel();
        ASSERT_TRUE(model);
        const auto track = emptyTrack(*each, **model);
        ASSERT_TRUE(track);
        EXPECT_EQ((*track)->mirror(), each->mirror().value()) << "before the first tick is simulated";
        makeTrack(*each, *model, **track);
        EXPECT_FALSE((*track)->differsAt());
        EXPECT_FALSE((*track)->fault());
        EXPECT_EQ((*track)->mirror(), each->mirror().value());
        EXPECT_EQ((*track)->ticks(), each->ticks());
        for (const std::uint64_t moment : {0, 1, 399, 400, 799, 800, 1199, 1200, 1500}) {
            const MirrorSight held = each == &*with ? moments[moment / 400].sight : MirrorSight();
            EXPECT_EQ((*track)->mirrorAt(moment), held) << moment;
        }
        ASSERT_TRUE(each->forEach([&](const SessionEvent& event) {
            if (const auto* hash = std::get_if<TickHashEvent>(&event)) hashes.push_back(hash->hash);
            return true;
        }));
    }
    ASSERT_EQ(hashes.size() % 2, 0U);
    const auto half = hashes.begin() + static_cast<std::ptrdiff_t>(hashes.size() / 2);
    EXPECT_TRUE(std::equal(hashes.begin(), half, half)) << "the simulation knows nothing of the mirror";
}

TEST(MirrorRecording, TakesNoMoreThanOneChangeInSixteenMilliseconds) {
    const test::TemporaryFolder folder;
    const std::vector<MirrorMoment> moments = randomMoments(1501);
    (void)test::recordTouches(folder / "s.ttsession", [&](SessionRecorder& recorder, int ticks) {
        recorder.noteMirror(moments[static_cast<std::size_t>(ticks)].sight, test::atTick(ticks));
    });
    constexpr double kSeconds = 1.5;
    const auto recording = SessionRecording::open(folder / "s.ttsession");
    ASSERT_TRUE(recording);
    const std::size_t changes = recording->mirror().value().size();
    EXPECT_EQ(changes, 94U);  // at 0 ms, and then each 16 ms
    EXPECT_LE(static_cast<double>(changes), 1 + kSeconds / 0.016);
}

}  // namespace
}  // namespace tactooth
