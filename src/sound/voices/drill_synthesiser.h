// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "sound/voices/cutting_voice.h"
#include "sound/voices/drill_sound_state.h"
#include "sound/voices/glide_voice.h"
#include "sound/voices/impact_voice.h"
#include "sound/voices/motor_voice.h"
#include "sound/voices/peak_limiter.h"
#include "sound/voices/sound_mixer.h"

namespace tactooth {

/// Synthesises the drill's sound from the state of the simulation: kSoundRate, one channel, within
/// +-PeakLimiter::kCeiling. The same seed and calls give the same samples. Neither allocates nor locks. One thread at a
/// time.
class DrillSynthesiser {
public:
    /// Delay of the output behind its state, in samples.
    static constexpr int kDelay = PeakLimiter::kDelay;

    explicit DrillSynthesiser(std::uint64_t seed = 1);

    /// Volumes from the next block on; they change within some hundredths of a second.
    void setMixer(const SoundMixer& mixer);

    /// Recordings to play; null: none. The change is immediate, so call it in silence. `kit` stays valid as long as it
    /// is played.
    void setKit(const SoundKit* kit);

    /// The next `mono.size()` samples. `target` is the state at their end: the speed changes linearly, and every level
    /// and colour within some milliseconds, so that no change clicks. Begins at standstill.
    void render(const DrillSoundState& target, std::span<float> mono);

private:
    void renderRun(const DrillSoundState& state, std::span<float> run);

    SoundMixer mixer_;
    double speedRpm_ = 0.0;
    Rotation rotation_;
    MotorVoice motor_;
    CuttingVoice cutting_;
    ImpactVoice tap_;
    GlideVoice glide_;
    GainSmoother master_;
    PeakLimiter limiter_;
};

}  // namespace tactooth
