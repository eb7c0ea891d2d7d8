// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/triangle_boxes.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "geometry/vec.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

Eigen::AlignedBox3f boxOf(const std::array<Vec3f, 3>& corners) {
    Eigen::AlignedBox3f box(corners[0]);
    return box.extend(corners[1]).extend(corners[2]);
}

TEST(TriangleBoxes, FindsInOrderWhatLookingAtEachOneFinds) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 1, 24, 12);
    std::vector<std::uint32_t> some;
    for (std::uint32_t t = 0; t < ball.triangles.size(); ++t) {
        if (t % 3 != 1) some.push_back(t);
    }
    some.pop_back();
    ASSERT_NE(some.size() % 8, 0U);
    const TriangleBoxes boxes(ball, some);
    EXPECT_EQ(boxes.triangles(), some);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-1.2F, 1.2F);
    std::uniform_real_distribution<float> size(-0.15F, 0.15F);
    int hits = 0;
    constexpr int kCases = 1000;
    for (int i = 0; i < kCases; ++i) {
        std::array<Vec3f, 3> corners;
        corners[0] = Vec3f(place(random), place(random), place(random));
        for (int c = 1; c < 3; ++c) corners[c] = corners[0] + Vec3f(size(random), size(random), size(random));
        std::vector<std::uint32_t> expected;
        for (const std::uint32_t t : some) {
            const auto& [a, b, c] = ball.triangles[t];
            const auto box = boxOf({ball.vertices[a], ball.vertices[b], ball.vertices[c]});
            if (box.intersects(boxOf(corners))) expected.push_back(t);
        }
        std::vector<std::uint32_t> found;
        boxes.forTouching(corners, [&](std::uint32_t t) { found.push_back(t); });
        ASSERT_EQ(found, expected);
        hits += found.empty() ? 0 : 1;
    }
    EXPECT_GT(hits, 0.2 * kCases);
    EXPECT_LT(hits, 0.8 * kCases);
}

TEST(TriangleBoxes, ATriangleThatOnlyTouchesCounts) {
    const TriangleMesh block = test::box(Vec3(0, 0, 0), Vec3(1, 1, 1));
    std::vector<std::uint32_t> all(block.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    const TriangleBoxes boxes(block, all);
    int found = 0;
    boxes.forTouching({Vec3f(1, 1, 1), Vec3f(2, 1, 1), Vec3f(1, 2, 2)}, [&](std::uint32_t) { ++found; });
    EXPECT_GT(found, 0);
    found = 0;
    boxes.forTouching({Vec3f(1.01F, 1, 1), Vec3f(2, 1, 1), Vec3f(1.01F, 2, 2)}, [&](std::uint32_t) { ++found; });
    EXPECT_EQ(found, 0);
}

TEST(TriangleBoxes, WhatIsForgottenIsFoundNoMoreAndTheRestStaysInOrder) {
    const TriangleMesh ball = test::sphere(Vec3::Zero(), 1, 24, 12);
    std::vector<std::uint32_t> all(ball.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    TriangleBoxes boxes(ball, all);
    std::vector<std::uint32_t> kept;
    TriangleBoxes added;
    boxes.forgetIf([&](std::uint32_t t, const Vec3f& low, const Vec3f& high) {
        const auto& [a, b, c] = ball.triangles[t];
        const auto box = boxOf({ball.vertices[a], ball.vertices[b], ball.vertices[c]});
        EXPECT_EQ(low, box.min());
        EXPECT_EQ(high, box.max());
        if (t % 5 == 0) return true;
        kept.push_back(t);
        added.add(t, low, high);
        return false;
    });
    ASSERT_NE(kept.size() % 8, 0U);
    for (const TriangleBoxes* left : {&boxes, &added}) {
        EXPECT_EQ(left->triangles(), kept);
        std::vector<std::uint32_t> found;
        left->forTouching({Vec3f(-2, -2, -2), Vec3f(2, 2, 2), Vec3f(-2, 2, 2)},
                          [&](std::uint32_t t) { found.push_back(t); });
        EXPECT_EQ(found, kept);
    }
}

TEST(TriangleBoxes, OfNoTrianglesNoneIsFound) {
    EXPECT_TRUE(TriangleBoxes().empty());
    TriangleBoxes().forTouching({Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}, [](std::uint32_t) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace tactooth
