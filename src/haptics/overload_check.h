// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "haptics/servo_loop.h"

namespace tactooth {

/// Whether the ticks of a scene take so long that the force is late: one tick in a hundred takes more than half of the
/// period, and the rest of it belongs to the system. Nothing is said of fewer than 1000 ticks.
[[nodiscard]] bool isOverloaded(const ServoTiming& timing, double rateHz);

/// us: one tick in a hundred takes longer.
[[nodiscard]] double tickP99(const ServoTiming& timing);

/// One sentence that says how long the ticks take and what to do; empty if the scene is not heavy.
[[nodiscard]] std::string overloadAdvice(const ServoTiming& timing, double rateHz);

}  // namespace tactooth
