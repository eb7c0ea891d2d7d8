// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/node_set.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "support/expect_assert.h"

namespace tactooth {
namespace {

using Node = std::array<int, 3>;  // of the whole lattice

/// Nodes of several bricks, one by one: the reference for the sets.
std::set<Node> nodesOf(const NodeSets& sets) {
    std::set<Node> nodes;
    for (const auto& [key, set] : sets) {
        for (int node = 0; node < kBrickNodes; ++node) {
            const auto [x, y, z] = placeOf(node);
            if (set[static_cast<std::size_t>(node)])
                nodes.insert({kBrickSide * key.x + x, kBrickSide * key.y + y, kBrickSide * key.z + z});
        }
    }
    return nodes;
}

NodeSets randomNodes(std::mt19937& random, int count) {
    NodeSets sets;
    for (int i = 0; i < 27; ++i) sets[{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1}];
    for (int i = 0; i < count; ++i) {
        auto brick = sets.begin();
        std::advance(brick, random() % sets.size());
        brick->second.set(random() % kBrickNodes);
    }
    return sets;
}

TEST(NodeSet, AFaceAndWhatIsAcrossItMeetNodeByNode) {
    for (const BrickFace& face : kBrickFaces) {
        EXPECT_EQ(face.nodes().count(), 64U);
        EXPECT_EQ(face.across(face.nodes()), face.opposite().nodes());
        for (int node = 0; node < kBrickNodes; ++node) {
            if (!face.nodes()[static_cast<std::size_t>(node)]) continue;
            NodeSets here, beyond;
            here[{0, 0, 0}].set(static_cast<std::size_t>(node));
            beyond[face.beyond({0, 0, 0})] = face.across(here[{0, 0, 0}]);
            Node expected = *nodesOf(here).begin();
            expected[static_cast<std::size_t>(face.axis)] += face.isUpper ? 1 : -1;
            EXPECT_EQ(nodesOf(beyond), std::set<Node>{expected});
        }
    }
}

TEST(NodeSet, DilationAddsAllNeighboursAcrossBricks) {
    std::mt19937 random(5);
    for (const int count : {1, 30, 1500}) {
        const NodeSets sets = randomNodes(random, count);
        std::set<Node> expected;
        for (const Node& node : nodesOf(sets)) {
            for (int i = 0; i < 27; ++i)
                expected.insert({node[0] + i % 3 - 1, node[1] + i / 3 % 3 - 1, node[2] + i / 9 - 1});
        }
        std::erase_if(expected, [](const Node& node) {  // in bricks that the sets do not contain
            return std::ranges::any_of(node, [](int place) { return place < -8 || place > 15; });
        });
        EXPECT_EQ(nodesOf(dilated(sets)), expected);
    }
}

TEST(NodeSet, AComponentIsConnectedAlongTheAxes) {
    std::mt19937 random(6);
    int apart = 0;
    for (const int count : {20, 120, 180, 250, 400}) {
        NodeSet all;
        for (int i = 0; i < count; ++i) all.set(random() % kBrickNodes);
        const auto isIn = [&](const Node& at) {
            return std::ranges::all_of(at, [](int place) { return place >= 0 && place < kBrickSide; }) &&
                   all[static_cast<std::size_t>(nodeIndex(at[0], at[1], at[2]))];
        };
        int first = 0;
        while (!all[static_cast<std::size_t>(first)]) ++first;
        std::set<Node> reached = {placeOf(first)};
        for (std::vector<Node> todo(reached.begin(), reached.end()); !todo.empty();) {
            const Node from = todo.back();
            todo.pop_back();
            for (const BrickFace& face : kBrickFaces) {
                Node next = from;
                next[static_cast<std::size_t>(face.axis)] += face.isUpper ? 1 : -1;
                if (isIn(next) && reached.insert(next).second) todo.push_back(next);
            }
        }
        EXPECT_EQ(nodesOf({{{0, 0, 0}, firstComponent(all)}}), reached);
        apart += reached.size() < all.count();
    }
    EXPECT_GE(apart, 3);
}

TEST(NodeSet, SolidIsWhatIsToothAndNotRemoved) {
    Brick brick;
    static_cast<CutField&>(brick) = CutField::untouched(0.1);
    brick.tooth.fill(0.1F);
    brick.tooth[7] = brick.tooth[8] = brick.tooth[9] = -0.1F;
    brick.cut[8] = -0.01F;
    brick.cut[9] = 0;  // exactly on the boundary: it stays
    NodeSet expected;
    expected.set(7).set(9);
    EXPECT_EQ(solidNodes(brick), expected);
}

TEST(NodeSetAsserts, NodesThatAreNotOnTheFaceHaveNothingAcrossIt) {
    NodeSet middle;
    middle.set(static_cast<std::size_t>(nodeIndex(3, 3, 3)));
    EXPECT_ASSERT(static_cast<void>(kBrickFaces[0].across(middle)));
    EXPECT_ASSERT(static_cast<void>(BrickFace{3, true}.nodes()));
}

}  // namespace
}  // namespace tactooth
