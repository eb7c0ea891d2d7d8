// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/voices/motor_voice.h"

#include <cmath>

namespace tactooth {

namespace {

// Amplitude of the rotation's tone at free speed, as a share of full scale: -24 dB leaves room for the cut, which is
// louder (handpieces measure 57-87 dB(A) at the dentist's ear, cutting above free running).
constexpr double kRotationLevel = 0.06;
constexpr double kRecordedLevel = 0.046;  // root mean square of all tones of the synthesis at free speed
constexpr double kLagSeconds = 0.008;     // of every tone's gain: too fast to notice, too slow to click
constexpr double kAirSeconds = 0.03;      // of the drive air behind its valve

// One tone is the bearing's: the cage of its balls rotates at 0.4 of the speed and slips a little.
constexpr int kCageTone = 4;
constexpr double kCageSlip = 0.015;

struct TonePartial {
    double ratio;  // frequency over the rotation's
    double level;  // amplitude over the rotation's tone
};

struct MotorSpectrum {
    std::array<TonePartial, MotorVoice::kTones> tones;
    double level;      // of all tones against an air turbine's
    double hissLevel;  // root mean square at full pedal, share of full scale
};

// Air turbine: rotation with overtones at -9, -15 and -20 dB, cage at -25 dB, passing of the rotor's eight blades
// (above hearing at full speed: measured peaks at 5.6 and 46.5 kHz; heard as a falling whistle while it runs down).
// Electric 1:5: bearings and gears without drive air, the motor's own turns at a fifth of the bur's,
// gear mesh at 2.2. Low speed: purr of the rotation with many gear tones between 1 and 5 kHz at 25 000 rev/min.
constexpr std::array<MotorSpectrum, 3> kMotors{{
    {{{{1.0, 1.0}, {2.0, 0.35}, {3.0, 0.18}, {4.0, 0.1}, {0.4, 0.056}, {8.0, 0.2}}}, 1.0, 0.013},
    {{{{1.0, 1.0}, {2.0, 0.3}, {0.2, 0.5}, {2.2, 0.2}, {0.4, 0.056}, {3.0, 0.12}}}, 0.6, 0.004},
    {{{{1.0, 1.0}, {2.0, 0.6}, {3.0, 0.3}, {7.0, 0.35}, {0.4, 0.1}, {11.0, 0.2}}}, 0.5, 0.002},
}};

constexpr double kHissCentreHz = 4900.0;  // 2 .. 12 kHz
constexpr double kHissOctaves = 2.58;

// 1 below 17 kHz, 0 from 21 kHz: nothing reaches half the rate, against aliasing. It is computed for each sample, since
// a tone at eight times the rotation crosses that range within a millisecond or two. `turns` are those of a sample.
constexpr double kFullTurns = 17000.0 / kSoundRate, kNoneTurns = 21000.0 / kSoundRate;
float belowHalfRate(double turns) {
    if (turns <= kFullTurns) return 1.0f;
    const auto t = static_cast<float>(std::max(0.0, (kNoneTurns - turns) / (kNoneTurns - kFullTurns)));
    return t * t * (3.0f - 2.0f * t);
}

// Amplitude relative to that at free speed: aerodynamic and bearing noise grow a little faster than the speed.
double loudnessAt(double speedShare) { return std::pow(std::min(speedShare, 1.5), 1.2); }

const MotorSpectrum& motorSpectrum(MotorKind kind) { return kMotors[static_cast<std::size_t>(kind) % kMotors.size()]; }

}  // namespace

MotorVoice::MotorVoice(std::uint64_t seed)
    : cageSlipModulator_(seed + 1, 2.0), airModulator_(seed + 2, 5.0), hiss_(seed + 3) {}

void MotorVoice::addTo(std::span<float> out, const DrillSoundState& state, double volume,
                       std::span<const double> turnsPerFrame) {
    const int frames = static_cast<int>(out.size());
    if (part_ != nullptr) {
        const double level = kRecordedLevel * volume * loudnessAt(state.speedRpm / state.freeSpeedRpm);
        recorded_.addTo(out, *part_, level, smoothingCoefficient(kLagSeconds, frames), turnsPerFrame);
        return;
    }
    aimTones(state, volume, frames);
    const MotorSpectrum& recipe = motorSpectrum(state.motor);
    for (int i = 0; i < kTones; ++i) {
        if (tones_[i].gain.isZero()) continue;
        addTone(out, i, i == kCageTone ? cageTurns_ : recipe.tones[i].ratio, turnsPerFrame);
    }
    addHiss(out, state, volume);
}

void MotorVoice::aimTones(const DrillSoundState& state, double volume, int frames) {
    const MotorSpectrum& recipe = motorSpectrum(state.motor);
    cageTurns_ =
        recipe.tones[kCageTone].ratio * (1.0 + kCageSlip * static_cast<double>(cageSlipModulator_.advance(frames)));
    const double breath = 1.0 + 0.06 * static_cast<double>(airModulator_.advance(frames));
    const double level =
        kRotationLevel * recipe.level * volume * breath * loudnessAt(state.speedRpm / state.freeSpeedRpm);
    const float share = smoothingCoefficient(kLagSeconds, frames);
    for (int i = 0; i < kTones; ++i) {
        const TonePartial& tone = recipe.tones[i];
        // Under load the overtones and the cage get louder, and the tone of the rotation stays.
        const double strain = i == 0 ? 1.0 : 1.0 + (i == kCageTone ? 3.0 : 0.7) * state.load;
        tones_[i].gain.aim(static_cast<float>(level * tone.level * strain), share, frames);
    }
}

void MotorVoice::addTone(std::span<float> out, int index, double ratio, std::span<const double> turnsPerFrame) {
    if (ratio * std::min(turnsPerFrame.front(), turnsPerFrame.back()) > kNoneTurns) return;  // all of it inaudible
    Tone& tone = tones_[index];
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double turns = ratio * turnsPerFrame[i];
        out[i] += tone.gain.next() * belowHalfRate(turns) * sineOfTurns(tone.phase.advance(turns));
    }
}

// The air still hisses through a stalled rotor: hiss without the whine is the sound of a stall.
void MotorVoice::addHiss(std::span<float> out, const DrillSoundState& state, double volume) {
    const int frames = static_cast<int>(out.size());
    const float share = smoothingCoefficient(kAirSeconds, frames);
    const double flow = state.pedal * (0.6 + 0.4 * std::min(1.0, state.speedRpm / state.freeSpeedRpm));
    hissGain_.aim(static_cast<float>(motorSpectrum(state.motor).hissLevel * flow * volume), share, frames);
    if (hissGain_.isZero()) return;
    hiss_.tune(kHissCentreHz, kHissOctaves, share);
    for (float& sample : out) sample += hissGain_.next() * hiss_.next();
}

}  // namespace tactooth
