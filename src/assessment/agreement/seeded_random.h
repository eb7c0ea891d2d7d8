// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/util/assert.h"

namespace tactooth {

/// Random numbers that are the same with every library and compiler: SplitMix64 (G. L. Steele, D. Lea, C. H. Flood,
/// "Fast splittable pseudorandom number generators", OOPSLA 2014). The distributions of the standard library differ.
class SeededRandom {
public:
    explicit SeededRandom(std::uint64_t seed) : state_(seed) {}

    [[nodiscard]] std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t bits = state_;
        bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9U;
        bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBU;
        return bits ^ (bits >> 31);
    }

    /// 0..limit-1, each as likely as the others. `limit` is not 0.
    [[nodiscard]] std::uint64_t below(std::uint64_t limit) {
        TACTOOTH_ASSERT(limit > 0);
        const std::uint64_t uneven =
            (0 - limit) % limit;  // 2^64 modulo limit: so many numbers would favour the small ones
        std::uint64_t bits = next();
        while (bits < uneven) bits = next();
        return bits % limit;
    }

    /// 0 (included) to 1 (excluded), in steps of 2^-53.
    [[nodiscard]] double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }

private:
    std::uint64_t state_;
};

}  // namespace tactooth
