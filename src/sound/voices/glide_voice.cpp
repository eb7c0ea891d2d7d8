// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/glide_voice.h"

#include <algorithm>
#include <cmath>

#include "sound/voices/grinding_share.h"

namespace tactooth {

namespace {

// Root mean square: kTopLevel of full scale at most, which is far below a cut; half of that power at kHalfWatt, that is
// 0.5 N at 20 mm/s. A careful hand gives 0.2 to 1 N and 5 to 30 mm/s.
constexpr double kTopLevel = 0.04;
constexpr double kFriction = 0.2;  // steel on a wet tooth
constexpr double kHalfWatt = kFriction * 0.5 * 0.020;
constexpr double kLagSeconds = 0.012;

// A scratch rings lower than a cut in the same material, wider, and a little higher the faster the tool glides.
constexpr double kBelowCutting = 0.6, kWiderOctaves = 0.5;
constexpr double kUsualSpeed = 20.0;  // mm/s
constexpr double kRise = 0.2, kMinRise = 0.6, kMaxRise = 1.5;

double amplitudeOf(const DrillSoundState& state) {
    const double watt = kFriction * state.contactForce * 1e-3 * state.slideSpeed;
    const double resting = 1.0 - grindingShare(state.speedRpm);  // else the noise of cutting is heard instead
    return kTopLevel * state.material.level * resting * std::sqrt(watt / (watt + kHalfWatt));
}

double centreOf(const DrillSoundState& state) {
    const double rise = std::clamp(std::pow(state.slideSpeed / kUsualSpeed, kRise), kMinRise, kMaxRise);
    return kBelowCutting * rise * state.material.bandCentreHz;
}

}  // namespace

GlideVoice::GlideVoice(std::uint64_t seed) : noise_(seed), grains_(seed + 1) {}

void GlideVoice::addTo(std::span<float> out, const DrillSoundState& state, double volume) {
    const int frames = static_cast<int>(out.size());
    const float share = smoothingCoefficient(kLagSeconds, frames);
    gain_.aim(static_cast<float>(amplitudeOf(state) * volume), share, frames);
    if (gain_.isZero()) return;

    noise_.tune(centreOf(state), state.material.bandOctaves + kWiderOctaves, share);
    grains_.setGraininess(static_cast<double>(graininess_.step(static_cast<float>(state.material.graininess), share)));
    for (float& sample : out) sample += gain_.next() * noise_.next(grains_.next());
}

}  // namespace tactooth
