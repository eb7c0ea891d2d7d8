// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/files/windowed_sinc.h"

#include <cmath>
#include <numbers>

namespace tactooth {

namespace {

constexpr double kBeta = 7.86;  // 80 dB by Kaiser's formula 0.1102 (80 - 8.7)

double besselI0(double x) {
    double sum = 1.0, term = 1.0;
    for (int k = 1; k < 40; ++k) {
        term *= (x / (2.0 * k)) * (x / (2.0 * k));
        sum += term;
    }
    return sum;
}

}  // namespace

double windowedSinc(double at, double cutoff, double halfWidth) {
    const double share = at / halfWidth;
    if (std::abs(share) >= 1.0) return 0.0;
    static const double atMiddle = besselI0(kBeta);
    const double window = besselI0(kBeta * std::sqrt(1.0 - share * share)) / atMiddle;
    const double x = 2.0 * std::numbers::pi * cutoff * at;
    return 2.0 * cutoff * window * (std::abs(x) < 1e-9 ? 1.0 : std::sin(x) / x);
}

}  // namespace tactooth
