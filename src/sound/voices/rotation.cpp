// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/rotation.h"

#include "sound/files/sound_format.h"

namespace tactooth {

namespace {

constexpr double kFlutter = 0.001;  // share of the speed

}  // namespace

RandomModulator::RandomModulator(std::uint64_t seed, double timesPerSecond)
    : noise_(seed), placesPerFrame_(static_cast<float>(timesPerSecond / kSoundRate)) {}

float RandomModulator::advance(int frames) {
    progress_ += placesPerFrame_ * static_cast<float>(frames);
    if (progress_ >= 1.0f) {
        progress_ = 0.0f;
        from_ = to_;
        to_ = noise_.next();
    }
    const float eased = progress_ * progress_ * (3.0f - 2.0f * progress_);
    return from_ + (to_ - from_) * eased;
}

void Rotation::advanceTo(double speedRpm, std::span<double> turnsPerFrame) {
    const int frames = static_cast<int>(turnsPerFrame.size());
    const double flutter = 1.0 + kFlutter * static_cast<double>(modulator_.advance(frames));
    const double target = speedRpm / 60.0 / kSoundRate * flutter;
    const double step = (target - turns_) / frames;
    for (double& turns : turnsPerFrame) turns = turns_ += step;
    turns_ = target;
}

}  // namespace tactooth
