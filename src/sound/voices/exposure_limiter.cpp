// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/exposure_limiter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactooth {

namespace {

constexpr float kAtOneKilohertz = 1.2589f;  // +2.0 dB, so that the curve passes 1 kHz at 0 dB
constexpr float kMaxGainDrop = 0.11f;       // 1 dB a second downwards: not audible
const double kCapPower = 0.5 * std::pow(10.0, ExposureLimiter::kLimitDecibel / 10.0);  // a sine of full scale has 1/2

}  // namespace

void AWeighting::Pole::tune(double hz, double exactAt) {
    const double g = std::tan(std::numbers::pi * exactAt / kSoundRate) * hz / exactAt;
    share_ = static_cast<float>(g / (1.0 + g));
}

AWeighting::AWeighting() {
    low_[0].tune(20.6, 20.6);
    low_[1].tune(20.6, 20.6);
    low_[2].tune(107.7, 107.7);
    low_[3].tune(737.9, 737.9);
    high_[0].tune(12194.0, 10000.0);  // exact where hearing is sensitive, and not at the corner frequency above
    high_[1].tune(12194.0, 10000.0);
}

float AWeighting::process(float sample) {
    for (Pole& pole : low_) sample = pole.highPass(sample);
    for (Pole& pole : high_) sample = pole.lowPass(sample);
    return kAtOneKilohertz * sample;
}

Ramp ExposureLimiter::gainFor(std::span<const float> sum) {
    double power = 0.0;
    for (const float sample : sum) {
        const auto weighted = static_cast<double>(weighting_.process(sample));
        power += weighted * weighted;
    }
    const int frames = static_cast<int>(sum.size());
    mean_ += static_cast<double>(smoothingCoefficient(kSeconds, frames)) * (power / frames - mean_);
    const auto wanted = static_cast<float>(mean_ > kCapPower ? std::sqrt(kCapPower / mean_) : 1.0);
    gain_ = std::max(wanted, gain_ * (1.0f - kMaxGainDrop * static_cast<float>(frames) / kSoundRate));
    ramp_.aim(gain_, frames);
    return ramp_;
}

}  // namespace tactooth
