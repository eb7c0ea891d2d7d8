// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/scene_load.h"

#include <cmath>

namespace tactooth {
namespace {

constexpr double kQuantile = 0.99;
constexpr double kMostShare = 0.5;            // of the period
constexpr std::uint64_t kFewestTicks = 1000;  // ten in the hundredth that is looked at

}  // namespace

double slowTick(const ServoTiming& timing) { return timing.tick.quantile(kQuantile); }

bool isSceneHeavy(const ServoTiming& timing, double rateHz) {
    if (timing.ticks.load(std::memory_order_relaxed) < kFewestTicks) return false;
    return slowTick(timing) > kMostShare * 1e6 / rateHz;
}

std::string heavySceneAdvice(const ServoTiming& timing, double rateHz) {
    if (!isSceneHeavy(timing, rateHz)) return {};
    return "The scene is heavy for this machine: one tick in a hundred takes " +
           std::to_string(std::lround(slowTick(timing))) + " of the " + std::to_string(std::lround(1e6 / rateHz)) +
           " us that there are; take fewer triangles ('tactooth simplify'), a bur of fewer triangles or a lower rate, "
           "and close other programs.";
}

}  // namespace tactooth
