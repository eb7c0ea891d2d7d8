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
/// short push, high ring ("tick"); soft: long push, low ring ("thud"). An explorer's tip that comes free of soft decay
/// is another one: then its own shank rings ("tick").
class ImpactVoice {
public:
    /// Adds its sound to `out`. A contactCount other than the last one is a new impact, a pullOutCount other than the
    /// last one a new pull-out; the first state is only the start of both counts.
    void addTo(std::span<float> out, const DrillSoundState& state, double volume);

private:
    struct Mode {
        std::complex<float> turn;   // rotation and decay for one sample
        std::complex<float> state;  // its imaginary part is the sound
        float push = 0.0f;
    };
    /// The tones of one body, which rings on when another one is struck.
    class Ring {
    public:
        /// `body`: its tap. `amplitude`: share of full scale.
        void strike(const SoundCharacter& body, double amplitude);
        void addTo(std::span<float> out);

    private:
        std::array<Mode, 3> modes_{};
        int pushFrames_ = 1;
        int pushDone_ = 1;
        int ringFrames_ = 0;  // until it is inaudible
    };

    Ring tooth_, shank_;
    std::uint32_t contactCount_ = 0, pullOutCount_ = 0;
    bool counting_ = false;
};

}  // namespace tactooth
