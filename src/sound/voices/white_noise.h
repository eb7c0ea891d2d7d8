// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tactooth {

/// Repeatable white noise, uniform in [-1, 1). Generator: Melissa O'Neill, "PCG: A Family of Simple Fast
/// Space-Efficient Statistically Good Algorithms for Random Number Generation", 2014 (the 32-bit XSH-RR member).
class WhiteNoise {
public:
    explicit WhiteNoise(std::uint64_t seed) : state_(seed * kMultiplier + kIncrement) { bits(); }

    float next() { return static_cast<float>(static_cast<std::int32_t>(bits())) * 0x1p-31f; }

    /// Uniform in [0, 1).
    float nextPositive() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }

private:
    static constexpr std::uint64_t kMultiplier = 6364136223846793005u;
    static constexpr std::uint64_t kIncrement = 1442695040888963407u;

    std::uint32_t bits() {
        const std::uint64_t old = state_;
        state_ = old * kMultiplier + kIncrement;
        const auto mixed = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        const auto turn = static_cast<std::uint32_t>(old >> 59);
        return (mixed >> turn) | (mixed << ((32 - turn) & 31));
    }

    std::uint64_t state_;
};

}  // namespace tactooth
