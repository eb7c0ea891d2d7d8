// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace tactooth {

// How smooth a movement is, from its speed at equal intervals. `rate`: samples each second. The unit of the speed does
// not matter. Nothing comes back where the movement is too short or does not move.

/// Spectral arc length up to 10 Hz: about -1.4 for one smooth stroke, lower for a broken one. S. Balasubramanian,
/// A. Melendez-Calderon, E. Burdet, IEEE Trans. Biomed. Eng. 59, 2012.
[[nodiscard]] std::optional<double> spectralArcLength(std::span<const double> speed, double rate);

/// Log dimensionless jerk: higher is smoother. S. Balasubramanian et al., J. NeuroEng. Rehabil. 12, 2015.
[[nodiscard]] std::optional<double> logDimensionlessJerk(std::span<const double> speed, double rate);

/// The frequency below which 95 % of the power of the speed lies, without its mean, Hz.
[[nodiscard]] std::optional<double> frequency95(std::span<const double> speed, double rate);

/// Without what is faster than `cutoff`, Hz, and without delay: a Butterworth filter of second order, forwards and
/// backwards. `cutoff` is below half of `rate`. At the ends the samples are continued by their reflection.
[[nodiscard]] std::vector<double> lowPassed(std::span<const double> samples, double rate, double cutoff);

}  // namespace tactooth
