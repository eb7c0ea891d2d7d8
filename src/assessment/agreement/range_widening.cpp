// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/range_widening.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

using Range = LevelRanges::Range;

/// The ends of the upper side, from the ideal range outwards, away from a fixed point.
std::array<double, 4> movedEnds(const std::array<double, 4>& ends, double middle, double factor) {
    const double fixed = std::max(middle, ends[0] - (ends[3] - ends[0]));
    std::array<double, 4> moved{};
    for (std::size_t i = 0; i < 4; ++i) moved[i] = fixed + factor * (ends[i] - fixed);
    return moved;
}

/// Whether the ranges are in order, and limit the same sides.
bool hasSameSides(const LevelRanges& changed, const LevelRanges& levels) {
    return LevelRanges::areNested(changed.ranges()) && changed.hasLowerLimit() == levels.hasLowerLimit() &&
           changed.hasUpperLimit() == levels.hasUpperLimit();
}

/// To 0.0001, which is finer than anything is measured.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

}  // namespace

LevelRanges widened(const LevelRanges& levels, double factor) {
    TACTOOTH_ASSERT(factor > 0);
    if (factor == 1) return levels;
    std::array<Range, 4> ranges = levels.ranges();
    const Range ideal = ranges[0];
    const bool isTwoSided = levels.hasLowerLimit() && levels.hasUpperLimit();
    const double middle = ideal.low + (ideal.high - ideal.low) / 2;
    if (levels.hasUpperLimit()) {
        std::array<double, 4> ends{};
        std::ranges::transform(levels.ranges(), ends.begin(), [](const Range& range) { return range.high; });
        const std::array<double, 4> moved = movedEnds(ends, isTwoSided ? middle : ideal.low, factor);
        for (std::size_t i = 0; i < 4; ++i) ranges[i].high = moved[i];
    }
    if (levels.hasLowerLimit()) {  // the same, mirrored
        std::array<double, 4> ends{};
        std::ranges::transform(levels.ranges(), ends.begin(), [](const Range& range) { return -range.low; });
        const std::array<double, 4> moved = movedEnds(ends, isTwoSided ? -middle : -ideal.high, factor);
        for (std::size_t i = 0; i < 4; ++i) ranges[i].low = -moved[i];
    }
    std::array<Range, 4> neat = ranges;
    for (std::size_t i = 0; i < 4; ++i) {
        if (levels.hasLowerLimit()) neat[i].low = rounded(ranges[i].low);
        if (levels.hasUpperLimit()) neat[i].high = rounded(ranges[i].high);
    }
    for (const LevelRanges& each : {LevelRanges(neat), LevelRanges(ranges)}) {
        if (hasSameSides(each, levels)) return each;
    }
    return levels;  // its ends lie closer together than a double can tell
}

}  // namespace tactooth
