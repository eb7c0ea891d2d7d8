// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/vertex_welder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace tactooth {
namespace {

TEST(VertexWelder, NumbersPositionsInOrderOfFirstAppearance) {
    VertexWelder welder(4);
    EXPECT_EQ(welder.add({1, 2, 3}), 0U);
    EXPECT_EQ(welder.add({3, 2, 1}), 1U);
    EXPECT_EQ(welder.add({1, 2, 3}), 0U);
    EXPECT_EQ(welder.takeVertices(), (std::vector<Vec3f>{{1, 2, 3}, {3, 2, 1}}));
}

TEST(VertexWelder, MinusZeroIsZeroAndTheFirstIsKept) {
    VertexWelder welder(4);
    EXPECT_EQ(welder.add({-0.0F, 1, 0}), 0U);
    EXPECT_EQ(welder.add({0, 1, -0.0F}), 0U);
    EXPECT_TRUE(std::signbit(welder.takeVertices()[0].x()));
}

TEST(VertexWelder, NeighbouringFloatsStayApart) {
    VertexWelder welder(4);
    EXPECT_NE(welder.add({1, 0, 0}), welder.add({std::nextafter(1.0F, 2.0F), 0, 0}));
}

TEST(VertexWelder, AgreesWithAnOrderedMapOnRandomPositions) {
    std::mt19937 random(20260101);
    std::map<std::array<float, 3>, std::uint32_t> oracle;
    VertexWelder welder(1);  // too small on purpose: the table has to grow several times
    std::size_t repeated = 0;
    for (int i = 0; i < 50000; ++i) {
        std::array<float, 3> position;
        for (float& coordinate : position) coordinate = static_cast<float>(static_cast<int>(random() % 41) - 20) / 8;
        const auto [entry, isNew] = oracle.try_emplace(position, static_cast<std::uint32_t>(oracle.size()));
        repeated += !isNew;
        ASSERT_EQ(welder.add({position[0], position[1], position[2]}), entry->second);
    }
    EXPECT_GT(repeated, 10000U);
    EXPECT_EQ(welder.takeVertices().size(), oracle.size());
}

TEST(VertexWelder, NumbersManyAtOnceAsOneByOne) {
    std::mt19937 random(20261121);
    std::vector<Vec3f> positions(10007);  // not a multiple of any block
    const auto coordinate = [&] { return static_cast<float>(static_cast<int>(random() % 31) - 15) / 4; };
    for (Vec3f& position : positions) position = {coordinate(), coordinate(), coordinate()};
    VertexWelder oneByOne(1), atOnce(1);
    std::vector<std::uint32_t> expected(positions.size()), numbers(positions.size());
    std::ranges::transform(positions, expected.begin(), [&](const Vec3f& p) { return oneByOne.add(p); });
    atOnce.addAll(positions, numbers.data());
    EXPECT_EQ(numbers, expected);
    EXPECT_EQ(atOnce.takeVertices(), oneByOne.takeVertices());
}

TEST(Weld, KeepsOrderAndCountOfTriangles) {
    const std::vector<Vec3f> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    const TriangleMesh mesh = weld(corners);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 1, 0}}));
    EXPECT_EQ(mesh.vertices.size(), 3U);
}

}  // namespace
}  // namespace tactooth
