// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/agreement/failure_detection.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {

std::optional<Share> shareOf(std::size_t part, std::size_t all) {
    TACTOOTH_ASSERT(part <= all);
    if (all == 0) return std::nullopt;
    const auto n = static_cast<double>(all);
    const double share = static_cast<double>(part) / n, z2 = kNormalQuantile * kNormalQuantile;
    const double scale = 1 + z2 / n, middle = (share + z2 / (2 * n)) / scale;
    const double half = kNormalQuantile * std::sqrt(share * (1 - share) / n + z2 / (4 * n * n)) / scale;
    // Exact at the ends, where rounding would leave 1e-17.
    const Interval interval{part == 0 ? 0 : middle - half, part == all ? 1 : middle + half};
    return Share{part, all, share, interval};
}

FailureDetection failureDetection(std::span<const Outcome> outcomes) {
    FailureDetection found;
    for (const Outcome& each : outcomes) {
        if (each.teachersFail) {
            ++(each.programFails ? found.caught : found.missed);
        } else {
            ++(each.programFails ? found.wronglyFailed : found.bothPass);
        }
    }
    found.sensitivity = shareOf(found.caught, found.caught + found.missed);
    found.specificity = shareOf(found.bothPass, found.bothPass + found.wronglyFailed);
    return found;
}

std::optional<double> areaUnderCurve(std::span<const double> upper, std::span<const double> lower) {
    if (upper.empty() || lower.empty()) return std::nullopt;
    std::vector<double> sorted(lower.begin(), lower.end());
    std::ranges::sort(sorted);
    std::size_t halves = 0;  // of won pairs, a whole number
    for (const double each : upper) {
        const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), each);
        halves += static_cast<std::size_t>((first - sorted.begin()) + (last - sorted.begin()));
    }
    return static_cast<double>(halves) / (2 * static_cast<double>(upper.size()) * static_cast<double>(lower.size()));
}

}  // namespace tactooth
