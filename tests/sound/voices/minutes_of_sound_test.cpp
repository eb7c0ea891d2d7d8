// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sound/voices/soundscape.h"
#include "spectrum.h"
#include "voices/rendered_sound.h"

namespace tactooth {
namespace {

using namespace test;

TEST(MinutesOfSound, AtFullPowerAreTurnedDown) {
    Soundscape soundscape;
    const double atFirst = rms(rendered(soundscape, everythingOn(), 2.0)[0]);
    for (int i = 0; i < 10; ++i) (void)rendered(soundscape, everythingOn(), 20.0);
    EXPECT_LT(rms(rendered(soundscape, everythingOn(), 2.0)[0]), 0.8 * atFirst);
}

TEST(MinutesOfSound, OfAnOrdinaryCutAreAsLoudAsTheFirstSecond) {
    for (const char* material : {"enamel", "dentin", "caries"}) {
        Soundscape soundscape;
        const DrillSoundState state = cutting(material, 4.0, 320000.0);
        (void)rendered(soundscape, state, 1.0);
        const double atFirst = rms(rendered(soundscape, state, 2.0)[0]);
        (void)rendered(soundscape, state, 180.0);
        EXPECT_NEAR(rms(rendered(soundscape, state, 2.0)[0]), atFirst, 0.02 * atFirst) << material;
    }
}

}  // namespace
}  // namespace tactooth
