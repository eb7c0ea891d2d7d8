// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/cutting_voice.h"

#include <cmath>

namespace tactooth {

namespace {

// Sound power grows with removal power, so the amplitude with its root; above kHalfWatt it bends over, since a
// turbine gives up to 30 W and nobody should turn the volume down for it. 0.22 keeps the peaks (four times the root
// mean square) below full scale.
constexpr double kTopLevel = 0.22;
constexpr double kHalfWatt = 4.0;
constexpr double kLagSeconds = 0.006;

// Below this speed a rotation is too slow to grind: nothing comes from a still bur.
constexpr double kGrindingRpm = 500.0;

// Throb at the rotation: a slow bur (10 000 rev/min = 167 Hz) rattles; at thousands of turns a second the ear hears no
// throb, only side tones, which would blur the material's band.
constexpr double kSlowThrob = 0.6, kFastThrob = 0.15;
constexpr double kThrobFadesHz = 800.0;

constexpr float kGrainsPerFrame = 1800.0f / kSoundRate;  // some grains at each of a few hundred turns a second
constexpr double kGrainSeconds = 0.00035;
const auto kGrainKeep = static_cast<float>(std::exp(-1.0 / (kGrainSeconds * kSoundRate)));

double amplitudeOf(const DrillSoundState& state) {
    const double grinding = std::min(1.0, state.speedRpm / kGrindingRpm);
    return kTopLevel * state.material.level * grinding * std::sqrt(state.removalWatt / (state.removalWatt + kHalfWatt));
}

double throbAt(double turnsPerSecond) {
    const double slow = kThrobFadesHz / (kThrobFadesHz + turnsPerSecond);
    return kFastThrob + (kSlowThrob - kFastThrob) * slow;
}

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

void CuttingVoice::addTo(std::span<float> out, const DrillSoundState& state, double volume,
                         std::span<const double> turnsPerFrame) {
    const int frames = static_cast<int>(out.size());
    const float share = glideShare(kLagSeconds, frames);
    const double throb = throbAt(turnsPerFrame.back() * kSoundRate);
    gain_.aim(static_cast<float>(amplitudeOf(state) * volume / std::sqrt(1.0 + 0.5 * throb * throb)), share, frames);
    throb_.aim(static_cast<float>(throb), share, frames);
    if (gain_.isZero()) return;

    noise_.tune(state.material.bandCentreHz, state.material.bandOctaves, share);
    grains_.setGraininess(
        static_cast<double>(graininess_.towards(static_cast<float>(state.material.graininess), share)));
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float swing = 1.0f + throb_.next() * sineOfTurns(rotation_.advance(turnsPerFrame[i]));
        out[i] += gain_.next() * noise_.next(swing * grains_.next());
    }
}

}  // namespace tactooth
