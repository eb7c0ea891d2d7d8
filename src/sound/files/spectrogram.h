// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace tactooth {

/// Level of each frequency over time: a sine of full scale has 0 dB.
struct Spectrogram {
    std::size_t times = 0;
    std::size_t bins = 0;      ///< frequencies, from 0 to half of kSoundRate, evenly spaced
    std::vector<float> level;  ///< dB of full scale, at least kSilence; the frequencies of one time are contiguous

    static constexpr float kSilence = -120.0f;

    [[nodiscard]] float at(std::size_t time, std::size_t bin) const { return level[time * bins + bin]; }
};

/// Computes the spectrogram of a sound that comes in chunks, of which only the last window stays in memory. Left and
/// right samples alternate, and it takes their mean. The sound is cut into `times` parts of equal length. Of a part
/// longer than one window, the loudest of its windows counts for each frequency, so that no click is missed.
class SpectrogramBuilder {
public:
    /// `frames`: number of sample pairs that will come. `times`: at least 1.
    SpectrogramBuilder(std::size_t frames, std::size_t times);
    SpectrogramBuilder(SpectrogramBuilder&&) noexcept;
    ~SpectrogramBuilder();

    void add(std::span<const float> stereo);
    /// Call it once, after all frames.
    [[nodiscard]] Spectrogram finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The same for samples in memory.
[[nodiscard]] Spectrogram spectrogramOf(std::span<const float> stereo, std::size_t times);

}  // namespace tactooth
