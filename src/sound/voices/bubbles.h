// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <span>

#include "sound/voices/white_noise.h"

namespace tactooth {

/// Size and rate of bubbles.
struct BubbleKind {
    double lowHz, highHz;  ///< tones, evenly over the octaves between them
    double perSecond;      ///< on average, at full flow
    double rise;           ///< rise of the tone while it sounds, as a share of it: bubbles near the surface
};

/// Water that trickles or is sucked in: each air bubble rings with a short decay. K. van den Doel, "Physically based
/// models for liquid sounds", ACM Trans. Appl. Percept. 2 (2005) 534: tone by the radius of the bubble (M. Minnaert,
/// 1933), damping 0.13 + 0.0072 hz^1.5 (a share of hz a second), tone rising near the surface. Ours differs in two
/// points: all sizes are equally loud on average, and at most kVoices sound at a time.
class Bubbles {
public:
    Bubbles(std::uint64_t seed, const BubbleKind& kind) : noise_(seed), kind_(kind) {}

    /// Adds the sound of `flow` (0..1) for `out.size()` samples; the loudest bubbles have about the amplitude 1.
    void addTo(std::span<float> out, float flow);

private:
    static constexpr int kVoices = 12;
    struct Bubble {
        std::complex<float> turn, state;  // the imaginary part is the sound
        std::complex<float> bend;         // change of the rotation by rising, each sample
        int framesLeft = 0;
    };
    void start();

    WhiteNoise noise_;
    BubbleKind kind_;
    std::array<Bubble, kVoices> bubbles_{};
    std::size_t next_ = 0;
};

}  // namespace tactooth
