// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "sound/voices/drill_sound_state.h"
#include "sound/voices/drill_synthesiser.h"

namespace tactooth::test {

/// Power at each frequency of a part of a sound: Blackman-Harris window (leaks less than -92 dB), one-sided, a sine of
/// amplitude 1 gives a peak of 1.
struct Spectrum {
    std::vector<double> power;
    double hzPerBin = 0.0;

    [[nodiscard]] double hz(std::size_t bin) const { return static_cast<double>(bin) * hzPerBin; }
    /// Frequency of the highest peak within [low, high] Hz, interpolated between bins.
    [[nodiscard]] double peakHz(double low, double high) const;
    /// Highest power within [low, high] Hz.
    [[nodiscard]] double peakPower(double low, double high) const;
    /// Sum of power within [low, high] Hz.
    [[nodiscard]] double bandPower(double low, double high) const;
    /// Mean frequency, weighted by power.
    [[nodiscard]] double centroidHz() const;
};

/// Of the first 2^k samples, as many as there are.
[[nodiscard]] Spectrum spectrumOf(std::span<const float> samples);
/// Mean over half-overlapping pieces of `size` (a power of two).
[[nodiscard]] Spectrum averageSpectrum(std::span<const float> samples, std::size_t size);

[[nodiscard]] double decibel(double powerRatio);
[[nodiscard]] double rms(std::span<const float> samples);
[[nodiscard]] float peak(std::span<const float> samples);
/// Largest step from one sample to the next.
[[nodiscard]] float largestJump(std::span<const float> samples);

/// Renders `seconds` in blocks like the output; calls `stateAt` with the time at the end of each block.
[[nodiscard]] std::vector<float> renderDrill(DrillSynthesiser& synthesiser, double seconds,
                                             const std::function<DrillSoundState(double)>& stateAt);

/// A turbine at a steady speed with this pedal.
[[nodiscard]] DrillSoundState spinning(double speedRpm, double pedal = 1.0);

/// A steady state's sound after `settle` seconds.
[[nodiscard]] std::vector<float> steadySound(const DrillSoundState& state, double seconds, double settle = 0.3);

}  // namespace tactooth::test
