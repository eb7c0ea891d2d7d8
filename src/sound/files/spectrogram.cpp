// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// J. W. Cooley, J. W. Tukey, "An algorithm for the machine calculation of complex Fourier series", Math. Comp. 19
// (1965) 297: radix 2, in place.
#include "sound/files/spectrogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr std::size_t kWindow = 1024;  // 21 ms and 47 Hz: thin lines at 5 kHz, and short enough for an impact of 5 ms
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

    /// Amplitudes at the frequencies from 0 to half the rate, of the window that begins with `mono`; samples after its
    /// end count as silent.
    const std::array<float, kWindow / 2>& amplitudes(std::span<const float> mono) {
        for (std::size_t i = 0; i < kWindow; ++i) values_[i] = i < mono.size() ? window_[i] * mono[i] : 0.0f;
        transform();
        constexpr float kScale = 4.0f / kWindow;  // the mean of the window is 1/2, and half of a sine is at -f
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

struct SpectrogramBuilder::State {
    Spectrogram made;
    Fourier fourier;
    std::size_t frames;
    // Half a window of silence comes before the first frame: a window that begins at frame f of these has its middle at
    // frame f of the sound.
    std::vector<float> mono = std::vector<float>(kWindow / 2, 0.0f);
    std::size_t first = 0;   // frame that mono begins with
    std::size_t time = 0;    // of the window that is next
    std::size_t middle = 0;  // of that window

    [[nodiscard]] std::size_t from() const { return frames * time / made.times; }
    [[nodiscard]] std::size_t to() const { return std::max(from() + 1, frames * (time + 1) / made.times); }
    void begin() { middle = (from() + to()) / 2 - ((to() - from()) / 2) / kStep * kStep; }

    void take() {
        const std::size_t offset = middle - first;
        const std::size_t there = offset < mono.size() ? std::min(kWindow, mono.size() - offset) : 0;
        const auto& amplitudes = fourier.amplitudes(std::span(mono).subspan(std::min(offset, mono.size()), there));
        float* column = &made.level[time * made.bins];
        for (std::size_t bin = 0; bin < made.bins; ++bin)
            column[bin] = std::max(column[bin], decibelOf(amplitudes[bin]));
        middle += kStep;
        if (middle >= to() && ++time < made.times) begin();
    }

    void forget() {
        // A window may begin before the last one where parts are shorter than a frame.
        constexpr std::size_t kSpare = kWindow;
        const std::size_t keep = middle > kSpare ? middle - kSpare : 0;
        if (keep < first + 16 * kWindow) return;
        mono.erase(mono.begin(), mono.begin() + static_cast<std::ptrdiff_t>(std::min(keep - first, mono.size())));
        first = keep;
    }
};

SpectrogramBuilder::SpectrogramBuilder(std::size_t frames, std::size_t times) : state_(std::make_unique<State>()) {
    state_->made.times = times;
    state_->made.bins = kWindow / 2;
    state_->made.level.assign(times * kWindow / 2, Spectrogram::kSilence);
    state_->frames = frames;
    TACTOOTH_ASSERT(times > 0);
    state_->begin();
}

SpectrogramBuilder::SpectrogramBuilder(SpectrogramBuilder&&) noexcept = default;
SpectrogramBuilder::~SpectrogramBuilder() = default;

void SpectrogramBuilder::add(std::span<const float> stereo) {
    State& state = *state_;
    for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) state.mono.push_back(0.5f * (stereo[i] + stereo[i + 1]));
    const auto isComplete = [&] { return state.middle + kWindow <= state.first + state.mono.size(); };
    while (state.time < state.made.times && isComplete()) state.take();
    state.forget();
}

Spectrogram SpectrogramBuilder::finish() {
    State& state = *state_;
    while (state.time < state.made.times) state.take();
    return std::move(state.made);
}

Spectrogram spectrogramOf(std::span<const float> stereo, std::size_t times) {
    SpectrogramBuilder builder(stereo.size() / 2, times);
    builder.add(stereo);
    return builder.finish();
}

}  // namespace tactooth
