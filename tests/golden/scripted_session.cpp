// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "scripted_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <random>

#include "session/kernel/event_merger.h"
#include "session/model/session_bur.h"
#include "session/recording/session_recorder.h"
#include "session/track/stepped_session.h"

namespace tactooth::test {
namespace {

/// Strokes over the crown and into it. The bur stands still at first, and in every fifth stroke.
class StrokingHand {
public:
    StrokingHand(unsigned seed, double top, double depth)
        : random_(seed), top_(top), depth_(depth), from_(0, 0, top + 0.3), to_(from_) {}

    OperatorInput at(double time) {
        constexpr double kStroke = 0.12, kTouching = 0.3;  // s
        if (time >= began_ + kStroke) {
            std::uniform_real_distribution<double> part(0, 1);
            const auto within = [&](double low, double high) { return low + (high - low) * part(random_); };
            const double x = within(-1.4, 1.4), y = within(-0.6, 0.6);
            began_ = time, from_ = to_, to_ = Vec3(x, y, within(top_ - depth_, top_ - 0.5 * depth_));
            const Vec3 lean(within(-0.15, 0.15), within(-0.15, 0.15), 0);
            leanFrom_ = leanTo_, leanTo_ = Quat(1, lean.x(), lean.y(), 0).normalized();
            cuts_ = time >= kTouching && ++strokes_ % 5 != 0;
        }
        const double share = std::min(1.0, (time - began_) / kStroke);
        return {{from_ + share * (to_ - from_), leanFrom_.slerp(share, leanTo_)}, cuts_ ? 1.0 : 0.0, cuts_};
    }

private:
    std::mt19937 random_;
    double top_, depth_;  // mm
    Vec3 from_, to_;
    Quat leanFrom_ = Quat::Identity(), leanTo_ = Quat::Identity();
    double began_ = 0;  // s
    int strokes_ = 0;
    bool cuts_ = false;
};

/// Held lingually above a tooth whose highest point is at `top`. It shows the crown to somebody who looks from buccal.
MirrorSight mirrorBehind(double top) {
    const Vec3 glass(0, -11, top + 5), eye(-12, 52, 68), crown(0, 0, top - 1), handle(-1, -0.6, 0.8);
    const Vec3 normal = ((eye - glass).normalized() + (crown - glass).normalized()).normalized();
    const Vec3 stem = (handle - handle.dot(normal) * normal).normalized();
    Eigen::Matrix3d frame;
    frame << stem, normal.cross(stem), normal;
    return MirrorSight::of({glass, Quat(frame)}, 9, eye);
}

}  // namespace

void ScriptedSession::writeTo(const std::filesystem::path& file) const {
    const BuiltinTooth built = makeBuiltinTooth(tooth, triangles);
    Expected<LayeredTooth> layered = layeredTooth(built);
    ASSERT_TRUE(layered) << layered.error().message();
    const auto model = std::make_shared<CutModel>(std::make_shared<const LayeredTooth>(std::move(*layered)), voxel);
    auto recorder = SessionRecorder::create(file, *model, built.name);
    ASSERT_TRUE(recorder) << recorder.error().message();
    const double top = boundingBox(built.outer).max().z();
    StrokingHand hand(seed, top, depth);
    auto change = changes.begin();
    constexpr int kMirrorTick = 500;
    constexpr std::chrono::steady_clock::time_point kLater(std::chrono::seconds(1));
    int ticks = 0;
    for (const Part& part : parts) {
        const auto spec = findBur(part.bur);
        ASSERT_TRUE(spec) << part.bur;
        const Expected<SessionBur> bur = makeSessionBur(*spec);
        ASSERT_TRUE(bur) << bur.error().message();
        HapticSettings settings;
        settings.freedom = part.freedom;
        if (hasMirror && &part == &parts.back()) (*recorder)->noteMirror({}, kLater);
        (*recorder)->append(BeginEvent{bur->instrument, settings});
        const auto lanes = std::make_shared<EventLanes>();
        EventMerger merger;
        SteppedSession session(model, bur->instrument, settings, lanes);
        for (const int end = static_cast<int>(part.end / SteppedSession::kPeriod + 0.5); ticks < end; ++ticks) {
            const double time = ticks * SteppedSession::kPeriod;
            session.step(hand.at(time));
            if (hasMirror && ticks == kMirrorTick) (*recorder)->noteMirror(mirrorBehind(top), {});
            for (; change != changes.end() && change->time <= time; ++change) session.edit(change->edit);
            lanes->drain(merger);
            std::vector<SessionEvent> events;
            merger.take(events);
            for (const SessionEvent& event : events) (*recorder)->append(event);
        }
        EXPECT_EQ(merger.waiting(), 0U);
    }
    EXPECT_EQ(change, changes.end());
    EXPECT_GT(total(model->removed()), 0.002) << "mm^3";
    const auto closed = (*recorder)->close(model->hash());
    ASSERT_TRUE(closed) << closed.error().message();
}

}  // namespace tactooth::test
