// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/grain_envelope.h"

#include <cmath>

#include "sound/files/sound_format.h"

namespace tactooth {

namespace {

constexpr float kGrainsPerFrame = 1800.0f / kSoundRate;  // some grains at each of a few hundred turns a second
constexpr double kGrainSeconds = 0.00035;
const auto kGrainKeep = static_cast<float>(std::exp(-1.0 / (kGrainSeconds * kSoundRate)));

}  // namespace

void GrainEnvelope::setGraininess(double graininess) {
    // Campbell's theorem for random pulses that fall by `keep` a sample: mean and variance of their sum.
    const double keep = kGrainKeep, rate = kGrainsPerFrame;
    const double mean = rate / (1.0 - keep);
    const double variance = rate * (1.0 - rate) / (1.0 - keep * keep);
    const double pulses = graininess / std::sqrt(mean * mean + variance);
    const double steady = 1.0 - graininess;
    const double power = steady * steady + 2.0 * steady * pulses * mean + graininess * graininess;
    steadyPart_ = static_cast<float>(steady / std::sqrt(power));
    pulsePart_ = static_cast<float>(pulses / std::sqrt(power));
}

float GrainEnvelope::next() {
    pulses_ = pulses_ * kGrainKeep + (noise_.nextPositive() < kGrainsPerFrame ? 1.0f : 0.0f);
    return steadyPart_ + pulsePart_ * pulses_;
}

}  // namespace tactooth
