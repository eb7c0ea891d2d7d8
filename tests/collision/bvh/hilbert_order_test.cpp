// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/hilbert_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tactooth {
namespace {

/// Small triangles around points, numbered in the order of the points, with scratch memory.
struct Items {
    explicit Items(const std::vector<Vec3f>& points) : bins(points.size()) {
        for (const Vec3f& p : points) {
            const auto number = static_cast<std::uint32_t>(items.size());
            items.emplace_back(number, p - Vec3f::Constant(0.1F), p, p + Vec3f::Constant(0.1F));
        }
    }
    [[nodiscard]] std::vector<std::uint32_t> sorted() {
        sortByHilbertIndex({items, bins});
        std::vector<std::uint32_t> numbers;
        for (const TreeItem& item : items) numbers.push_back(item.triangle());
        return numbers;
    }
    std::vector<TreeItem> items;
    std::vector<std::uint8_t> bins;
};

TEST(HilbertOrder, VisitsTheNeighbouringCellsOfAGridInTurn) {
    std::vector<Vec3f> points;
    for (int cell = 0; cell < 512; ++cell)
        points.emplace_back(static_cast<float>(cell % 8), static_cast<float>(cell / 8 % 8),
                            static_cast<float>(cell / 64));
    std::shuffle(points.begin(), points.end(), std::mt19937(3));
    const std::vector<std::uint32_t> order = Items(points).sorted();
    ASSERT_EQ(order.size(), points.size());
    std::vector<bool> isSeen(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        EXPECT_FALSE(isSeen[order[i]]);
        isSeen[order[i]] = true;
        if (i == 0) continue;
        EXPECT_EQ((points[order[i]] - points[order[i - 1]]).norm(), 1) << i;
    }
}

TEST(HilbertOrder, KeepsTheOrderOfItemsInOneCell) {
    EXPECT_EQ(Items(std::vector<Vec3f>(5, Vec3f(1, 2, 3))).sorted(), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
    EXPECT_TRUE(Items({}).sorted().empty());
    const Vec3f near(0, 0, 0), far(8, 0, 0);
    EXPECT_EQ(Items({far, near, far, near}).sorted(), (std::vector<std::uint32_t>{1, 3, 0, 2}));
}

}  // namespace
}  // namespace tactooth
