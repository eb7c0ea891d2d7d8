// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "sound/voices/band_noise.h"
#include "sound/voices/bubbles.h"
#include "sound/voices/gain_smoother.h"
#include "sound/voices/recorded_voice.h"
#include "sound/voices/rotation.h"

namespace tactooth {

/// The cooling spray: the hiss of its droplets on the tooth, and the trickle of the water that runs down.
class WaterVoice {
public:
    explicit WaterVoice(std::uint64_t seed);
    /// Adds its sound (at most kControlFrames samples); `flow` and `volume` 0..1.
    void addTo(std::span<float> out, double flow, double volume);
    /// Plays a recording instead, from its beginning; null: the synthesis again. `part` stays valid as long as it is
    /// played.
    void use(const RecordedPart* part) {
        part_ = part;
        recorded_ = {};
    }

private:
    const RecordedPart* part_ = nullptr;
    RecordedVoice recorded_;
    BandNoise hiss_;
    Bubbles trickle_;
    GainSmoother gain_;
};

/// The suction tube: rushing air with the tone of the tube, and a slurp where it meets water.
class SuctionVoice {
public:
    explicit SuctionVoice(std::uint64_t seed);
    /// Adds its sound (at most kControlFrames samples); `flow`, `water` (in the mouth) and `volume` 0..1.
    void addTo(std::span<float> out, double flow, double water, double volume);
    /// Like WaterVoice::use().
    void use(const RecordedPart* part) {
        part_ = part;
        recorded_ = {};
    }

private:
    const RecordedPart* part_ = nullptr;
    RecordedVoice recorded_;
    BandNoise rush_, tube_;
    Bubbles slurp_;
    RandomModulator slurpModulator_;
    GainSmoother gain_, wet_;
};

}  // namespace tactooth
