// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sound/files/sound_format.h"
#include "sound/voices/drill_synthesiser.h"
#include "sound/voices/environment_voices.h"
#include "sound/voices/exposure_limiter.h"

namespace tactooth {

/// Positions of the sound sources, see SoundPlacement.
enum class SoundSource : std::uint8_t { Bur, Mouth, Suction };
inline constexpr std::size_t kSoundSources = 3;

/// One block of sound for each source.
using SoundBlock = std::array<std::array<float, kSoundBlock>, kSoundSources>;

/// The whole sound: the drill at the bur, the spray in the mouth, the suction beside it. The three together stay below
/// full scale, and below the exposure limit in the long run. The same seed and calls give the same samples. Neither
/// allocates nor locks. One thread at a time.
class Soundscape {
public:
    /// Delay of the output behind its state, in samples.
    static constexpr int kDelay = DrillSynthesiser::kDelay;

    /// Begins with the recordings of `kit`, see setKit().
    explicit Soundscape(std::uint64_t seed = 1, const SoundKit* kit = nullptr);

    /// Volumes from the next block on; they change within some hundredths of a second.
    void setMixer(const SoundMixer& mixer);

    /// Recordings to play; null: all synthesised. The change takes some hundredths of a second, with silence in
    /// between. `kit` stays valid until kit() is another one.
    void setKit(const SoundKit* kit) { pendingKit_ = kit; }
    [[nodiscard]] const SoundKit* kit() const { return kit_; }

    /// The next block; `target` is the state at its end.
    void render(const DrillSoundState& target, SoundBlock& block);

private:
    void renderEnvironment(const DrillSoundState& state, SoundBlock& block);
    void limitExposure(SoundBlock& block);
    void changeKit(SoundBlock& block);
    void useKit(const SoundKit* kit);

    DrillSynthesiser drill_;
    WaterVoice water_;
    SuctionVoice suction_;
    PeakLimiter waterLimiter_, suctionLimiter_;
    ExposureLimiter exposureLimiter_;
    double environment_ = 1.0;
    const SoundKit* kit_ = nullptr;
    const SoundKit* pendingKit_ = nullptr;
    GainSmoother kitGain_;
};

}  // namespace tactooth
