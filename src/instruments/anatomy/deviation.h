// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Random numbers that are the same with every standard library: the generator is portable, the distributions of the
// standard library are not.
#pragma once

#include <cstdint>
#include <random>

namespace tactooth {

/// A number between -range and range.
[[nodiscard]] inline double deviation(std::mt19937& random, double range) {
    constexpr double kHalf = 2147483648.0;  // half of the range of the generator
    return range * (static_cast<double>(random()) / kHalf - 1);
}

/// A number from low to high.
[[nodiscard]] inline double numberBetween(std::mt19937& random, double low, double high) {
    return (low + high) / 2 + deviation(random, (high - low) / 2);
}

/// The number of a tooth in its half of the mouth: equal for the right and the left side.
[[nodiscard]] constexpr std::uint32_t placeOfTooth(int fdi) {
    return static_cast<std::uint32_t>(10 * (fdi / 10 > 2) + fdi % 10);
}

/// The generator of the numbers by which the plan of a tooth varies. It shares none with the warp (variation.h).
[[nodiscard]] inline std::mt19937 planGenerator(std::uint32_t seed, int fdi) {
    constexpr std::uint32_t kPlan = 50;  // beyond the places of all teeth
    return std::mt19937(seed * 100 + kPlan + placeOfTooth(fdi));
}

}  // namespace tactooth
