// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "sound/voices/gain_smoother.h"

namespace tactooth {

/// A-weighting: curve A of IEC 61672-1, within 0.4 dB up to 10 kHz.
class AWeighting {
public:
    AWeighting();
    float process(float sample);

private:
    /// A first-order filter, by the trapezoidal rule (like BandPass).
    class Pole {
    public:
        void tune(double hz, double exactAt);
        float lowPass(float input) {
            const float change = (input - state_) * share_;
            const float output = state_ + change;
            state_ = output + change;
            return output;
        }
        float highPass(float input) { return input - lowPass(input); }

    private:
        float share_ = 0.0f, state_ = 0.0f;
    };
    Pole low_[4], high_[2];
};

/// Protects the ear in a long session: it keeps the A-weighted mean over about a minute at or below kLimitDecibel by
/// slowly reducing the gain. A steady cut at 4 W stays just below it; a whole minute of full power, or recordings that
/// are too loud, do not. Only the listener's volume setting decides how loud full scale is. A player according to EN
/// 50332-1 gives at most 100 dB(A) at -10 dB of full scale, so 95 dB(A) at the limit with full volume, and the 80 dB(A)
/// of a real turbine 15 dB below full volume.
class ExposureLimiter {
public:
    static constexpr double kLimitDecibel = -15.0;  ///< of full scale, A-weighted
    static constexpr double kSeconds = 60.0;        ///< time constant of the mean

    ExposureLimiter() { ramp_.jumpTo(1.0f); }

    /// Gain for this block, a ramp from that of the last block. `sum` is the block as one listener hears it.
    [[nodiscard]] Ramp gainFor(std::span<const float> sum);

private:
    AWeighting weighting_;
    Ramp ramp_;
    double mean_ = 0.0;  // power
    float gain_ = 1.0f;
};

}  // namespace tactooth
