// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "sound/material_sounds.h"
#include "sound/voices/soundscape.h"

namespace tactooth::test {

/// The sound of each source.
inline std::array<std::vector<float>, kSoundSources> rendered(Soundscape& soundscape, const DrillSoundState& state,
                                                              double seconds) {
    std::array<std::vector<float>, kSoundSources> sounds;
    SoundBlock block;
    for (int i = 0; i < static_cast<int>(seconds * kSoundRate) / kSoundBlock; ++i) {
        soundscape.render(state, block);
        for (std::size_t place = 0; place < kSoundSources; ++place)
            sounds[place].insert(sounds[place].end(), block[place].begin(), block[place].end());
    }
    return sounds;
}

inline DrillSoundState everythingOn() {
    DrillSoundState state = cutting("enamel", 1000.0, 500000.0);
    state.load = state.water = state.suction = 1.0;
    return state;
}

}  // namespace tactooth::test
