// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/util/index_bitset.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace tactooth {
namespace {

TEST(IndexBitset, ReturnsItsNumbersInAscendingOrderAndTheirPlaces) {
    std::mt19937 random(7);
    for (const std::size_t bound : {1U, 63U, 64U, 65U, 1000U, 100'000U}) {
        IndexBitset set(bound);
        std::set<std::uint32_t> expected = {0, static_cast<std::uint32_t>(bound - 1)};
        for (std::size_t i = 0; i < bound / 3; ++i) expected.insert(static_cast<std::uint32_t>(random() % bound));
        for (const std::uint32_t number : expected) {
            set.add(number);
            set.add(number);  // a second time has no effect
        }
        const std::vector<std::uint32_t> sorted = set.sorted();
        ASSERT_EQ(sorted, std::vector<std::uint32_t>(expected.begin(), expected.end())) << bound;
        const BitsetRank places(set);
        for (std::uint32_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(places[sorted[i]], i) << bound;
    }
}

TEST(IndexBitset, IsEmptyAtFirst) {
    EXPECT_TRUE(IndexBitset(1000).sorted().empty());
    EXPECT_TRUE(IndexBitset(0).sorted().empty());
}

}  // namespace
}  // namespace tactooth
