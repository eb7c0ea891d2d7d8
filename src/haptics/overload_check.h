// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "haptics/servo_loop.h"

namespace tactooth {

/// Whether the ticks of a scene take so long that the force is late: one tick in a hundred takes more than half of the
/// period. The other half belongs to the system. False below 1000 ticks.
[[nodiscard]] bool isOverloaded(const ServoTiming& timing, double rateHz);

/// The 99th percentile of the tick duration, us.
[[nodiscard]] double tickP99(const ServoTiming& timing);

/// One sentence on the duration of the ticks and the remedy; empty if the scene is not too heavy.
[[nodiscard]] std::string overloadAdvice(const ServoTiming& timing, double rateHz);

}  // namespace tactooth
