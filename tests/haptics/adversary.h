// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "geometry/util/vec.h"

namespace tactooth::test {

/// Numbers that break arithmetic, mixed with ordinary ones; the same seed gives the same numbers.
class Adversary {
public:
    explicit Adversary(std::uint64_t seed) : random_(seed) {}

    [[nodiscard]] bool oneIn(unsigned n) { return random_() % n == 0; }
    /// Uniform in -1..1.
    [[nodiscard]] double part() { return part_(random_); }
    /// One in twelve is infinite, NaN or similar; another one has any size; the others are below 5.
    [[nodiscard]] double number() {
        switch (random_() % 12) {
            case 0:
                return kOdd[random_() % std::size(kOdd)];
            case 1:
                return std::ldexp(part(), static_cast<int>(random_() % 2100) - 1074);
            default:
                return 5 * part();
        }
    }
    [[nodiscard]] Vec3 vector() { return {number(), number(), number()}; }
    /// A time between two ticks that a clock should never give, or just may give, s.
    [[nodiscard]] double oddTime() { return kOddTimes[random_() % std::size(kOddTimes)]; }

private:
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    static constexpr double kOdd[] = {kInfinity,
                                      -kInfinity,
                                      std::numeric_limits<double>::quiet_NaN(),
                                      std::numeric_limits<double>::max(),
                                      std::numeric_limits<double>::lowest(),
                                      std::numeric_limits<double>::denorm_min(),
                                      -0.0,
                                      0.0};
    static constexpr double kOddTimes[] = {0.0, -0.001, 1e-300, 0.003, 0.02, 3600, kInfinity};

    std::mt19937_64 random_;
    std::uniform_real_distribution<double> part_{-1, 1};
};

}  // namespace tactooth::test
