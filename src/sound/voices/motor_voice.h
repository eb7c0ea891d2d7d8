// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "sound/voices/band_noise.h"
#include "sound/voices/drill_sound_state.h"
#include "sound/voices/gain_smoother.h"
#include "sound/voices/recorded_voice.h"
#include "sound/voices/rotation.h"
#include "sound/voices/sine.h"

namespace tactooth {

/// The handpiece: tones locked to the rotation (the whine), the tones of the bearing's cage, of blades or gear teeth,
/// and the hiss of the drive air. Tones close to half the sample rate fade out, against aliasing.
class MotorVoice {
public:
    explicit MotorVoice(std::uint64_t seed);

    /// Adds its sound to `out` (at most kControlFrames samples) while the bur makes `turnsPerFrame`; `volume` 0..1.
    void addTo(std::span<float> out, const DrillSoundState& state, double volume,
               std::span<const double> turnsPerFrame);

    /// Plays a recording instead, from its beginning; null: the synthesis again. `part` stays where it is as long as it
    /// is played.
    void use(const RecordedPart* part) {
        part_ = part;
        recorded_ = {};
    }

    static constexpr int kTones = 6;

private:
    struct Tone {
        Phase phase;
        GainSmoother gain;
    };
    void aimTones(const DrillSoundState& state, double volume, int frames);
    void addTone(std::span<float> out, int index, double ratio, std::span<const double> turnsPerFrame);
    void addHiss(std::span<float> out, const DrillSoundState& state, double volume);

    std::array<Tone, kTones> tones_;
    RandomModulator cageSlipModulator_, airModulator_;
    double cageTurns_ = 0.0;  // of the cage for each turn of the bur
    BandNoise hiss_;
    GainSmoother hissGain_;
    const RecordedPart* part_ = nullptr;
    RecordedVoice recorded_;
};

}  // namespace tactooth
