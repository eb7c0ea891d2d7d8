// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "haptics/servo_loop.h"

namespace tactooth {

/// Whether the computation is too slow for the servo rate: one tick in a hundred takes more than half of the period.
/// The other half belongs to the system. False below 1000 ticks.
[[nodiscard]] bool isOverloaded(const ServoTiming& timing, double rateHz);

/// The 99th percentile of the tick duration, us.
[[nodiscard]] double tickP99(const ServoTiming& timing);

/// One sentence on the duration of the ticks and the remedy; empty if there is no overload.
[[nodiscard]] std::string overloadAdvice(const ServoTiming& timing, double rateHz);

}  // namespace tactooth
