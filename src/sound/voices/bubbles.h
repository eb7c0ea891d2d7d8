// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <span>

#include "sound/voices/white_noise.h"

namespace tactooth {

/// Of what size bubbles are and how often they come.
struct BubbleKind {
    double lowHz, highHz;  ///< tones, evenly over the octaves between
    double perSecond;      ///< on average, at full flow
    double rise;           ///< of the tone while it sounds, as a share of it: bubbles near the surface
};

/// Water that trickles or is sucked in: each bubble of air rings like a bell that dies at once.
/// K. van den Doel, "Physically based models for liquid sounds", ACM Trans. Appl. Percept. 2 (2005) 534: tone by the
/// bubble's radius (M. Minnaert, 1933), damping 0.13 + 0.0072 hz^1.5 (a share of hz a second), tone rising as it nears
/// the surface. Differs from the paper: equally loud on average whatever the size, and at most kVoices at a time.
class Bubbles {
public:
    Bubbles(std::uint64_t seed, const BubbleKind& kind) : noise_(seed), kind_(kind) {}

    /// Adds the sound of `flow` (0..1) for `out.size()` samples; the loudest bubbles have about the amplitude 1.
    void addTo(std::span<float> out, float flow);

private:
    static constexpr int kVoices = 12;
    struct Bubble {
        std::complex<float> turn, state;  // the imaginary part sounds
        std::complex<float> bend;         // what rising does to the turn, each sample
        int framesLeft = 0;
    };
    void start();

    WhiteNoise noise_;
    BubbleKind kind_;
    std::array<Bubble, kVoices> bubbles_{};
    std::size_t next_ = 0;
};

}  // namespace tactooth
