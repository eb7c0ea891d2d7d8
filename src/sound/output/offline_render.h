// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "geometry/util/expected.h"
#include "sound/output/sound_placement.h"
#include "sound/voices/drill_sound_state.h"
#include "sound/voices/sound_kit.h"
#include "sound/voices/sound_mixer.h"

namespace tactooth {

/// The drill at one moment of a session.
struct TimedSoundState {
    double time = 0.0;
    DrillSoundState state;
    SoundPlacement placement;
};

struct OfflineSettings {
    SoundMixer mixer;
    std::uint64_t seed = 1;
    bool headphones = false;              ///< HRTF instead of left-right balance
    bool room = false;                    ///< with the sound of the surgery
    std::shared_ptr<const SoundKit> kit;  ///< recordings instead of the synthesis; none: all synthesised
};

/// Two channels, alternating left and right samples, at kSoundRate.
using StereoSamples = std::vector<float>;

/// s: a WAV file of 0.7 GB.
inline constexpr double kMaxSoundLength = 3600;

/// Number of frames (one left and one right sample) of a sound of that length.
[[nodiscard]] std::size_t framesOf(double seconds);

/// Receives the next samples, left and right alternating.
using SampleSink = std::function<void(std::span<const float> stereo)>;

/// Renders the sound of the `seconds` from time 0 through OpenAL's loopback device, without a sound card, as fast as
/// the machine allows. Between two states, numbers are interpolated linearly, and all else is held; so it is before the
/// first state and after the last; of two states at one time the later one counts from then on. Sample n belongs to the
/// time n / kSoundRate, exactly. Errors: no state, times that decrease, a length that is not finite or over
/// kMaxSoundLength, an OpenAL without loopback; then `sink` was not called. It gets framesOf(seconds) frames in all, in
/// chunks of at most kSoundBlock, so that an hour takes no more memory than a second.
[[nodiscard]] Expected<void> renderInChunks(std::span<const TimedSoundState> track, double seconds,
                                            const OfflineSettings& settings, const SampleSink& sink);

/// The same, all at once, for a short sound.
[[nodiscard]] Expected<StereoSamples> renderOffline(std::span<const TimedSoundState> track, double seconds,
                                                    const OfflineSettings& settings = {});

}  // namespace tactooth
