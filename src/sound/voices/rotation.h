// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "sound/voices/white_noise.h"

namespace tactooth {

/// A random value that varies smoothly within [-1, 1], with a given number of new targets a second.
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

/// The rotation of the spindle from sample to sample: exactly the speed of the simulation, interpolated linearly, and a
/// flutter of at most 0.1 % so that a steady tone does not sound electronic. (Real handpieces vary by 1-3 %; that
/// belongs to the speed model, which the tone has to follow within 0.5 %.)
class Rotation {
public:
    explicit Rotation(std::uint64_t seed) : modulator_(seed, 6.0) {}

    /// Fills in the turns of the bur in each sample; the last one is at `speedRpm`.
    void advanceTo(double speedRpm, std::span<double> turnsPerFrame);

private:
    RandomModulator modulator_;
    double turns_ = 0.0;  // per sample, at the end of the last run
};

}  // namespace tactooth
