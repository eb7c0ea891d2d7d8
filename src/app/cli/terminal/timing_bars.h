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

/// Formats histograms side by side, one line for each octave of microseconds. It prints bars and numbers; four
/// histograms fit into 100 columns. The bars grow with the logarithm of the count, so that one late tick among
/// thousands is visible.
[[nodiscard]] std::string timingBars(std::span<const TimingBars> histograms);

}  // namespace tactooth
