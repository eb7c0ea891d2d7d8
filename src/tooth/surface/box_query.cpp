// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/box_query.h"

#include <algorithm>
#include <array>

#include "geometry/util/assert.h"

namespace tactooth {

std::vector<std::uint32_t> trianglesTouching(const SurfacePart& part, const Box3& box) {
    TACTOOTH_ASSERT(!box.isEmpty());
    std::vector<std::uint32_t> found;
    const AabbTree& tree = part.tree();
    if (tree.empty()) return found;
    std::array<AabbTree::Link, AabbTree::kStackSize> stack;
    int size = 0;
    stack[size++] = tree.rootLink();
    const auto overlaps = [&](const auto& low, const auto& high) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!(low(axis) <= box.max()[axis] && high(axis) >= box.min()[axis])) return false;
        }
        return true;
    };
    while (size > 0) {
        const AabbTree::Link link = stack[--size];
        if (link.isLeaf()) {
            const AabbTree::Leaf& leaf = tree.leaf(link);
            for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
                const auto corner = [&](int c, int axis) { return leaf.corner[c][axis][lane]; };
                const auto low = [&](int a) { return std::min({corner(0, a), corner(1, a), corner(2, a)}); };
                const auto high = [&](int a) { return std::max({corner(0, a), corner(1, a), corner(2, a)}); };
                if (overlaps(low, high)) found.push_back(leaf.triangle[lane]);
            }
            continue;
        }
        TACTOOTH_ASSERT(size + AabbTree::kWidth <= AabbTree::kStackSize);
        const AabbTree::Node& node = tree.node(link);
        for (int child = 0; child < AabbTree::kWidth; ++child) {
            const auto low = [&](int axis) { return node.low[axis][child]; };
            const auto high = [&](int axis) { return node.high[axis][child]; };
            if (overlaps(low, high)) stack[size++] = node.child[child];
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace tactooth
