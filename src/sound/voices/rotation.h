// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "sound/voices/white_noise.h"

namespace tactooth {

/// A random value that wanders smoothly within [-1, 1], to a new place some times a second.
class RandomModulator {
public:
    RandomModulator(std::uint64_t seed, double timesPerSecond);
    /// The value `frames` samples later.
    float advance(int frames);

private:
    WhiteNoise noise_;
    float placesPerFrame_;
    float progress_ = 0.0f;
    float from_ = 0.0f, to_ = 0.0f;
};

/// The spindle's rotation from sample to sample: exactly the speed that the simulation gives, a straight way between
/// two given speeds, and a flutter of at most 0.1 % that keeps a steady tone from sounding electronic. (Real
/// handpieces wander by 1-3 %; that much belongs to the speed model, which the tone has to follow within 0.5 %.)
class Rotation {
public:
    explicit Rotation(std::uint64_t seed) : modulator_(seed, 6.0) {}

    /// Fills in the turns that the bur makes in each sample; the last one is at `speedRpm`.
    void advanceTo(double speedRpm, std::span<double> turnsPerFrame);

private:
    RandomModulator modulator_;
    double turns_ = 0.0;  // per sample, at the end of the last run
};

}  // namespace tactooth
