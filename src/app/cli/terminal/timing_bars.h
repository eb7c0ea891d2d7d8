// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "haptics/latency_histogram.h"

namespace tactooth {

/// One histogram of timingBars.
struct TimingBars {
    const char* title;  ///< at most 20 letters
    LatencyCounts counts;
};

/// Histograms side by side, a line for each octave of microseconds: bars and numbers, four of them in 100 columns. The
/// bars grow with the logarithm of the number, so that a single late tick among thousands is seen.
[[nodiscard]] std::string timingBars(std::span<const TimingBars> histograms);

}  // namespace tactooth
