// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// How the outline of a crown from above departs from the ovals of its sections, as a Fourier series.
#pragma once

#include <cmath>
#include <vector>

namespace tactooth {

/// One harmonic, mm to the outside: the coefficients of cos m t and sin m t, where t is the direction from the tooth's
/// axis, from mesial to buccal.
struct OutlineWave {
    double cosine = 0, sine = 0;
};

/// The waves of order 0, 1, 2 and so on; that of order 0 has no sine.
using OutlineWaves = std::vector<OutlineWave>;

/// mm that they move the outline to the outside in the direction of (x, y).
[[nodiscard]] inline double outlineOffset(const OutlineWaves& waves, double x, double y) {
    const double length = std::hypot(x, y);
    constexpr double kAxis = 1e-6;  // mm: this close to the axis there is no direction
    if (waves.empty() || length < kAxis) return 0;
    const double cosine = x / length, sine = y / length;
    double c = 1, s = 0, sum = 0;  // cosine and sine of the order's multiple of the angle
    for (const OutlineWave& wave : waves) {
        sum += wave.cosine * c + wave.sine * s;
        const double next = c * cosine - s * sine;
        s = s * cosine + c * sine;
        c = next;
    }
    return sum;
}

}  // namespace tactooth
