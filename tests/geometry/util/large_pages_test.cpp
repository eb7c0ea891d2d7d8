// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/large_pages.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <numeric>

#include "support/sanitizer.h"

namespace tactooth {
namespace {

TEST(LargePages, HoldWhatAVectorHoldsAtAnySize) {
    for (const std::size_t count : {1U, 1000U, 1'100'000U, 3'000'000U}) {  // the last two on large pages
        LargeVector<std::uint32_t> numbers(count);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(numbers.data()) % 64, 0U);
        std::iota(numbers.begin(), numbers.end(), 1U);
        numbers.push_back(7);
        EXPECT_EQ(numbers[count / 2], count / 2 + 1);
        EXPECT_EQ(numbers[count - 1], count);
        EXPECT_EQ(numbers[count], 7U);
    }
}

TEST(LargePages, AreNotGivenBeyondTheMemory) {
    EXPECT_EQ(allocateOnLargePages(std::numeric_limits<std::size_t>::max()), nullptr);
    if (test::isSanitized()) return;  // the address sanitizer ends the program instead
    EXPECT_EQ(allocateOnLargePages(std::size_t{1} << 60), nullptr);
}

}  // namespace
}  // namespace tactooth
