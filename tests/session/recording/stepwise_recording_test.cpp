// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Runs that are not live, through a file.
#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "bench_scene.h"
#include "session/recording/session_recorder.h"
#include "session/recording/session_replay.h"
#include "session/scripts/cut_run.h"
#include "session/scripts/touch_run.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using test::at;

struct Forces {
    std::vector<double> times;
    std::vector<Vec3> forces;
    friend bool operator==(const Forces&, const Forces&) = default;
    void add(double time, const Tick& tick) {
        times.push_back(time);
        forces.push_back(tick.force.wrench.force);
    }
};

std::vector<TimedPose> path(double start, int rows) {
    std::vector<TimedPose> all;
    for (int i = 0; i < rows; ++i) {
        const double time = start + 0.0011 * i;
        all.push_back({time, at(0.8 * std::sin(5 * (time - start)), 0, 0.1 - 0.0008 * i)});
    }
    return all;
}

/// Replays the file and expects these forces and this tooth.
Forces replayed(const std::filesystem::path& file, std::uint64_t hash) {
    Forces forces;
    const auto recording = SessionRecording::open(file);
    EXPECT_TRUE(recording) << recording.error().message();
    if (!recording) return forces;
    EXPECT_TRUE(recording->journal().isComplete());
    auto replay = SessionReplay::start(*recording);
    EXPECT_TRUE(replay) << replay.error().message();
    if (!replay) return forces;
    const auto played = replay->playUntil({}, [&](double time, const Tick& tick) { forces.add(time, tick); });
    EXPECT_TRUE(played) << played.error().message();
    EXPECT_FALSE(replay->differsAt());
    EXPECT_EQ(replay->model().hash(), hash);
    EXPECT_EQ(recording->ticks(), forces.times.size());
    return forces;
}

TEST(StepwiseRecording, ACutIsReplayedFromItsFile) {
    const test::TemporaryFolder folder;
    const auto model = test::blockOnTheBench();
    auto recorder = SessionRecorder::create(folder / "s.ttsession", *model, "block");
    ASSERT_TRUE(recorder);
    HapticSettings settings;
    settings.spindle = constantSpeed(300'000);
    Forces forces;
    {
        StepwiseSession session(model, cutSetup(test::flatBur(), settings),
                                [&](const SessionEvent& event) { (*recorder)->append(event); });
        ASSERT_TRUE(cutWithRemovalLaw(
            path(0, 1500), session, [&](double time, const Tick& tick, const ToothLoss&) { forces.add(time, tick); }));
    }
    EXPECT_GT(total(model->removed()), 0.1);
    ASSERT_TRUE((*recorder)->close(model->hash()));
    const Forces again = replayed(folder / "s.ttsession", model->hash());
    EXPECT_EQ(again.forces, forces.forces);
    for (std::size_t i = 0; i < forces.times.size(); ++i) EXPECT_NEAR(again.times[i], forces.times[i], 1e-9);
}

TEST(StepwiseRecording, AnOpenSurfaceIsReplayedFromItsFile) {
    const test::TemporaryFolder folder;
    TriangleMesh square;
    square.vertices = {Vec3f(-2, -2, 0), Vec3f(2, -2, 0), Vec3f(2, 2, 0), Vec3f(-2, 2, 0)};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    const std::vector<SurfaceTag> tags = {static_cast<SurfaceTag>(test::kDentin), 0};
    const auto model = std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(LayeredTooth::touchOnly(
                                                      std::make_shared<const SurfacePart>(square, tags), false)),
                                                  0.05);
    auto recorder = SessionRecorder::create(folder / "s.ttsession", *model, "square");
    ASSERT_TRUE(recorder);
    HapticSettings settings;
    settings.force = {900, 3, 4};  // more than any material has
    Forces forces;
    {
        StepwiseSession session(model, {touchingTool(test::flatBur().shape), settings, Placement::AtOnce},
                                [&](const SessionEvent& event) { (*recorder)->append(event); });
        ASSERT_TRUE(
            runTouchPath(path(0, 300), session, [&](double time, const Tick& tick) { forces.add(time, tick); }));
    }
    ASSERT_TRUE((*recorder)->close(model->hash()));
    const Forces again = replayed(folder / "s.ttsession", model->hash());
    EXPECT_EQ(again.forces, forces.forces);
    EXPECT_GT(again.forces.back().norm(), 1);
}

}  // namespace
}  // namespace tactooth
