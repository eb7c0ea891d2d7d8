// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/sound_sources.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

const Box3 kTooth(Vec3(-5, -4, 0), Vec3(5, 4, 20));

TEST(SoundSources, TheDrillSoundsAtTheTipAndIsHeardByTheEye) {
    const Pose eye{Vec3(1, 60, 30), Quat(0.6, 0.8, 0, 0)};
    const SoundPlacement places = soundPlacementAt(kTooth, 1, Vec3(2, 3, 19), eye);
    EXPECT_EQ(places.source, Vec3(2, 3, 19));
    EXPECT_EQ(places.listenerInWorld.position, eye.position);
    EXPECT_TRUE(places.listenerInWorld.rotation.isApprox(eye.rotation));
}

TEST(SoundSources, SprayFallsBelowTheCrownAndSuctionStandsLingualAndDistal) {
    for (const double mesialX : {1.0, -1.0}) {
        const SoundPlacement places = soundPlacementAt(kTooth, mesialX, Vec3::Zero(), {});
        EXPECT_LT(places.mouth.z(), kTooth.center().z());
        EXPECT_LT(places.suction.y(), kTooth.min().y());
        EXPECT_LT(places.suction.x() * mesialX, kTooth.min().x());
    }
}

}  // namespace
}  // namespace tactooth
