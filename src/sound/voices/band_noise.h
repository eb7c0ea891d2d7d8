// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sound/voices/gain_smoother.h"
#include "sound/voices/white_noise.h"

namespace tactooth {

/// Second-order band-pass of unit gain at its centre, which may move while it runs. Andrew Simper, "Linear Trapezoidal
/// Integrated State Variable Filter" (Cytomic, 2013): its state is that of the analogue circuit's capacitors, so that a
/// moving centre makes no clicks, unlike a direct-form biquad.
class BandPass {
public:
    void tune(float centreHz, float quality);
    float process(float input) {
        const float v3 = input - second_;
        const float v1 = a1_ * first_ + a2_ * v3;
        const float v2 = second_ + a2_ * first_ + a3_ * v3;
        first_ = 2.0f * v1 - first_;
        second_ = 2.0f * v2 - second_;
        return damping_ * v1;
    }

private:
    float damping_ = 1.0f, a1_ = 0.0f, a2_ = 0.0f, a3_ = 0.0f;
    float first_ = 0.0f, second_ = 0.0f;
};

/// Noise in a band, with a root mean square of 1 whatever the band.
class BandNoise {
public:
    explicit BandNoise(std::uint64_t seed) : noise_(seed) {}

    /// Moves the centre (Hz) and width (octaves between the half-power points) of the band toward new values; `share`
    /// as from smoothingCoefficient(). The first call sets them.
    void tune(double centreHz, double octaves, float share);
    /// The next sample. `strength` scales the noise before the filters, so that its modulation (grains, amplitude
    /// modulation) stays within the band.
    float next(float strength = 1.0f) { return loudness_ * narrow_.process(wide_.process(strength * noise_.next())); }

private:
    WhiteNoise noise_;
    BandPass wide_, narrow_;
    OnePoleSmoother logCentre_, octaves_;
    float loudness_ = 0.0f;
    bool tuned_ = false;
};

}  // namespace tactooth
