// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/impact_voice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sound/files/sound_format.h"

namespace tactooth {

namespace {

// Level of an impact: in proportion to its speed when gentle, at most kTopLevel of full scale. A careful hand touches
// at 5-50 mm/s.
constexpr double kTopLevel = 0.3;
constexpr double kHalfSpeed = 30.0;

// Level of a pull-out: in proportion to the force of the hold when that is small, at most kTopPullOutLevel. Chosen: a
// usual hold of 0.2 N is heard in a quiet room, and the strongest one of 1 N stays far below a hard impact.
constexpr double kTopPullOutLevel = 0.12;
constexpr double kHalfPullOutForce = 0.5;  // N

// What rings after a pull-out is the slender steel shank that the hold has bent. The numbers are chosen, not measured:
// a bright, short tick, higher than the tap of any tissue. As for an impact, the push is half a period long.
constexpr SoundCharacter kShank{.tapHz = 5200.0, .tapDecay = 0.006, .tapBrightness = 0.6};

// Modes of a short thick beam, such as a crown. Higher modes decay sooner.
constexpr std::array<double, 3> kModeRatios{1.0, 1.9, 3.1};
constexpr double kTopModeHz = 18000.0;
constexpr double kDecaysUntilSilent = 11.5;  // e^-11.5 = -100 dB

// The push is half a period of the lowest tone: it excites that tone fully and the higher ones less.
constexpr double kPushPeriods = 0.5;

double amplitudeAt(double contactSpeed) { return kTopLevel * contactSpeed / (contactSpeed + kHalfSpeed); }

double pullOutAmplitude(double force) { return kTopPullOutLevel * force / (force + kHalfPullOutForce); }

}  // namespace

void ImpactVoice::Ring::strike(const SoundCharacter& body, double amplitude) {
    pushFrames_ = std::max(3, static_cast<int>(kPushPeriods * kSoundRate / body.tapHz));
    pushDone_ = 0;
    ringFrames_ = pushFrames_ + static_cast<int>(kDecaysUntilSilent * body.tapDecay * kSoundRate);
    for (std::size_t i = 0; i < modes_.size(); ++i) {
        const double hz = std::min(kTopModeHz, body.tapHz * kModeRatios[i]);
        const double decay = body.tapDecay / kModeRatios[i];
        const double share = i == 0 ? 1.0 : body.tapBrightness / static_cast<double>(i + 1);
        modes_[i].turn = std::polar(static_cast<float>(std::exp(-1.0 / (decay * kSoundRate))),
                                    static_cast<float>(2.0 * std::numbers::pi * hz / kSoundRate));
        modes_[i].push = static_cast<float>(amplitude * share * 2.0 / pushFrames_);
    }
}

void ImpactVoice::Ring::addTo(std::span<float> out) {
    if (ringFrames_ <= 0) return;

    for (float& sample : out) {
        float push = 0.0f;
        if (pushDone_ < pushFrames_) {
            const float t = (static_cast<float>(++pushDone_) - 0.5f) / static_cast<float>(pushFrames_);
            push = 2.0f * t * (1.0f - t);  // a smooth hump, mean 1/3
        }
        for (Mode& mode : modes_) {
            mode.state = mode.state * mode.turn + mode.push * push;
            sample += mode.state.imag();
        }
    }
    ringFrames_ -= static_cast<int>(out.size());
    if (ringFrames_ <= 0) {
        for (Mode& mode : modes_) mode.state = 0.0f;
    }
}

void ImpactVoice::addTo(std::span<float> out, const DrillSoundState& state, double volume) {
    if (counting_ && state.contactCount != contactCount_)
        tooth_.strike(state.material, amplitudeAt(state.contactSpeed) * volume);
    if (counting_ && state.pullOutCount != pullOutCount_)
        shank_.strike(kShank, pullOutAmplitude(state.pullOutForce) * volume);
    counting_ = true;
    contactCount_ = state.contactCount;
    pullOutCount_ = state.pullOutCount;
    tooth_.addTo(out);
    shank_.addTo(out);
}

}  // namespace tactooth
