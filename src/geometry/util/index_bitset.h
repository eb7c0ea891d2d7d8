// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {

/// A set of numbers below a bound, added in any order and read in ascending order. For some thousand numbers among some
/// hundred thousand, reading all bits takes less time than sorting.
class IndexBitset {
public:
    /// The numbers are 0 .. `bound` - 1.
    explicit IndexBitset(std::size_t bound) : words_((bound + 63) / 64) {}

    void add(std::uint32_t number) {
        TACTOOTH_ASSERT(number / 64 < words_.size());
        words_[number / 64] |= std::uint64_t{1} << number % 64;
    }

    /// All numbers in ascending order.
    [[nodiscard]] std::vector<std::uint32_t> sorted() const {
        std::vector<std::uint32_t> numbers;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            for (std::uint64_t left = words_[i]; left != 0; left &= left - 1)
                numbers.push_back(static_cast<std::uint32_t>(64 * i) +
                                  static_cast<std::uint32_t>(std::countr_zero(left)));
        }
        return numbers;
    }

private:
    friend class BitsetRank;
    std::vector<std::uint64_t> words_;
};

/// The position of a number of the set in `IndexBitset::sorted`.
class BitsetRank {
public:
    /// `set` lives longer than this object and does not change.
    explicit BitsetRank(const IndexBitset& set) : words_(set.words_), before_(words_.size()) {
        for (std::size_t i = 0; i + 1 < words_.size(); ++i)
            before_[i + 1] = before_[i] + static_cast<std::uint32_t>(std::popcount(words_[i]));
    }
    [[nodiscard]] std::uint32_t operator[](std::uint32_t number) const {
        TACTOOTH_ASSERT(number / 64 < words_.size());
        TACTOOTH_ASSERT((words_[number / 64] >> number % 64 & 1) != 0);
        const std::uint64_t lower = words_[number / 64] & ((std::uint64_t{1} << number % 64) - 1);
        return before_[number / 64] + static_cast<std::uint32_t>(std::popcount(lower));
    }

private:
    const std::vector<std::uint64_t>& words_;
    std::vector<std::uint32_t> before_;  // count of the numbers in the words before each
};

}  // namespace tactooth
