// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/range_allocator.h"

#include <algorithm>

#include "geometry/util/assert.h"

namespace tactooth {

std::optional<std::uint32_t> RangeAllocator::allocate(std::uint32_t count) {
    TACTOOTH_ASSERT(count > 0);
    const auto range = std::find_if(free_.begin(), free_.end(), [&](const auto& free) { return free.second >= count; });
    if (range == free_.end()) return std::nullopt;
    const auto [first, available] = *range;
    free_.erase(range);
    if (available > count) free_.emplace(first + count, available - count);
    return first;
}

void RangeAllocator::release(std::uint32_t first, std::uint32_t count) {
    TACTOOTH_ASSERT(count > 0 && first + count <= capacity_);
    auto next = free_.lower_bound(first);
    TACTOOTH_ASSERT(next == free_.end() || next->first >= first + count);
    if (next != free_.end() && next->first == first + count) {
        count += next->second;
        next = free_.erase(next);
    }
    if (next != free_.begin()) {
        const auto before = std::prev(next);
        TACTOOTH_ASSERT(before->first + before->second <= first);
        if (before->first + before->second == first) {
            before->second += count;
            return;
        }
    }
    free_.emplace(first, count);
}

void RangeAllocator::grow(std::uint32_t capacity) {
    TACTOOTH_ASSERT(capacity >= capacity_);
    if (capacity == capacity_) return;
    const std::uint32_t old = capacity_;
    capacity_ = capacity;
    release(old, capacity - old);
}

}  // namespace tactooth
