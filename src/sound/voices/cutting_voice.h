// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "sound/voices/band_noise.h"
#include "sound/voices/drill_sound_state.h"
#include "sound/voices/gain_smoother.h"
#include "sound/voices/grain_envelope.h"
#include "sound/voices/recorded_voice.h"
#include "sound/voices/rotation.h"
#include "sound/voices/sine.h"
#include "sound/voices/sound_kit.h"

namespace tactooth {

/// The noise of cutting. Its level follows the removal power, and its band the material. It has amplitude modulation at
/// the rotation, and a tone at the blade passing frequency. Near the stall it chatters: the bur grips, slips and grips
/// again.
class CuttingVoice {
public:
    explicit CuttingVoice(std::uint64_t seed);

    /// Adds its sound to `out` (at most kControlFrames samples) while the bur makes `turnsPerFrame`; `volume` 0..1.
    void addTo(std::span<float> out, const DrillSoundState& state, double volume,
               std::span<const double> turnsPerFrame);

    /// Plays the recordings of a kit where it has them, from their beginnings; null: all synthesised again. `kit` stays
    /// valid as long as it is played.
    void use(const SoundKit* kit) {
        kit_ = kit;
        recorded_ = {};
    }

private:
    /// The recordings of the kit: that at `index` at this amplitude, the others fade out.
    void addRecorded(std::span<float> out, std::size_t index, double amplitude, std::span<const double> turnsPerFrame);

    BandNoise noise_;
    GrainEnvelope grains_;
    OnePoleSmoother graininess_;
    Phase rotation_, passing_;
    RandomModulator stickSlip_;
    GainSmoother gain_, rotationModulation_, chatter_, bladeModulation_;
    int blades_ = 0;  // blades that are heard; those of another bur follow when these have faded
    const SoundKit* kit_ = nullptr;
    std::array<RecordedVoice, kMaxRecordedMaterials> recorded_;  // by the index in the kit
};

}  // namespace tactooth
