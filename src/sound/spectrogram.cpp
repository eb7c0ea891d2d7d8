// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// J. W. Cooley, J. W. Tukey, "An algorithm for the machine calculation of complex Fourier series", Math. Comp. 19
// (1965) 297: radix 2, in place.
#include "sound/spectrogram.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>

namespace tactooth {
namespace {

constexpr std::size_t kWindow = 1024;  // 21 ms and 47 Hz: a tone of 5 kHz is thin, a landing of 5 ms is short
constexpr std::size_t kStep = kWindow / 4;

using Complex = std::complex<float>;

class Fourier {
public:
    Fourier() {
        for (std::size_t i = 0; i < kWindow; ++i) {
            const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / kWindow;
            window_[i] = static_cast<float>(0.5 - 0.5 * std::cos(turn));  // Hann
            if (i < kWindow / 2) turns_[i] = Complex(std::polar(1.0, -turn));
        }
    }

    /// Amplitudes at the frequencies from 0 to half the rate, of the window that begins at `start`; samples beyond the
    /// ends are silent.
    const std::array<float, kWindow / 2>& amplitudes(std::span<const float> stereo, std::ptrdiff_t start) {
        const auto frames = static_cast<std::ptrdiff_t>(stereo.size() / 2);
        for (std::size_t i = 0; i < kWindow; ++i) {
            const std::ptrdiff_t frame = start + static_cast<std::ptrdiff_t>(i);
            const auto left = static_cast<std::size_t>(2 * frame);
            const bool inside = frame >= 0 && frame < frames;
            values_[i] = inside ? window_[i] * 0.5f * (stereo[left] + stereo[left + 1]) : 0.0f;
        }
        transform();
        constexpr float kScale = 4.0f / kWindow;  // the window's mean is 1/2, and half of a sine is at -f
        for (std::size_t i = 0; i < amplitudes_.size(); ++i) amplitudes_[i] = kScale * std::abs(values_[i]);
        return amplitudes_;
    }

private:
    void transform() {
        for (std::size_t i = 1, j = 0; i < kWindow; ++i) {
            std::size_t bit = kWindow >> 1;
            for (; (j & bit) != 0; bit >>= 1) j ^= bit;
            j ^= bit;
            if (i < j) std::swap(values_[i], values_[j]);
        }
        for (std::size_t half = 1; half < kWindow; half *= 2) {
            for (std::size_t start = 0; start < kWindow; start += 2 * half) {
                for (std::size_t k = 0; k < half; ++k) {
                    const Complex odd = values_[start + k + half] * turns_[k * (kWindow / 2 / half)];
                    values_[start + k + half] = values_[start + k] - odd;
                    values_[start + k] += odd;
                }
            }
        }
    }

    std::array<float, kWindow> window_{};
    std::array<Complex, kWindow / 2> turns_{};
    std::array<Complex, kWindow> values_{};
    std::array<float, kWindow / 2> amplitudes_{};
};

float decibelOf(float amplitude) {
    return std::max(Spectrogram::kSilence, 20.0f * std::log10(std::max(amplitude, 1e-9f)));
}

}  // namespace

Spectrogram spectrogramOf(std::span<const float> stereo, std::size_t times) {
    assert(times > 0);
    Spectrogram result{times, kWindow / 2, std::vector<float>(times * kWindow / 2, Spectrogram::kSilence)};
    Fourier fourier;
    const std::size_t frames = stereo.size() / 2;
    for (std::size_t time = 0; time < times; ++time) {
        const std::size_t from = frames * time / times, to = std::max(from + 1, frames * (time + 1) / times);
        float* column = &result.level[time * result.bins];
        for (std::size_t middle = (from + to) / 2 - ((to - from) / 2) / kStep * kStep; middle < to; middle += kStep) {
            const auto& amplitudes = fourier.amplitudes(
                stereo, static_cast<std::ptrdiff_t>(middle) - static_cast<std::ptrdiff_t>(kWindow / 2));
            for (std::size_t bin = 0; bin < result.bins; ++bin)
                column[bin] = std::max(column[bin], decibelOf(amplitudes[bin]));
        }
    }
    return result;
}

}  // namespace tactooth
