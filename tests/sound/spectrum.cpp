// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "spectrum.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>

#include "sound/files/sound_format.h"

namespace tactooth::test {

namespace {

using Complex = std::complex<double>;

// Cooley & Tukey, "An algorithm for the machine calculation of complex Fourier series", 1965: radix 2, in place.
void transform(std::vector<Complex>& values) {
    const std::size_t size = values.size();
    assert(std::has_single_bit(size));
    for (std::size_t i = 1, j = 0; i < size; ++i) {
        std::size_t bit = size >> 1;
        for (; (j & bit) != 0; bit >>= 1) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(values[i], values[j]);
    }
    for (std::size_t length = 2; length <= size; length *= 2) {
        const Complex turn = std::polar(1.0, -2.0 * std::numbers::pi / static_cast<double>(length));
        for (std::size_t start = 0; start < size; start += length) {
            Complex twiddle = 1.0;
            for (std::size_t k = 0; k < length / 2; ++k, twiddle *= turn) {
                const Complex even = values[start + k];
                const Complex odd = values[start + k + length / 2] * twiddle;
                values[start + k] = even + odd;
                values[start + k + length / 2] = even - odd;
            }
        }
    }
}

double blackmanHarris(double share) {
    constexpr std::array kTerms{0.35875, -0.48829, 0.14128, -0.01168};
    double sum = 0.0;
    for (std::size_t i = 0; i < kTerms.size(); ++i) {
        sum += kTerms[i] * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) * share);
    }
    return sum;
}

std::size_t binAt(const Spectrum& spectrum, double hz) {
    return std::min(spectrum.power.size() - 1,
                    static_cast<std::size_t>(std::llround(std::max(0.0, hz) / spectrum.hzPerBin)));
}

}  // namespace

Spectrum spectrumOf(std::span<const float> samples) {
    const std::size_t size = std::bit_floor(samples.size());
    std::vector<Complex> values(size);
    double windowSum = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
        const double window = blackmanHarris(static_cast<double>(i) / static_cast<double>(size));
        windowSum += window;
        values[i] = window * static_cast<double>(samples[i]);
    }
    transform(values);
    Spectrum spectrum;
    spectrum.hzPerBin = static_cast<double>(kSoundRate) / static_cast<double>(size);
    for (std::size_t i = 0; i < size / 2; ++i) spectrum.power.push_back(std::norm(2.0 * values[i] / windowSum));
    return spectrum;
}

Spectrum averageSpectrum(std::span<const float> samples, std::size_t size) {
    assert(samples.size() >= size);
    Spectrum mean;
    double pieces = 0.0;
    for (std::size_t start = 0; start + size <= samples.size(); start += size / 2, pieces += 1.0) {
        const Spectrum piece = spectrumOf(samples.subspan(start, size));
        mean.hzPerBin = piece.hzPerBin;
        mean.power.resize(piece.power.size());
        for (std::size_t i = 0; i < piece.power.size(); ++i) mean.power[i] += piece.power[i];
    }
    for (double& power : mean.power) power /= pieces;
    return mean;
}

double Spectrum::peakHz(double low, double high) const {
    const auto first = power.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(1, binAt(*this, low)));
    const auto last = power.begin() + static_cast<std::ptrdiff_t>(std::min(binAt(*this, high) + 1, power.size() - 1));
    const auto top = std::max_element(first, last);
    // A parabola through the logarithms of the peak and its neighbours: all but exact for this window.
    const double left = std::log(top[-1] + 1e-30), middle = std::log(top[0] + 1e-30), right = std::log(top[1] + 1e-30);
    const double shift = 0.5 * (left - right) / (left - 2.0 * middle + right);
    return (static_cast<double>(top - power.begin()) + shift) * hzPerBin;
}

double Spectrum::peakPower(double low, double high) const {
    double top = 0.0;
    for (std::size_t i = binAt(*this, low); i <= binAt(*this, high); ++i) top = std::max(top, power[i]);
    return top;
}

double Spectrum::bandPower(double low, double high) const {
    double sum = 0.0;
    for (std::size_t i = binAt(*this, low); i <= binAt(*this, high); ++i) sum += power[i];
    return sum;
}

double Spectrum::centroidHz() const {
    double sum = 0.0, weighted = 0.0;
    for (std::size_t i = 0; i < power.size(); ++i) {
        sum += power[i];
        weighted += power[i] * hz(i);
    }
    return weighted / sum;
}

double decibel(double powerRatio) { return 10.0 * std::log10(powerRatio); }

double rms(std::span<const float> samples) {
    double sum = 0.0;
    for (const float sample : samples) sum += static_cast<double>(sample) * static_cast<double>(sample);
    return std::sqrt(sum / static_cast<double>(samples.size()));
}

float peak(std::span<const float> samples) {
    float top = 0.0f;
    for (const float sample : samples) top = std::max(top, std::abs(sample));
    return top;
}

float largestJump(std::span<const float> samples) {
    float top = 0.0f;
    for (std::size_t i = 1; i < samples.size(); ++i) top = std::max(top, std::abs(samples[i] - samples[i - 1]));
    return top;
}

std::vector<float> renderDrill(DrillSynthesiser& synthesiser, double seconds,
                               const std::function<DrillSoundState(double)>& stateAt) {
    const auto blocks = static_cast<std::size_t>(std::llround(seconds * kSoundRate / kSoundBlock));
    std::vector<float> sound(blocks * kSoundBlock);
    for (std::size_t i = 0; i < blocks; ++i) {
        const double end = static_cast<double>((i + 1) * kSoundBlock) / kSoundRate;
        synthesiser.render(stateAt(end), std::span(sound).subspan(i * kSoundBlock, kSoundBlock));
    }
    return sound;
}

DrillSoundState spinning(double speedRpm, double pedal) {
    DrillSoundState state;
    state.speedRpm = speedRpm;
    state.pedal = pedal;
    return state;
}

std::vector<float> steadySound(const DrillSoundState& state, double seconds, double settle) {
    DrillSynthesiser synthesiser;
    const auto always = [&](double) { return state; };
    (void)renderDrill(synthesiser, settle, always);
    return renderDrill(synthesiser, seconds, always);
}

}  // namespace tactooth::test
