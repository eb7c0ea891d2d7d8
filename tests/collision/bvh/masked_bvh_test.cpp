// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/masked_bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

using Box3f = Eigen::AlignedBox3f;

/// Collects the triangles below `link`, and checks that every box there is tight.
Box3f collect(const AabbTree& tree, AabbTree::Link link, std::vector<std::uint32_t>& triangles) {
    Box3f whole;
    if (link.isLeaf()) {
        const AabbTree::Leaf& leaf = tree.leaf(link);
        EXPECT_GT(leaf.count, 0U);
        for (std::uint32_t lane = 0; lane < AabbTree::kWidth; ++lane) {
            if (lane < leaf.count) triangles.push_back(leaf.triangle[lane]);
            EXPECT_TRUE(lane < leaf.count || leaf.triangle[lane] == leaf.triangle[0]);
            for (const auto& corner : leaf.corner)
                whole.extend(Vec3f(corner[0][lane], corner[1][lane], corner[2][lane]));
        }
        return whole;
    }
    const AabbTree::Node& node = tree.node(link);
    bool ended = false;
    for (int i = 0; i < AabbTree::kWidth; ++i) {
        const Vec3f low(node.low[0][i], node.low[1][i], node.low[2][i]);
        const Vec3f high(node.high[0][i], node.high[1][i], node.high[2][i]);
        if (low.x() > high.x()) {
            ended = true;
            continue;
        }
        EXPECT_FALSE(ended) << "a traversal does not see a child behind an absent one";
        const Box3f below = collect(tree, node.child[i], triangles);
        EXPECT_EQ(below.min(), low);
        EXPECT_EQ(below.max(), high);
        whole.extend(below);
    }
    return whole;
}

std::vector<std::uint32_t> trianglesOf(const AabbTree& tree) {
    std::vector<std::uint32_t> triangles;
    if (tree.empty()) return triangles;
    const Box3f box = collect(tree, tree.rootLink(), triangles);
    EXPECT_EQ(box.min().cast<double>(), tree.box().min());
    EXPECT_EQ(box.max().cast<double>(), tree.box().max());
    std::ranges::sort(triangles);
    return triangles;
}

TEST(MaskedBvh, HidesAndShowsTriangles) {
    const AabbTree whole(test::sphere(Vec3(1, 2, 3), 5, 80, 60));
    std::vector<bool> hidden(trianglesOf(whole).size());
    MaskedBvh masked(whole);
    std::mt19937 random(20261121);
    for (int round = 0; round < 30; ++round) {
        const bool hide = round % 3 != 2;
        const std::uint32_t first = static_cast<std::uint32_t>(random() % hidden.size());
        const std::uint32_t last = std::min<std::uint32_t>(first + random() % 2000, hidden.size());
        for (std::uint32_t t = first; t < last; ++t) {
            if (random() % 8 == 0) continue;
            hidden[t] = hide;
            masked.setHidden(t, hide);
            masked.setHidden(t, hide);  // twice has the same effect as once
        }
        std::vector<std::uint32_t> expected;
        for (std::uint32_t t = 0; t < hidden.size(); ++t)
            if (!hidden[t]) expected.push_back(t);
        ASSERT_EQ(trianglesOf(masked.maskedTree()), expected);
        masked.validate();
        masked.maskedTree().validate();
    }
}

TEST(MaskedBvh, ReplacesNoMoreThanThePathToTheHiddenTriangle) {
    const AabbTree whole(test::sphere(Vec3(1, 2, 3), 5, 300, 150));
    MaskedBvh masked(whole);
    EXPECT_EQ(masked.maskedTree().bytes(), whole.bytes());
    masked.setHidden(4711, true);
    const std::size_t most = AabbTree::kMaxDepth * sizeof(AabbTree::Node) + sizeof(AabbTree::Leaf);
    EXPECT_GT(masked.maskedTree().bytes(), whole.bytes());
    EXPECT_LE(masked.maskedTree().bytes(), whole.bytes() + most);
    masked.setHidden(4711, false);
    EXPECT_EQ(masked.maskedTree().bytes(), whole.bytes());
}

TEST(MaskedBvh, OfAllTrianglesLeavesAnEmptyTree) {
    const TriangleMesh box = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    MaskedBvh masked{AabbTree(box)};
    for (std::uint32_t t = 0; t < box.triangles.size(); ++t) {
        EXPECT_FALSE(masked.maskedTree().empty());
        masked.setHidden(t, true);
    }
    EXPECT_TRUE(masked.maskedTree().empty());
    masked.setHidden(3, false);
    EXPECT_EQ(trianglesOf(masked.maskedTree()), std::vector<std::uint32_t>{3});
}

TEST(MaskedBvh, ShowsAllAgain) {
    const AabbTree whole(test::sphere(Vec3(1, 2, 3), 5, 20, 10));
    MaskedBvh masked(whole);
    for (const std::uint32_t t : {3U, 4U, 100U}) masked.setHidden(t, true);
    masked.showAll();
    EXPECT_EQ(masked.maskedTree().bytes(), whole.bytes());
    masked.setHidden(3, true);
    EXPECT_EQ(trianglesOf(masked.maskedTree()).size(), trianglesOf(whole).size() - 1);
}

TEST(MaskedBvh, OutlivesTheTreeItWasBuiltFrom) {
    std::optional<AabbTree> whole(test::sphere(Vec3(1, 2, 3), 5, 20, 10));
    MaskedBvh masked(*whole);
    masked.setHidden(7, true);
    const AabbTree maskedTree = masked.maskedTree();
    const std::size_t before = trianglesOf(*whole).size();
    whole.reset();
    EXPECT_EQ(trianglesOf(maskedTree).size(), before - 1);
}

TEST(MaskedBvh, AssertsThatTheTriangleExistsAndTheTreeIsWhole) {
    const AabbTree whole(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
    MaskedBvh masked(whole);
    EXPECT_ASSERT(masked.setHidden(12, true));
    masked.setHidden(0, true);
    EXPECT_ASSERT(MaskedBvh(masked.maskedTree()));
}

}  // namespace
}  // namespace tactooth
