// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sound/voices/white_noise.h"

namespace tactooth {

/// Grains: short pulses at random times, as particles break off. An envelope for noise; its mean square is 1 together
/// with the steady part.
class GrainEnvelope {
public:
    explicit GrainEnvelope(std::uint64_t seed) : noise_(seed) {}
    /// Share of the pulses against the steady part, 0..1.
    void setGraininess(double graininess);
    float next();

private:
    WhiteNoise noise_;
    float pulses_ = 0.0f;
    float steadyPart_ = 1.0f, pulsePart_ = 0.0f;
};

}  // namespace tactooth
