// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tactooth {

/// Impulse response of an ideal low-pass at `cutoff` (share of the rate) with a Kaiser window, `at` samples from its
/// middle; zero from `halfWidth` on. The stopband is at -80 dB. J. F. Kaiser, "Nonrecursive digital filter design using
/// the I0-sinh window function", ISCAS 1974.
[[nodiscard]] double windowedSinc(double at, double cutoff, double halfWidth);

}  // namespace tactooth
