// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/cell_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

TEST(CellTopology, ExactlyTheEdgesWithOneInsideEndBelongToALoop) {
    for (int inside = 0; inside < 256; ++inside) {
        std::set<int> rounds;
        for (int edge = 0; edge < 12; ++edge) {
            const auto [a, b] = cellEdgeCorners(edge);
            const bool crossed = ((inside >> a) & 1) != ((inside >> b) & 1);
            EXPECT_EQ(kCellLoops[inside].loopOfEdge[edge] >= 0, crossed);
            if (crossed) rounds.insert(kCellLoops[inside].loopOfEdge[edge]);
        }
        EXPECT_EQ(static_cast<int>(rounds.size()), kCellLoops[inside].count);
    }
}

TEST(CellTopology, ALoopHasAtLeastThreeEdges) {
    for (const CellLoops& rounds : kCellLoops) {
        for (int round = 0; round < rounds.count; ++round) {
            EXPECT_GE(std::count(rounds.loopOfEdge.begin(), rounds.loopOfEdge.end(), round), 3);
        }
    }
}

TEST(CellTopology, OneInsideCornerIsOneLoop) { EXPECT_EQ(kCellLoops[1].count, 1); }

TEST(CellTopology, InsideCornersAreJoinedAcrossAFaceAndApartAcrossTheCell) {
    EXPECT_EQ(kCellLoops[0b00001001].count, 1);
    EXPECT_EQ(kCellLoops[0b10000001].count, 2);
}

TEST(CellTopology, OutsideCornersAreKeptApart) {
    EXPECT_EQ(kCellLoops[0b11110110].count, 2);  // two loops across a face
    EXPECT_EQ(kCellLoops[0b01101001].count, 4);  // corners of a tetrahedron
}

TEST(CellTopology, CrossedEdgesComeInTheOrderOfTheLattice) {
    for (int inside = 0; inside < 256; ++inside) {
        const CellCrossings& crossings = kCellCrossings[inside];
        std::set<int> edges;
        std::array<int, 4> last{-1, 0, 0, 0};
        for (int i = 0; i < crossings.count; ++i) {
            const int edge = crossings.edges[i];
            edges.insert(edge);
            EXPECT_GE(kCellLoops[inside].loopOfEdge[edge], 0);
            const int corner = cellEdgeCorners(edge)[0];
            const std::array<int, 4> place = {corner >> 2, corner >> 1 & 1, edge / 4, corner & 1};
            EXPECT_LT(last, place);
            last = place;
        }
        const auto& rounds = kCellLoops[inside].loopOfEdge;
        EXPECT_EQ(static_cast<int>(edges.size()), 12 - std::count(rounds.begin(), rounds.end(), -1));
        for (int i = crossings.count; i < 12; ++i) EXPECT_EQ(crossings.edges[i], crossings.edges[0]);
    }
}

TEST(CellTopologyAsserts, ACellHasTwelveEdgesOnThreeAxes) {
    EXPECT_ASSERT(static_cast<void>(cellEdge(3, 0, 0)));
    EXPECT_ASSERT(static_cast<void>(cellEdge(0, 2, 0)));
    EXPECT_ASSERT(static_cast<void>(cellEdgeCorners(12)));
}

}  // namespace
}  // namespace tactooth
