// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/export/session_moments.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench_scene.h"
#include "session/recording/session_recorder.h"
#include "session/scripts/cut_run.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using test::at;

/// Two cuts with a pause, and the second one taken back.
class Moments : public testing::Test {
protected:
    void SetUp() override {
        const auto model = test::blockOnTheBench();
        auto recorder = SessionRecorder::create(file(), *model, "block");
        ASSERT_TRUE(recorder);
        HapticSettings settings;
        settings.spindle = constantSpeed(300'000);
        std::vector<TimedPose> path;
        for (int i = 0; i < 2000; ++i) {
            const bool lifted = i < 100 || (i > 600 && i < 1200) || i > 1700;
            path.push_back({0.001 * i, at(i < 900 ? -0.6 : 0.6, 0, lifted ? 0.3 : -0.4)});
        }
        StepwiseSession session(model, cutSetup(test::flatBur(), settings),
                                [&](const SessionEvent& event) { (*recorder)->append(event); });
        ASSERT_TRUE(cutWithRemovalLaw(
            path, session, [&](double, const Tick&, const ToothLoss& loss) { removed_ = total(loss.removed); }));
        ASSERT_TRUE(model->undo());
        (*recorder)->append(EditEvent{Edit::Undo, true});
        undone_ = removed_ - total(model->removed());
        ASSERT_GT(undone_, 0);
        ASSERT_TRUE((*recorder)->close(model->hash()));
    }
    [[nodiscard]] std::filesystem::path file() const { return folder_ / "s.ttsession"; }

    std::vector<SessionMoment> moments() {
        const auto recording = SessionRecording::open(file());
        EXPECT_TRUE(recording);
        auto replay = SessionReplay::start(*recording);
        EXPECT_TRUE(replay);
        SessionMoments found(*replay);
        EXPECT_TRUE(replay->playUntil(
            {}, [&](double time, const Tick& tick) { found.onTick(time, tick); },
            [&](double time, const SessionEvent& event) { found.onEvent(time, event); }));
        EXPECT_FALSE(replay->differsAt());
        found.finish();
        return found.all();
    }

    test::TemporaryFolder folder_;
    double removed_ = 0, undone_ = 0;  // mm^3
};

TEST_F(Moments, AreTheCutsWithTheirVolumesAndWhatWasTakenBack) {
    const std::vector<SessionMoment> all = moments();
    EXPECT_TRUE(std::ranges::is_sorted(all, {}, &SessionMoment::time));
    std::vector<std::string> names;
    double cut = 0;
    for (const SessionMoment& moment : all) {
        names.push_back(moment.what);
        if (moment.what == "cut ended") cut += moment.removed.value();
        if (moment.what == "undo") {
            EXPECT_NEAR(moment.removed.value(), -undone_, 1e-9);
        }
        if (moment.what == "cut begun") {
            EXPECT_NEAR(std::abs(moment.place->x()), 0.6, 0.1);
        }
    }
    EXPECT_NEAR(cut, removed_, 1e-9);
    EXPECT_EQ(std::ranges::count(names, "bur"), 1);
    EXPECT_EQ(std::ranges::count(names, "cut begun"), 2);
    EXPECT_EQ(std::ranges::count(names, "cut ended"), 2);
    EXPECT_EQ(std::ranges::count(names, "first contact"), 1);
    EXPECT_EQ(std::ranges::count(names, "dentin reached"), 1);
    EXPECT_EQ(names.front(), "bur");
    EXPECT_EQ(names.back(), "undo");
}

TEST_F(Moments, BeginAndEndWhereTheBurTouches) {
    std::vector<double> times;
    for (const SessionMoment& moment : moments()) {
        if (moment.what.starts_with("cut ")) times.push_back(moment.time);
    }
    ASSERT_EQ(times.size(), 4U);
    EXPECT_NEAR(times[0], 0.1, 0.03);
    EXPECT_NEAR(times[1], 0.6, 0.03);
    EXPECT_NEAR(times[2], 1.2, 0.03);
    EXPECT_NEAR(times[3], 1.7, 0.03);
}

}  // namespace
}  // namespace tactooth
