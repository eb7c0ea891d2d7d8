// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/volume/changed_brick.h"

#include <algorithm>
#include <array>

#include "geometry/util/assert.h"
#include "tooth/volume/brick.h"

namespace tactooth {
namespace {

/// Position of a node along one side of a brick: 0 at the beginning, 2 at the end, 1 between.
constexpr int endOf(int place) { return place == 0 ? 0 : place == kBrickSide - 1 ? 2 : 1; }

/// By `endOf` on each axis: the bricks that have a node within one step of such a node on each axis.
constexpr auto kAffected = [] {
    std::array<std::array<std::array<std::uint32_t, 3>, 3>, 3> table{};
    const auto reaches = [](int end, int step) { return step == 1 || step == end; };
    for (int node = 0; node < 27; ++node) {
        const std::array<int, 3> end = {node % 3, node / 3 % 3, node / 9};
        std::uint32_t& bricks = table[end[0]][end[1]][end[2]];
        for (int i = 0; i < 27; ++i) {
            if (!reaches(end[0], i % 3) || !reaches(end[1], i / 3 % 3) || !reaches(end[2], i / 9)) continue;
            bricks |= 1U << i;
        }
    }
    return table;
}();

}  // namespace

void ChangedBrick::addNode(int node) {
    const auto [x, y, z] = placeOf(node);
    affected |= kAffected[endOf(x)][endOf(y)][endOf(z)];
}

void ChangedBrick::addEdge(int node, int axis) {
    TACTOOTH_ASSERT(axis >= 0 && axis < 3);
    const std::array<int, 3> place = placeOf(node);
    std::array<int, 3> ends = {endOf(place[0]), endOf(place[1]), endOf(place[2])};
    if (place[axis] == 0) ends[axis] = 1;  // the edge leads away from the brick before
    affected |= kAffected[ends[0]][ends[1]][ends[2]];
}

std::vector<ChangedBrick> merged(std::vector<ChangedBrick> changes) {
    std::erase_if(changes, [](const ChangedBrick& change) { return change.isNone(); });
    std::sort(changes.begin(), changes.end(),
              [](const ChangedBrick& a, const ChangedBrick& b) { return a.key < b.key; });
    std::vector<ChangedBrick> result;
    for (const ChangedBrick& change : changes) {
        if (!result.empty() && result.back().key == change.key) {
            result.back().add(change);
        } else {
            result.push_back(change);
        }
    }
    return result;
}

}  // namespace tactooth
