// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <span>

#include "sound/voices/drill_sound_state.h"

namespace tactooth {

/// The impact of an instrument: a few decaying tones, excited by a push as long as the contact lasts. Hard material:
/// short push, high ring ("tick"); soft: long push, low ring ("thud").
class ImpactVoice {
public:
    /// Adds its sound to `out`. A contactCount other than the last one is a new impact; the first one is only the start
    /// of the count.
    void addTo(std::span<float> out, const DrillSoundState& state, double volume);

private:
    struct Mode {
        std::complex<float> turn;   // rotation and decay for one sample
        std::complex<float> state;  // its imaginary part is the sound
        float push = 0.0f;
    };
    void strike(const DrillSoundState& state, double volume);

    std::array<Mode, 3> modes_{};
    int pushFrames_ = 1;
    int pushDone_ = 1;
    int ringFrames_ = 0;  // until it is inaudible
    std::uint32_t count_ = 0;
    bool counting_ = false;
};

}  // namespace tactooth
