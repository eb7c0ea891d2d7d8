// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tactooth {

/// Numbers below a bound, added in any order and as often as one likes, read in ascending order: of some thousand among
/// some hundred thousand, to look through a bit for each takes less than to sort them.
class IndexBitset {
public:
    /// The numbers are 0 .. `bound` - 1.
    explicit IndexBitset(std::size_t bound) : words_((bound + 63) / 64) {}

    void add(std::uint32_t number) { words_[number / 64] |= std::uint64_t{1} << number % 64; }

    /// In ascending order.
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

/// Tells where in `IndexBitset::sorted` a number of the set is.
class BitsetRank {
public:
    /// `set` is not changed as long as this is asked.
    explicit BitsetRank(const IndexBitset& set) : words_(set.words_), before_(words_.size()) {
        for (std::size_t i = 0; i + 1 < words_.size(); ++i)
            before_[i + 1] = before_[i] + static_cast<std::uint32_t>(std::popcount(words_[i]));
    }
    [[nodiscard]] std::uint32_t operator[](std::uint32_t number) const {
        const std::uint64_t lower = words_[number / 64] & ((std::uint64_t{1} << number % 64) - 1);
        return before_[number / 64] + static_cast<std::uint32_t>(std::popcount(lower));
    }

private:
    const std::vector<std::uint64_t>& words_;
    std::vector<std::uint32_t> before_;  // how many there are in the words before each
};

}  // namespace tactooth
