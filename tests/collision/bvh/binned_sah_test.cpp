// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/binned_sah.h"
#include "support/expect_assert.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace tactooth {
namespace {

/// Items with memory of their own.
struct Items {
    std::vector<TreeItem> items;
    std::vector<std::uint8_t> bins;

    void add(const Vec3f& low, const Vec3f& size) {
        items.emplace_back(static_cast<std::uint32_t>(items.size()), low, low, low + size);
        bins.push_back(0);
    }
    TreeRange range() { return {items, bins}; }
};

/// Small boxes spread over a long one along z.
Items scattered(std::size_t count) {
    std::mt19937 random(20261121);
    const auto share = [&] { return static_cast<float>(random()) / 4294967296.0F; };
    Items result;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3f low(share(), 2 * share(), 5 * share());
        result.add(low, 0.1F * Vec3f(share(), share(), share()));
    }
    return result;
}

void expectSameBox(const TreeBounds& a, const TreeBounds& b) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(a.box().low[axis], b.box().low[axis]);
        EXPECT_EQ(a.box().high[axis], b.box().high[axis]);
    }
}

TEST(BinnedSplit, SeparatesByTheCentreAlongTheLongestAxisAndLosesNothing) {
    for (const std::size_t count : {9U, 100U, 5000U, 8192U, 8193U, 40000U}) {  // from 8193 on in parallel
        Items items = scattered(count);
        const TreeSplit split = splitRange(items.range(), false);
        ASSERT_GT(split.leftCount, 0U);
        ASSERT_LT(split.leftCount, count);
        const TreeRange left = items.range().first(split.leftCount);
        const TreeRange right = items.range().after(split.leftCount);
        expectSameBox(split.left, boundsOf(left));
        expectSameBox(split.right, boundsOf(right));
        const auto alongZ = [](const TreeItem& item) { return item.centre(2); };
        EXPECT_LT(std::ranges::max(left.items, {}, alongZ).centre(2),
                  std::ranges::min(right.items, {}, alongZ).centre(2));
        std::vector<std::uint32_t> numbers(count);
        std::ranges::transform(items.items, numbers.begin(), &TreeItem::triangle);
        std::ranges::sort(numbers);
        std::vector<std::uint32_t> all(count);
        std::iota(all.begin(), all.end(), 0U);
        EXPECT_EQ(numbers, all);
    }
}

TEST(BinnedSplit, TakesTheBorderBetweenTwoClusters) {
    Items items;
    for (int i = 0; i < 24; ++i) items.add({0.01F * static_cast<float>(i), 0, 0}, {0.1F, 0.1F, 0.1F});
    for (int i = 0; i < 8; ++i) items.add({9 + 0.01F * static_cast<float>(i), 0, 0}, {0.1F, 0.1F, 0.1F});
    EXPECT_EQ(splitRange(items.range(), false).leftCount, 24U);
}

TEST(BinnedSplit, BalancedSplitsAtTheMiddlePacket) {
    Items items = scattered(80);
    EXPECT_EQ(splitRange(items.range(), true).leftCount, 40U);
}

TEST(BinnedSplit, SplitsItemsInOnePlaceByNumber) {
    Items items;
    for (int i = 0; i < 20; ++i) items.add({1, 2, 3}, {1, 1, 1});
    const TreeSplit split = splitRange(items.range(), false);
    EXPECT_EQ(split.leftCount, 8U);
    for (std::uint32_t i = 0; i < 20; ++i) EXPECT_EQ(items.items[i].triangle(), i);
}

TEST(BinnedSplit, AssertsThatTheRangeIsLargerThanALeaf) {
    Items items = scattered(8);
    EXPECT_ASSERT((void)splitRange(items.range(), false));
    EXPECT_ASSERT((void)items.range().first(9));
}

}  // namespace
}  // namespace tactooth
