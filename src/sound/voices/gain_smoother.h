// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "sound/files/sound_format.h"

namespace tactooth {

/// Longest run of samples for which the voices hold one set of controls: 0.5 ms.
inline constexpr int kControlFrames = 24;

/// A linear ramp from one value to the next over a number of samples. Each ramp starts from the exact end of the last
/// one, so that rounding errors do not add up and a ramp to zero ends at zero.
class Ramp {
public:
    void aim(float target, int frames) {
        value_ = target_;
        target_ = target;
        step_ = (target_ - value_) / static_cast<float>(frames);
    }
    float next() { return value_ += step_; }
    void jumpTo(float value) {
        value_ = target_ = value;
        step_ = 0.0f;
    }
    [[nodiscard]] bool isZero() const { return target_ == 0.0f && step_ == 0.0f; }
    [[nodiscard]] bool isOne() const { return target_ == 1.0f && step_ == 0.0f; }

private:
    float value_ = 0.0f;
    float target_ = 0.0f;
    float step_ = 0.0f;
};

/// Share of the difference to its target that a first-order lag with `timeConstant` (s) covers in `frames` samples.
[[nodiscard]] inline float smoothingCoefficient(double timeConstant, int frames) {
    return static_cast<float>(-std::expm1(-frames / (kSoundRate * timeConstant)));
}

/// First-order lag, computed once for each run of controls. It reaches the target exactly once the rest is inaudible
/// (-100 dB of full scale for a gain), so that silence is digital silence.
class OnePoleSmoother {
public:
    float step(float target, float share) {
        constexpr float kInaudible = 1e-5f;
        value_ += share * (target - value_);
        if (std::abs(target - value_) < kInaudible * std::max(1.0f, std::abs(target))) value_ = target;
        return value_;
    }
    void jumpTo(float value) { value_ = value; }
    [[nodiscard]] float value() const { return value_; }

private:
    float value_ = 0.0f;
};

/// A gain without clicks: a lag for each run, and a ramp from sample to sample.
class GainSmoother {
public:
    void aim(float target, float share, int frames) { ramp_.aim(onePole_.step(target, share), frames); }
    float next() { return ramp_.next(); }
    [[nodiscard]] bool isZero() const { return ramp_.isZero(); }
    [[nodiscard]] bool isOne() const { return ramp_.isOne(); }
    void jumpTo(float value) {
        onePole_.jumpTo(value);
        ramp_.jumpTo(value);
    }

private:
    OnePoleSmoother onePole_;
    Ramp ramp_;
};

}  // namespace tactooth
