// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// The sound must neither wait for the heap nor block it: counts each call of operator new in this program.
#include <gtest/gtest.h>

#include "geometry/util/triple_buffer.h"
#include "sound/files/sound_format.h"
#include "sound/material_sounds.h"
#include "sound/voices/drill_synthesiser.h"
#include "sound/voices/soundscape.h"
#include "spectrum.h"
#include "support/heap_counter.h"

namespace tactooth {
namespace {

TEST(Allocation, CounterSeesAnAllocation) {
    const long before = test::heapCalls();
    std::vector<int> some(3);
    EXPECT_EQ(some.size(), 3u);
    EXPECT_GT(test::heapCalls(), before);
}

TEST(Allocation, TheWholeSoundscapeUsesNoHeap) {
    Soundscape soundscape;
    SoundBlock block;
    DrillSoundState state = test::cutting("dentin", 10.0);
    const long before = test::heapCalls();
    for (int i = 0; i < 4000; ++i) {
        state.water = 0.01 * (i % 100);
        state.suction = i % 300 < 200 ? 1.0 : 0.0;
        soundscape.setMixer({.environment = 0.001 * (i % 1000)});
        soundscape.render(state, block);
    }
    EXPECT_EQ(test::heapCalls(), before);
}

TEST(Allocation, RenderingAndHandingOverUseNoHeap) {
    DrillSynthesiser synthesiser;
    TripleBuffer<DrillSoundState> mailbox;
    DrillSoundState state = test::cutting("enamel", 20.0);
    const DrillSoundState other = test::cutting("caries", 3.0);
    std::array<float, kSoundBlock> block;

    const long before = test::heapCalls();
    for (int i = 0; i < 10000; ++i) {
        if (i % 100 == 50) state.material = other.material;
        state.speedRpm = 1000.0 * (i % 400);
        state.contactCount = static_cast<std::uint32_t>(i / 7);
        state.contactSpeed = 300.0;
        state.pullOutCount = static_cast<std::uint32_t>(i / 11);
        state.pullOutForce = 0.5;
        mailbox.write(state);
        mailbox.refresh();
        synthesiser.setMixer({.master = 0.001 * (i % 1000)});
        synthesiser.render(mailbox.value(), block);
    }
    EXPECT_EQ(test::heapCalls(), before);
}

}  // namespace
}  // namespace tactooth
