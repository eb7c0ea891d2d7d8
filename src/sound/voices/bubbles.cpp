// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/bubbles.h"

#include <cmath>
#include <numbers>

#include "sound/files/sound_format.h"

namespace tactooth {

namespace {

constexpr double kDecaysUntilSilent = 7.0;  // e^-7 = -61 dB, below the noise around it
constexpr double kTopHz = 12000.0;          // far enough below half the rate for a tone that rises

double dampingOf(double hz) { return 0.13 * hz + 0.0072 * std::pow(hz, 1.5); }

}  // namespace

void Bubbles::addTo(std::span<float> out, float flow) {
    const float chance = flow * static_cast<float>(kind_.perSecond / kSoundRate);
    for (float& sample : out) {
        if (noise_.nextPositive() < chance) start();
        for (Bubble& bubble : bubbles_) {
            if (bubble.framesLeft == 0) continue;
            --bubble.framesLeft;
            bubble.turn *= bubble.bend;
            bubble.state *= bubble.turn;
            sample += bubble.state.imag();
        }
    }
}

// A bubble that still rings is not replaced: the next bubble waits for a free voice.
void Bubbles::start() {
    Bubble& bubble = bubbles_[next_];
    if (bubble.framesLeft > 0) return;
    next_ = (next_ + 1) % bubbles_.size();
    const double octaves = std::log2(kind_.highHz / kind_.lowHz);
    const double hz = kind_.lowHz * std::exp2(octaves * static_cast<double>(noise_.nextPositive()));
    const double seconds = kDecaysUntilSilent / dampingOf(hz);
    const double frames = seconds * kSoundRate;
    const double risen = std::min(hz * (1.0 + kind_.rise), kTopHz);
    const double turn = 2.0 * std::numbers::pi / kSoundRate;
    bubble.framesLeft = static_cast<int>(frames);
    bubble.turn = std::polar(static_cast<float>(std::exp(-dampingOf(hz) / kSoundRate)), static_cast<float>(turn * hz));
    bubble.bend = std::polar(1.0f, static_cast<float>(turn * (risen - hz) / frames));
    bubble.state = noise_.nextPositive();  // begins at a zero of its sine, to avoid a click
}

}  // namespace tactooth
