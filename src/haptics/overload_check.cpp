// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/overload_check.h"

#include <cmath>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr double kQuantile = 0.99;
constexpr double kMaxPeriodShare = 0.5;    // of the period
constexpr std::uint64_t kMinTicks = 1000;  // the slowest hundredth then has ten ticks

}  // namespace

double tickP99(const ServoTiming& timing) { return timing.tick.quantile(kQuantile); }

bool isOverloaded(const ServoTiming& timing, double rateHz) {
    TACTOOTH_ASSERT(rateHz > 0);
    if (timing.ticks.load(std::memory_order_relaxed) < kMinTicks) return false;
    return tickP99(timing) > kMaxPeriodShare * 1e6 / rateHz;
}

std::string overloadAdvice(const ServoTiming& timing, double rateHz) {
    if (!isOverloaded(timing, rateHz)) return {};
    return "The scene is heavy for this machine: one tick in a hundred takes " +
           std::to_string(std::lround(tickP99(timing))) + " of the " + std::to_string(std::lround(1e6 / rateHz)) +
           " us that there are; take fewer triangles ('tactooth simplify'), a bur of fewer triangles or a lower rate, "
           "and close other programs.";
}

}  // namespace tactooth
