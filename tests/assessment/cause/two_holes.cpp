// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/cause/two_holes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "instruments/bur_catalogue.h"
#include "instruments/bur_shape.h"
#include "session/kernel/stepwise_session.h"
#include "session/recording/session_recorder.h"
#include "session/track/make_track.h"
#include "support/materials.h"
#include "support/servo_tick.h"
#include "support/shapes.h"

namespace tactooth::test {
namespace {

Pose handAt(double time) {
    const bool isSecond = time >= 3;
    const double began = isSecond ? TwoHoles::kSecondHole : TwoHoles::kFirstHole;
    const double down = std::clamp(time - began, 0.0, 1.0) * (time < began + 1 ? 1 : 0);
    const Quat grip(isSecond ? Eigen::AngleAxisd(TwoHoles::kTilt, Vec3::UnitY()) : Eigen::AngleAxisd::Identity());
    return {Vec3(isSecond ? 1 : -1, 0, 0.3 - 1.6 * down), grip};
}

}  // namespace

void TwoHoles::record() {
    auto tooth = LayeredTooth::make(box(Vec3(-3, -2, -3), Vec3(3, 2, 0)), {}, kDentin);
    const auto model = std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*tooth)), 0.05);
    const std::filesystem::path file = folder_ / "two_holes.ttsession";
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
    auto recording = SessionRecording::open(file);
    ASSERT_TRUE(recording) << recording.error().message();
    recording_ = std::make_shared<SessionRecording>(std::move(*recording));
    auto start = recording_->makeModel();
    ASSERT_TRUE(start) << start.error().message();
    auto track = emptyTrack(*recording_, **start);
    ASSERT_TRUE(track) << track.error().message();
    makeTrack(*recording_, *start, **track);
    ASSERT_FALSE((*track)->differsAt());
    track_ = *track;
}

const TwoHoles* TwoHoles::recorded() {
    static const std::unique_ptr<TwoHoles> session = [] {
        std::unique_ptr<TwoHoles> made(new TwoHoles);
        made->record();
        return made;
    }();
    return session->track_ != nullptr ? session.get() : nullptr;
}

}  // namespace tactooth::test
