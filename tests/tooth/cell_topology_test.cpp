// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/cell_topology.h"

#include <gtest/gtest.h>

#include <set>

namespace tactooth {
namespace {

TEST(CellTopology, ExactlyTheEdgesWithOneInsideEndBelongToARound) {
    for (int inside = 0; inside < 256; ++inside) {
        std::set<int> rounds;
        for (int edge = 0; edge < 12; ++edge) {
            const auto [a, b] = cellEdgeCorners(edge);
            const bool crossed = ((inside >> a) & 1) != ((inside >> b) & 1);
            EXPECT_EQ(kCellRounds[inside].roundOfEdge[edge] >= 0, crossed);
            if (crossed) rounds.insert(kCellRounds[inside].roundOfEdge[edge]);
        }
        EXPECT_EQ(static_cast<int>(rounds.size()), kCellRounds[inside].count);
    }
}

TEST(CellTopology, ARoundHasAtLeastThreeEdges) {
    for (const CellRounds& rounds : kCellRounds) {
        for (int round = 0; round < rounds.count; ++round) {
            EXPECT_GE(std::count(rounds.roundOfEdge.begin(), rounds.roundOfEdge.end(), round), 3);
        }
    }
}

TEST(CellTopology, OneInsideCornerIsOneRound) { EXPECT_EQ(kCellRounds[1].count, 1); }

TEST(CellTopology, InsideCornersAreJoinedAcrossAFaceAndApartAcrossTheCell) {
    EXPECT_EQ(kCellRounds[0b00001001].count, 1);
    EXPECT_EQ(kCellRounds[0b10000001].count, 2);
}

TEST(CellTopology, OutsideCornersAreKeptApart) {
    EXPECT_EQ(kCellRounds[0b11110110].count, 2);  // across a face
    EXPECT_EQ(kCellRounds[0b01101001].count, 4);  // on a tetrahedron
}

}  // namespace
}  // namespace tactooth
