// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace tactooth {

/// Allocates ranges of the numbers 0 .. capacity - 1 and frees them, for a buffer that many small objects share.
class RangeAllocator {
public:
    explicit RangeAllocator(std::uint32_t capacity) { grow(capacity); }

    /// The first of `count` > 0 consecutive free numbers, or nothing if there are none.
    [[nodiscard]] std::optional<std::uint32_t> allocate(std::uint32_t count);
    /// Frees a range that `allocate` returned.
    void release(std::uint32_t first, std::uint32_t count);
    void grow(std::uint32_t capacity);
    [[nodiscard]] std::uint32_t capacity() const { return capacity_; }

private:
    std::map<std::uint32_t, std::uint32_t> free_;  ///< first -> count; no two ranges are adjacent
    std::uint32_t capacity_ = 0;
};

}  // namespace tactooth
