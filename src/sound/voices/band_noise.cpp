// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/band_noise.h"

#include <cmath>
#include <numbers>

namespace tactooth {

namespace {

// Two equal band-passes in series are narrower than one: the half-power width of the pair is sqrt(sqrt(2) - 1) of
// one's.
const double kPairNarrowing = std::sqrt(std::numbers::sqrt2 - 1.0);

// Quality of one filter such that the pair has its half-power points `octaves` apart.
double qualityOf(double octaves) {
    const double pairQuality = 1.0 / (2.0 * std::sinh(0.5 * octaves * std::numbers::ln2));
    return pairQuality * kPairNarrowing;
}

}  // namespace

void BandPass::tune(float centreHz, float quality) {
    const float g = std::tan(std::numbers::pi_v<float> * centreHz / kSoundRate);
    damping_ = 1.0f / quality;
    a1_ = 1.0f / (1.0f + g * (g + damping_));
    a2_ = g * a1_;
    a3_ = g * a2_;
}

void BandNoise::tune(double centreHz, double octaves, float share) {
    if (!tuned_) share = 1.0f;
    tuned_ = true;
    const double centre =
        std::exp2(static_cast<double>(logCentre_.step(static_cast<float>(std::log2(centreHz)), share)));
    const double quality = qualityOf(static_cast<double>(octaves_.step(static_cast<float>(octaves), share)));
    wide_.tune(static_cast<float>(centre), static_cast<float>(quality));
    narrow_.tune(static_cast<float>(centre), static_cast<float>(quality));

    // Uniform noise has the power 1/3, spread evenly up to half the rate. Of that, a pair of such filters passes a band
    // of pi/4 * centre/quality: the integral of 1/(1 + Q^2 (f/c - c/f)^2)^2 over f. The bilinear transform compresses
    // the frequency axis, at the centre by g/(1+g^2) against g's own linear measure.
    const double angle = std::numbers::pi * centre / kSoundRate;
    const double squeezed = std::sin(2.0 * angle) / (2.0 * angle);
    const double passedHz = 0.25 * std::numbers::pi * centre / quality * squeezed;
    const double power = passedHz / (0.5 * kSoundRate) / 3.0;
    loudness_ = static_cast<float>(1.0 / std::sqrt(power));
}

}  // namespace tactooth
