// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/box_query.h"

#include <gtest/gtest.h>

#include <random>

#include "support/expect_assert.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(BoxQuery, FindsWhatATestOfEveryTriangleFinds) {
    const SurfacePart part(test::sphere(Vec3(1, 2, 3), 2, 64, 48));
    std::mt19937 random(50);
    std::uniform_real_distribution<double> place(-2, 6);
    std::uniform_real_distribution<double> size(0, 1.5);
    std::size_t all = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 low(place(random), place(random), place(random));
        const Box3 box(low, low + Vec3(size(random), size(random), size(random)));
        std::vector<std::uint32_t> expected;
        for (std::uint32_t t = 0; t < part.mesh().triangles.size(); ++t) {
            Box3 triangle(part.mesh().corner(t, 0));
            triangle.extend(part.mesh().corner(t, 1)).extend(part.mesh().corner(t, 2));
            if (triangle.intersects(box)) expected.push_back(t);
        }
        EXPECT_EQ(trianglesTouching(part, box), expected);
        all += expected.size();
    }
    EXPECT_GT(all, 1000U);
}

TEST(BoxQueryAsserts, ABoxHoldsAPoint) {
    const SurfacePart part(test::sphere(Vec3::Zero(), 1, 16, 8));
    EXPECT_ASSERT(static_cast<void>(trianglesTouching(part, Box3())));
}

}  // namespace
}  // namespace tactooth
