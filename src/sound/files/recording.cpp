// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/files/recording.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "sound/files/messages.h"
#include "sound/files/windowed_sinc.h"

namespace tactooth {

namespace {

constexpr std::size_t kMultiple = 1 << (Recording::kLevels - 1);

constexpr double kFadeSeconds = 0.1;     // length of the cross-fade; at most a quarter of the sound
constexpr double kSearchSeconds = 0.01;  // by which the end may move for a better fit: a period of 100 Hz
constexpr double kSilence = 1e-4;        // root mean square, share of full scale: below it there is only noise

// Each level keeps frequencies below 0.417 of its rate (20 kHz at 48 kHz) and none above half of it.
constexpr double kPassed = 0.417;

using Samples = std::vector<float>;

double rootMeanSquare(std::span<const float> samples) {
    double sum = 0.0;
    for (const float sample : samples) sum += static_cast<double>(sample) * static_cast<double>(sample);
    return std::sqrt(sum / static_cast<double>(samples.size()));
}

Samples withoutMean(std::span<const float> samples) {
    const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
    Samples result(samples.begin(), samples.end());
    for (float& sample : result) sample -= static_cast<float>(mean);
    return result;
}

/// Correlation of two parts, -1..1.
double correlation(std::span<const float> a, std::span<const float> b) {
    double product = 0.0, powerA = 1e-20, powerB = 1e-20;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const auto x = static_cast<double>(a[i]), y = static_cast<double>(b[i]);
        product += x * y;
        powerA += x * x;
        powerB += y * y;
    }
    return product / std::sqrt(powerA * powerB);
}

struct Seam {
    std::size_t fade = 0;  // samples
    std::size_t end = 0;   // of the part that is used
    double correlation = 0.0;
};

Seam bestSeam(std::span<const float> sound, double rate) {
    const auto fade = std::min(static_cast<std::size_t>(kFadeSeconds * rate), sound.size() / 4);
    const auto search = std::min(static_cast<std::size_t>(kSearchSeconds * rate), sound.size() / 8);
    Seam best{fade, sound.size(), -2.0};
    for (std::size_t end = sound.size() - search; end <= sound.size(); ++end) {
        const double found = correlation(sound.first(fade), sound.subspan(end - fade, fade));
        if (found > best.correlation) best = {fade, end, found};
    }
    best.fade -= kMultiple - (best.end - best.fade) % kMultiple;  // a few samples fewer, for the length
    return best;
}

/// The loop begins with the end that fades into the beginning, at equal power whether or not the two are similar.
Samples looped(std::span<const float> sound, double rate) {
    const Seam seam = bestSeam(sound, rate);
    Samples loop(sound.begin(), sound.begin() + static_cast<std::ptrdiff_t>(seam.end - seam.fade));
    for (std::size_t i = 0; i < seam.fade; ++i) {
        const double angle = 0.5 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(seam.fade);
        const double in = std::sin(angle), out = std::cos(angle);
        const double power = 1.0 + 2.0 * std::max(0.0, seam.correlation) * in * out;
        const double tail = static_cast<double>(sound[seam.end - seam.fade + i]);
        loop[i] = static_cast<float>((in * static_cast<double>(sound[i]) + out * tail) / std::sqrt(power));
    }
    return loop;
}

/// The loop, low-passed cyclically; every `stride`-th sample of it. `passed`: edge of the passband, share of the rate.
Samples lowPassed(const Samples& loop, double passed, std::size_t stride) {
    const double stopped = passed * 0.5 / kPassed;
    const double transition = stopped - passed;
    const auto half = static_cast<std::ptrdiff_t>(std::ceil(2.51 / transition));  // Kaiser's length for 80 dB
    std::vector<double> taps;
    for (std::ptrdiff_t i = -half; i <= half; ++i)
        taps.push_back(windowedSinc(static_cast<double>(i), 0.5 * (passed + stopped), static_cast<double>(half) + 1.0));
    const auto size = static_cast<std::ptrdiff_t>(loop.size());
    Samples around;  // the loop, extended at both ends by the reach of the filter
    for (std::ptrdiff_t i = -half; i < size + half; ++i)
        around.push_back(loop[static_cast<std::size_t>((i % size + size) % size)]);
    Samples result(loop.size() / stride);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const float* from = &around[i * stride];
        double sum = 0.0;
        for (std::size_t tap = 0; tap < taps.size(); ++tap) sum += taps[tap] * static_cast<double>(from[tap]);
        result[i] = static_cast<float>(sum);
    }
    return result;
}

/// The loop with the extra samples that Recording::around() needs.
Samples padded(const Samples& loop) {
    constexpr std::ptrdiff_t kBefore = Recording::kTaps / 2 - 1;
    const auto size = static_cast<std::ptrdiff_t>(loop.size());
    Samples result;
    result.reserve(loop.size() + Recording::kTaps);
    for (std::ptrdiff_t i = -kBefore; i < size + Recording::kTaps - kBefore; ++i)
        result.push_back(loop[static_cast<std::size_t>((i % size + size) % size)]);
    return result;
}

std::string secondsText(double seconds) {
    const auto hundredths = std::lround(100.0 * seconds);
    return std::to_string(hundredths / 100) + "." + (hundredths % 100 < 10 ? "0" : "") +
           std::to_string(hundredths % 100);
}

Expected<void> check(std::span<const float> mono, double rate, std::string_view name) {
    const std::string who(name);
    if (!(rate >= Recording::kMinRate && rate <= Recording::kMaxRate)) {
        return unexpected(msg::kRecordingRate, who, std::lround(std::clamp(rate, -1e9, 1e9)));
    }
    const double seconds = static_cast<double>(mono.size()) / rate;
    if (seconds < Recording::kMinLength || seconds > Recording::kMaxLength) {
        return unexpected(msg::kRecordingLength, who, secondsText(seconds));
    }
    const auto bad = std::find_if(mono.begin(), mono.end(), [](float sample) { return !std::isfinite(sample); });
    if (bad != mono.end()) {
        return unexpected(msg::kRecordingNotFinite, who, bad - mono.begin() + 1);
    }
    return {};
}

}  // namespace

Expected<Recording> Recording::make(std::span<const float> mono, double rate, std::string_view name) {
    if (auto checked = check(mono, rate, name); !checked) return Unexpected{checked.error()};
    const Samples sound = withoutMean(mono);
    const double level = rootMeanSquare(sound);
    if (!(level > kSilence) || !std::isfinite(level)) return unexpected(msg::kRecordingSilent, name);

    Samples loop = lowPassed(looped(sound, rate), kPassed, 1);
    const double loopLevel = rootMeanSquare(loop);
    for (float& sample : loop) sample = static_cast<float>(static_cast<double>(sample) / loopLevel);
    Recording recording;
    recording.size_ = loop.size();
    recording.rate_ = rate;
    for (Samples& place : recording.levels_) {
        place = padded(loop);
        loop = lowPassed(loop, 0.5 * kPassed, 2);
    }
    return recording;
}

}  // namespace tactooth
