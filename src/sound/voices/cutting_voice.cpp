// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/cutting_voice.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"
#include "sound/voices/grinding_share.h"

namespace tactooth {

namespace {

// Each doubling of the removal power adds about as much sound power as the last: a gentle cut must be audible over the
// turbine, and the 30 W of the strongest turbine must not hurt. At kTopWatt the root mean square is kTopLevel of full
// scale: single grains reach five times that, just below full scale.
constexpr double kTopLevel = 0.16;
constexpr double kTopWatt = 40.0, kFaintWatt = 0.2;
constexpr double kLagSeconds = 0.006;

// Amplitude modulation at the rotation: a slow bur (10 000 rev/min = 167 Hz) rattles. At thousands of turns a second
// the ear hears no modulation, only side tones, which would blur the band of the material.
constexpr double kSlowModulation = 0.6, kFastModulation = 0.15;
constexpr double kModulationFadeHz = 800.0;

// Each passing blade cuts: eight blades at 10 000 rev/min give 1.3 kHz, six at 300 000 are inaudible. They modulate the
// noise and give a tone beside it.
constexpr double kBladeModulation = 0.35, kBladeTone = 0.7;  // the tone by the swing
constexpr double kPassingFadesHz = 8000.0, kHighestPassingHz = 14000.0;

// Chatter: a trembling handpiece, from half of the stall load on. Tens of times a second, as hand and handpiece
// vibrate; the depth was chosen by ear.
constexpr double kChatterFromLoad = 0.5, kMaxChatter = 0.75;
constexpr double kStickSlipsPerSecond = 80.0;   // new random grips: swings of up to 40 Hz
constexpr double kStickSlipMeanSquare = 0.247;  // of RandomModulator: 1/3 at its places, eased between them

double amplitudeOf(const DrillSoundState& state) {
    const double power = std::log1p(state.removalPower / kFaintWatt) / std::log1p(kTopWatt / kFaintWatt);
    return kTopLevel * state.material.level * grindingShare(state.speedRpm) * std::sqrt(power);
}

double modulationAt(double turnsPerSecond) {
    const double slow = kModulationFadeHz / (kModulationFadeHz + turnsPerSecond);
    return kFastModulation + (kSlowModulation - kFastModulation) * slow;
}

double bladeModulationAt(double passesPerSecond) {
    if (passesPerSecond <= 0 || passesPerSecond > kHighestPassingHz) return 0;
    return kBladeModulation * kPassingFadesHz / (kPassingFadesHz + passesPerSecond);
}

double chatterAt(double load) {
    return kMaxChatter * std::clamp((load - kChatterFromLoad) / (1.0 - kChatterFromLoad), 0.0, 1.0);
}

}  // namespace

CuttingVoice::CuttingVoice(std::uint64_t seed)
    : noise_(seed + 1), grains_(seed + 2), stickSlip_(seed + 3, kStickSlipsPerSecond) {}

void CuttingVoice::addTo(std::span<float> out, const DrillSoundState& state, double volume,
                         std::span<const double> turnsPerFrame) {
    const int frames = static_cast<int>(out.size());
    const float share = smoothingCoefficient(kLagSeconds, frames);
    const double rotation = modulationAt(turnsPerFrame.back() * kSoundRate);
    const double amplitude = amplitudeOf(state) * volume;
    const std::size_t recording = kit_ != nullptr ? kit_->cuttingOf(state.material) : 0;
    const bool isRecorded = kit_ != nullptr && recording < kit_->cutting.size();
    if (kit_ != nullptr) addRecorded(out, recording, amplitude, turnsPerFrame);
    const double chatter = chatterAt(state.load);
    if (bladeModulation_.isZero()) blades_ = state.blades;
    const double passes = blades_ == state.blades ? blades_ * turnsPerFrame.back() * kSoundRate : 0.0;
    const double blade = bladeModulationAt(passes);
    const double swinging = 1.0 + 0.5 * rotation * rotation + 0.5 * (1.0 + kBladeTone * kBladeTone) * blade * blade;
    const double power = swinging * (1.0 + kStickSlipMeanSquare * chatter * chatter);
    gain_.aim(static_cast<float>((isRecorded ? 0.0 : amplitude) / std::sqrt(power)), share, frames);
    chatter_.aim(static_cast<float>(1.0 + chatter * static_cast<double>(stickSlip_.advance(frames))), 1.0f, frames);
    rotationModulation_.aim(static_cast<float>(rotation), share, frames);
    bladeModulation_.aim(static_cast<float>(blade), share, frames);
    if (gain_.isZero()) return;

    noise_.tune(state.material.bandCentreHz, state.material.bandOctaves, share);
    grains_.setGraininess(static_cast<double>(graininess_.step(static_cast<float>(state.material.graininess), share)));
    const bool sings = !bladeModulation_.isZero();
    for (std::size_t i = 0; i < out.size(); ++i) {
        const float turning = sineOfTurns(rotation_.advance(turnsPerFrame[i]));
        const float passing =
            sings ? bladeModulation_.next() * sineOfTurns(passing_.advance(blades_ * turnsPerFrame[i])) : 0.0f;
        const float swing = 1.0f + rotationModulation_.next() * turning + passing;
        const float noise = noise_.next(swing * grains_.next());
        out[i] += gain_.next() * chatter_.next() * (noise + static_cast<float>(kBladeTone) * passing);
    }
}

void CuttingVoice::addRecorded(std::span<float> out, std::size_t index, double amplitude,
                               std::span<const double> turnsPerFrame) {
    const float share = smoothingCoefficient(kLagSeconds, static_cast<int>(out.size()));
    TACTOOTH_ASSERT(kit_->cutting.size() <= recorded_.size());
    for (std::size_t i = 0; i < kit_->cutting.size(); ++i) {
        recorded_[i].addTo(out, kit_->cutting[i].part, i == index ? amplitude : 0.0, share, turnsPerFrame);
    }
}

}  // namespace tactooth
