// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/process/mirror_use.h"

#include <gtest/gtest.h>

#include "support/materials.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using namespace test;

/// A glass in the plane z = -10 that faces up, seen from above: it shows what is over it.
const MirrorSight kSeen = MirrorSight::of({Vec3(0, 0, -10), Quat::Identity()}, 11, Vec3(0, 0, 300));

/// A session of 10 s with the tip at the origin, 1000 ticks a second; from 8 s on the hand is gone.
std::shared_ptr<SessionTrack> session(std::vector<MirrorMoment> mirror) {
    auto tooth = LayeredTooth::make(box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), {}, kDentin);
    const CutModel model(std::make_shared<const LayeredTooth>(std::move(*tooth)), 0.5);
    auto track = std::make_shared<SessionTrack>(model, 10);
    TrackChunk chunk;
    for (int i = 0; i < 10'000; ++i) {
        TrackTick tick;
        tick.time = (i + 1) / 1000.0;
        tick.placed = tick.time < 8;
        chunk.ticks.push_back(tick);
        if (chunk.ticks.size() == TrackChunk::kTicks) track->append(std::exchange(chunk, {}));
    }
    track->setMirror(std::move(mirror));
    return track;
}

TEST(MirrorUse, IsTheTimeInWhichTheMirrorShowsTheTip) {
    const MirrorSight aside = MirrorSight::of({Vec3(30, 0, -10), Quat::Identity()}, 11, Vec3(0, 0, 300));
    // Shown from 1 to 2.5 s, beside the tip to 4 s, shown to 5 s, not in the picture to 7 s, shown until the end.
    const auto track = session({{1000, kSeen}, {2500, aside}, {4000, kSeen}, {5000, {}}, {7000, kSeen}});
    EXPECT_NEAR(mirrorTime(track.get()).value.value_or(-1), 1.5 + 1 + 1, 0.003) << "until the hand is gone";
    EXPECT_EQ(mirrorTime(session({{0, aside}}).get()).value, 0);
}

TEST(MirrorUse, IsNotKnownWithoutARecordOfIt) {
    EXPECT_EQ(mirrorTime(nullptr).reason->id, "no_session");
    const auto old = session({});
    EXPECT_EQ(mirrorTime(old.get()).reason->id, "no_mirror_known");
    EXPECT_FALSE(mirrorTime(old.get()).value) << "null, not 0";
}

}  // namespace
}  // namespace tactooth
