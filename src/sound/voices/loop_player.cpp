// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/loop_player.h"

#include <algorithm>
#include <cmath>

#include "sound/files/sound_format.h"
#include "sound/files/windowed_sinc.h"

namespace tactooth {

namespace {

constexpr int kPhases = 256;  // with linear interpolation between two: the error is -98 dB
constexpr int kTaps = Recording::kTaps;

/// Taps for each phase between two samples, and one phase more for the interpolation after the last.
struct Kernel {
    std::array<std::array<float, kTaps>, kPhases + 1> taps;

    Kernel() {
        for (std::size_t phase = 0; phase < taps.size(); ++phase) {
            for (int tap = 0; tap < kTaps; ++tap) {
                const double at = tap - (kTaps / 2 - 1) - static_cast<double>(phase) / kPhases;
                taps[phase][static_cast<std::size_t>(tap)] = static_cast<float>(windowedSinc(at, 0.5, 0.5 * kTaps));
            }
        }
    }
};
const Kernel kKernel;

float interpolated(const Recording& recording, int level, double place) {
    const double own = place / (1 << level);
    const auto whole = static_cast<std::size_t>(own);
    const double phase = (own - static_cast<double>(whole)) * kPhases;
    const auto row = static_cast<std::size_t>(phase);
    const auto rest = static_cast<float>(phase - static_cast<double>(row));
    const float* samples = recording.around(level, whole);
    const auto &first = kKernel.taps[row], &second = kKernel.taps[row + 1];
    float sum = 0.0f;
    for (std::size_t tap = 0; tap < kTaps; ++tap)
        sum += samples[tap] * (first[tap] + rest * (second[tap] - first[tap]));
    return sum;
}

}  // namespace

float LoopPlayer::next(const Recording& recording, double pitch) {
    const double step = std::clamp(pitch * recording.rate() / kSoundRate, 0.0, kMaxStep);
    position_ += step;
    const auto size = static_cast<double>(recording.size());
    if (position_ >= size) position_ = std::fmod(position_, size);

    // A level is used alone up to 1.2 times its step (what is kept of it then reaches half the rate). Above that, the
    // next level is faded in, so that a change of pitch makes no audible switch.
    constexpr double kHoldsOut = 1.2;
    int level = 0;
    while (level + 1 < Recording::kLevels && step > kHoldsOut * (1 << level)) ++level;
    const float here = interpolated(recording, level, position_);
    const double beyond = step / (1 << level) - 1.0;
    if (beyond <= 0.0 || level + 1 == Recording::kLevels) return here;
    const auto share = static_cast<float>(beyond / (kHoldsOut - 1.0));
    return here + share * (interpolated(recording, level + 1, position_) - here);
}

}  // namespace tactooth
