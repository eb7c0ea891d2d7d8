// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cause/removal_cause.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "instruments/bur_catalogue.h"
#include "instruments/bur_shape.h"
#include "session/kernel/stepwise_session.h"
#include "session/recording/session_recorder.h"
#include "session/track/make_track.h"
#include "support/materials.h"
#include "support/servo_tick.h"
#include "support/shapes.h"
#include "support/test_data.h"

namespace tactooth {
namespace {

using test::kTick;
constexpr double kTilt = 0.2;        // rad
constexpr double kSecondHole = 4.0;  // s

/// A bur cuts two holes into a block with its top at z = 0: one at x = -1 from 1 to 2 s, upright, and one at x = 1 from
/// 4 to 5 s, tilted.
class RemovalCauseTest : public testing::Test {
protected:
    static void SetUpTestSuite() {
        auto tooth = LayeredTooth::make(test::box(Vec3(-3, -2, -3), Vec3(3, 2, 0)), {}, test::kDentin);
        const auto model = std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), 0.05);
        const test::TemporaryFolder folder;  // shards of this program run at the same time
        const std::filesystem::path file = folder / "two_holes.ttsession";
        auto recorder = SessionRecorder::create(file, *model, "block");
        ASSERT_TRUE(recorder) << recorder.error().message();
        const BurSpec spec = findBur("4").value();
        TriangleMesh surface = makeBur(spec).surface;
        CuttingTool cutting = makeCuttingTool(surface).value();
        const Instrument bur{std::make_shared<const ToolShape>(std::move(surface)), std::move(cutting), spec.edge()};
        StepwiseSession session(model, {bur, HapticSettings(), Placement::AtOnce},
                                [&](const SessionEvent& event) { (*recorder)->append(event); });
        for (int i = 0; i < 6000; ++i) {
            const double time = i * kTick;
            (void)session.step({handAt(time), 1, true}, kTick, time);
            if (i % 5 == 0) (void)session.carve();
            session.list();
        }
        session.finish(false);
        const auto closed = (*recorder)->close(model->hash());
        ASSERT_TRUE(closed) << closed.error().message();
        const auto recording = SessionRecording::open(file);
        ASSERT_TRUE(recording) << recording.error().message();
        auto start = recording->makeModel();
        ASSERT_TRUE(start) << start.error().message();
        auto track = emptyTrack(*recording, **start);
        ASSERT_TRUE(track) << track.error().message();
        makeTrack(*recording, *start, **track);
        track_ = *track;
        ASSERT_FALSE(track_->differsAt());
    }
    static void TearDownTestSuite() { track_.reset(); }

    static Pose handAt(double time) {
        const bool isSecond = time >= 3;
        const double began = isSecond ? kSecondHole : 1;
        const double down = std::clamp(time - began, 0.0, 1.0) * (time < began + 1 ? 1 : 0);
        const Quat grip(isSecond ? Eigen::AngleAxisd(kTilt, Vec3::UnitY()) : Eigen::AngleAxisd::Identity());
        return {Vec3(isSecond ? 1 : -1, 0, 0.3 - 1.6 * down), grip};
    }
    /// Points in a hole, 0.05 to 0.3 mm deep.
    static std::vector<RemovedPoint> pointsAt(double x, double size = 1) {
        std::vector<RemovedPoint> points;
        for (double z = -0.05; z > -0.3; z -= 0.05) points.push_back({Vec3(x, 0, z), size});
        return points;
    }

    inline static std::shared_ptr<const SessionTrack> track_;
};

TEST_F(RemovalCauseTest, FindsWhenEachPointWentAway) {
    TrackTooth tooth(track_);
    const std::vector<RemovedPoint> points = pointsAt(-1);
    const auto times = removalTimes(*track_, tooth, points);
    double last = 1;
    for (const auto& time : times) {
        ASSERT_TRUE(time);
        EXPECT_GE(*time, last - kCauseStep) << "deeper points go later";
        EXPECT_LT(*time, 2.1);
        last = *time;
    }
    const auto others = removalTimes(*track_, tooth, {{Vec3(0, 1.5, -0.1), 1}, {Vec3(-1, 0, 0.5), 1}});
    EXPECT_FALSE(others[0]) << "nobody has cut there";
    EXPECT_FALSE(others[1]) << "there was never any tooth";
}

TEST_F(RemovalCauseTest, IsThePieceOfWorkThatRemovedMost) {
    TrackTooth tooth(track_);
    std::vector<RemovedPoint> points = pointsAt(-1, 1), more = pointsAt(1, 3);
    points.insert(points.end(), more.begin(), more.end());
    const auto cause = removalCause(*track_, tooth, points, Vec3::UnitZ());
    ASSERT_TRUE(cause);
    EXPECT_GE(cause->from, kSecondHole);
    EXPECT_LE(cause->to, kSecondHole + 1.1);
    EXPECT_LT(cause->from, cause->to);
    ASSERT_TRUE(cause->tilt);
    EXPECT_NEAR(*cause->tilt, kTilt * 180 / std::numbers::pi, 0.1);
    EXPECT_GT(cause->force, 0.05);
    EXPECT_LT(cause->force, 3);
}

TEST_F(RemovalCauseTest, OfAnUprightBurHasNoTilt) {
    TrackTooth tooth(track_);
    const auto cause = removalCause(*track_, tooth, pointsAt(-1), Vec3::UnitZ());
    ASSERT_TRUE(cause);
    EXPECT_NEAR(cause->tilt.value_or(90), 0, 0.1);
    EXPECT_LT(cause->to, 2.1);
    EXPECT_FALSE(removalCause(*track_, tooth, {}, Vec3::UnitZ()));
    EXPECT_FALSE(removalCause(*track_, tooth, {{Vec3(0, 1.5, -0.1), 1}}, Vec3::UnitZ()));
}

}  // namespace
}  // namespace tactooth
