// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "sound/voices/band_noise.h"
#include "sound/voices/drill_sound_state.h"
#include "sound/voices/gain_smoother.h"
#include "sound/voices/grain_envelope.h"

namespace tactooth {

/// The scratch of a tool that glides over a tooth and does not turn. Its level follows the power of the friction, and
/// its band the material: a bright scratch on enamel, a dull one on soft decay.
class GlideVoice {
public:
    explicit GlideVoice(std::uint64_t seed);

    /// Adds its sound to `out` (at most kControlFrames samples); `volume` 0..1.
    void addTo(std::span<float> out, const DrillSoundState& state, double volume);

private:
    BandNoise noise_;
    GrainEnvelope grains_;
    OnePoleSmoother graininess_;
    GainSmoother gain_;
};

}  // namespace tactooth
