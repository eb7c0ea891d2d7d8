// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/peak_limiter.h"

#include <algorithm>
#include <cmath>

#include "sound/files/sound_format.h"

namespace tactooth {

namespace {

constexpr float kRelease = 1.0f / (0.05f * kSoundRate);  // share of the way back to 1 in each sample: 50 ms
constexpr float kBackAtOne = 0.9999f;

}  // namespace

PeakLimiter::PeakLimiter(float ceiling) : ceiling_(ceiling) {
    needed_.fill(1.0f);
    allowed_.fill(1.0f);
}

float PeakLimiter::neededGain() const {
    return limitedCount_ == 0 ? 1.0f : *std::min_element(needed_.begin(), needed_.end());
}

// The mean over kWindow of gains that are each low enough for the oldest sample in the window is low enough for it,
// too, and falls linearly.
void PeakLimiter::process(std::span<float> samples) {
    for (float& sample : samples) {
        const float peak = std::abs(sample);
        const float needed = peak > ceiling_ ? ceiling_ / peak : 1.0f;
        limitedCount_ += static_cast<int>(needed < 1.0f) - static_cast<int>(needed_[position_] < 1.0f);
        needed_[position_] = needed;
        samples_[position_] = sample;

        gain_ = std::min(neededGain(), gain_ + (1.0f - gain_) * kRelease);
        if (limitedCount_ == 0 && gain_ > kBackAtOne) gain_ = 1.0f;
        allowedSum_ += static_cast<double>(gain_) - static_cast<double>(allowed_[position_]);
        allowed_[position_] = gain_;

        position_ = (position_ + 1) % kWindow;  // now the oldest sample's
        sample = samples_[position_] * static_cast<float>(allowedSum_ / kWindow);
    }
}

}  // namespace tactooth
