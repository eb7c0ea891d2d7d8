// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace tactooth {

/// Hands out ranges of numbers 0 .. capacity - 1 and takes them back: the book-keeping of a buffer that many small
/// things share.
class RangeAllocator {
public:
    explicit RangeAllocator(std::uint32_t capacity) { grow(capacity); }

    /// The first of `count` > 0 free neighbouring numbers, or nothing if there are none.
    [[nodiscard]] std::optional<std::uint32_t> allocate(std::uint32_t count);
    /// Gives back a range that `allocate` returned.
    void release(std::uint32_t first, std::uint32_t count);
    void grow(std::uint32_t capacity);
    [[nodiscard]] std::uint32_t capacity() const { return capacity_; }

private:
    std::map<std::uint32_t, std::uint32_t> free_;  ///< first -> count; no two ranges touch
    std::uint32_t capacity_ = 0;
};

}  // namespace tactooth
