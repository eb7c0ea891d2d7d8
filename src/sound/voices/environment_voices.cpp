// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/environment_voices.h"

#include <array>

namespace tactooth {

namespace {

// Beside the turbine's tone (root mean square 0.042) both stay in the background, as in a practice: a spray adds 0.2 to
// 10 dB(A), and suction has 75-77 dB(A) against 76-82 of a cutting turbine.
constexpr double kWaterLevel = 0.007, kSuctionLevel = 0.011;  // root mean squares, shares of full scale
constexpr double kValveSeconds = 0.06;                        // time constant of the valves of water and air

// Spray: droplets of some tens of micrometres hiss evenly from 2.5 to 10 kHz. Trickle: bubbles of 1 to 4 mm.
constexpr double kSprayHz = 5000.0, kSprayOctaves = 2.0;
constexpr BubbleKind kTrickle{800.0, 3200.0, 60.0, 0.15};
constexpr float kTrickleShare = 2.5f;  // amplitude of a bubble over the root mean square of the hiss

// Suction: a rush below 1 kHz with the quarter-wave tone of a tube of 15 cm, 570 Hz. Slurp: big bubbles torn apart.
constexpr double kRushHz = 1400.0, kRushOctaves = 3.0;
constexpr double kTubeHz = 570.0, kTubeOctaves = 0.35;
constexpr float kTubeShare = 0.5f;
constexpr BubbleKind kSlurp{250.0, 1300.0, 140.0, 0.4};
constexpr float kSlurpShare = 7.0f;

constexpr std::array<double, kControlFrames> kNoTurns{};  // neither follows the bur

}  // namespace

WaterVoice::WaterVoice(std::uint64_t seed) : hiss_(seed), trickle_(seed + 1, kTrickle) {
    hiss_.tune(kSprayHz, kSprayOctaves, 1.0f);
}

void WaterVoice::addTo(std::span<float> out, double flow, double volume) {
    const int frames = static_cast<int>(out.size());
    const float share = smoothingCoefficient(kValveSeconds, frames);
    const double level = kWaterLevel * flow * volume;
    if (part_ != nullptr) return recorded_.addTo(out, *part_, level, share, kNoTurns);
    gain_.aim(static_cast<float>(level), share, frames);
    if (gain_.isZero()) return;
    std::array<float, kControlFrames> drops{};
    trickle_.addTo(std::span(drops).first(out.size()), static_cast<float>(flow));
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += gain_.next() * (hiss_.next() + kTrickleShare * drops[i]);
}

SuctionVoice::SuctionVoice(std::uint64_t seed)
    : rush_(seed), tube_(seed + 1), slurp_(seed + 2, kSlurp), slurpModulator_(seed + 3, 7.0) {
    rush_.tune(kRushHz, kRushOctaves, 1.0f);
    tube_.tune(kTubeHz, kTubeOctaves, 1.0f);
}

void SuctionVoice::addTo(std::span<float> out, double flow, double water, double volume) {
    const int frames = static_cast<int>(out.size());
    const float share = smoothingCoefficient(kValveSeconds, frames);
    const double level = kSuctionLevel * flow * volume;
    if (part_ != nullptr) return recorded_.addTo(out, *part_, level, share, kNoTurns);
    gain_.aim(static_cast<float>(level), share, frames);
    const float gulp = 0.5f + 0.5f * slurpModulator_.advance(frames);
    wet_.aim(kSlurpShare * static_cast<float>(water) * gulp * gulp, share, frames);
    if (gain_.isZero()) return;
    std::array<float, kControlFrames> slurp{};
    slurp_.addTo(std::span(slurp).first(out.size()), static_cast<float>(water));
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] += gain_.next() * (rush_.next() + kTubeShare * tube_.next() + wet_.next() * slurp[i]);
}

}  // namespace tactooth
