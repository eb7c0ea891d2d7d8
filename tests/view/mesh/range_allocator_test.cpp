// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/mesh/range_allocator.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace tactooth {
namespace {

TEST(RangeAllocator, HandsOutFromTheFrontUntilFull) {
    RangeAllocator allocator(10);
    EXPECT_EQ(allocator.allocate(4), 0U);
    EXPECT_EQ(allocator.allocate(6), 4U);
    EXPECT_FALSE(allocator.allocate(1));
}

TEST(RangeAllocator, JoinsNeighboursThatAreGivenBack) {
    RangeAllocator allocator(9);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(allocator.allocate(3));
    allocator.release(0, 3);
    allocator.release(6, 3);
    EXPECT_FALSE(allocator.allocate(9));
    allocator.release(3, 3);
    EXPECT_EQ(allocator.allocate(9), 0U);
}

TEST(RangeAllocator, GrowthJoinsTheFreeEnd) {
    RangeAllocator allocator(4);
    ASSERT_EQ(allocator.allocate(2), 0U);
    allocator.grow(8);
    EXPECT_EQ(allocator.allocate(6), 2U);
    EXPECT_EQ(allocator.capacity(), 8U);
}

TEST(RangeAllocator, NeverHandsOutANumberTwice) {
    std::mt19937 random(3);
    RangeAllocator allocator(300);
    std::vector<bool> taken(300);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> held;
    for (int step = 0; step < 5000; ++step) {
        if (held.empty() || random() % 2 == 0) {
            const std::uint32_t count = 1 + random() % 20;
            const auto first = allocator.allocate(count);
            if (!first) continue;
            for (std::uint32_t i = 0; i < count; ++i) {
                ASSERT_FALSE(taken[*first + i]);
                taken[*first + i] = true;
            }
            held.emplace_back(*first, count);
        } else {
            const std::size_t which = random() % held.size();
            const auto [first, count] = held[which];
            allocator.release(first, count);
            for (std::uint32_t i = 0; i < count; ++i) taken[first + i] = false;
            held.erase(held.begin() + static_cast<std::ptrdiff_t>(which));
        }
    }
    for (const auto& [first, count] : held) allocator.release(first, count);
    EXPECT_EQ(allocator.allocate(300), 0U);
}

}  // namespace
}  // namespace tactooth
