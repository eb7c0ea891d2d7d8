// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/draw_order.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

using Order = std::vector<std::size_t>;

Box3 cube(const Vec3& middle, double half) { return {middle - Vec3::Constant(half), middle + Vec3::Constant(half)}; }

TEST(DrawOrder, NearBodiesComeFirst) {
    const std::vector<PlacedBox> row = {{cube({30, 0, 0}, 1)}, {cube({10, 0, 0}, 1)}, {cube({20, 0, 0}, 1)}};
    EXPECT_EQ(nearestFirst(row, Vec3::Zero()), (Order{1, 2, 0}));
    EXPECT_EQ(nearestFirst(row, Vec3(40, 0, 0)), (Order{0, 2, 1}));
}

TEST(DrawOrder, WhatStandsAroundABodyComesAfterIt) {
    const std::vector<PlacedBox> tooth = {{cube({0, 0, 0}, 40)}, {cube({5, 0, 0}, 4)}};
    for (const Vec3& eye : {Vec3(100, 0, 0), Vec3(-100, 0, 0), Vec3(0, 60, 80)}) {
        EXPECT_EQ(nearestFirst(tooth, eye), (Order{1, 0})) << eye.transpose();
    }
}

TEST(DrawOrder, TheBodyIsWhereItsPosePutsIt) {
    Mat4 far = Mat4::Identity();
    far.topRightCorner<3, 1>() = Vec3(100, 0, 0);
    const std::vector<PlacedBox> bodies = {{cube({0, 0, 0}, 1), far}, {cube({50, 0, 0}, 1)}};
    EXPECT_EQ(nearestFirst(bodies, Vec3::Zero()), (Order{1, 0}));
}

TEST(DrawOrder, EqualBodiesKeepTheirOrder) {
    const std::vector<PlacedBox> bodies(3, {cube({10, 0, 0}, 1)});
    EXPECT_EQ(nearestFirst(bodies, Vec3::Zero()), (Order{0, 1, 2}));
    EXPECT_TRUE(nearestFirst({}, Vec3::Zero()).empty());
}

}  // namespace
}  // namespace tactooth
