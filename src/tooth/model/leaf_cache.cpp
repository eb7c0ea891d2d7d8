// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/model/leaf_cache.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "collision/bvh/point_box_distance.h"
#include "collision/narrow/triangle_point.h"
#include "geometry/util/assert.h"

// Own method. One traversal of the tree collects the leaves within a ball. Each query then tests the boxes of these
// leaves, eight at a time, and the triangles of the leaves that are near enough.

namespace tactooth {
namespace {

/// One bit for each of eight boxes: whether its squared distance is within `reach`.
std::uint32_t boxesWithin(const Float8& squaredDistances, double reach) {
    return lessEqual(squaredDistances, Float8::all(static_cast<float>(reach * reach * (1 + 1e-6))));
}

std::uint32_t trianglesWithin(const AabbTree::Leaf& leaf, const Vec3x8& query, double reach) {
    return boxesWithin(squaredBoxDistances(leaf, query), reach) & ((1U << leaf.count) - 1U);
}

}  // namespace

LeafCache::LeafCache(const SurfacePart& part, const Vec3& centre, double reach) {
    TACTOOTH_ASSERT(centre.allFinite());
    TACTOOTH_ASSERT(std::isfinite(reach) && reach >= 0);
    const AabbTree& tree = part.tree();
    if (tree.empty()) return;
    const Vec3x8 query = broadcastPoint(centre);
    const double farthest = reach + 2 * slackNear(centre);
    std::array<AabbTree::Link, AabbTree::kStackSize> stack;
    int size = 0;
    stack[size++] = tree.rootLink();
    while (size > 0) {
        const AabbTree::Node& node = tree.node(stack[--size]);
        std::uint32_t near = boxesWithin(squaredBoxDistances(node, query), farthest);
        for (; near != 0; near &= near - 1) {
            const int child = std::countr_zero(near);
            if (!(node.low[0][child] <= node.high[0][child])) continue;  // no child
            const AabbTree::Link link = node.child[child];
            if (!link.isLeaf()) {
                TACTOOTH_ASSERT(size < AabbTree::kStackSize);
                stack[size++] = link;
            } else if (trianglesWithin(tree.leaf(link), query, farthest) != 0) {
                add(node, child, tree.leaf(link));
            }
        }
    }
}

void LeafCache::add(const AabbTree::Node& node, int child, const AabbTree::Leaf& leaf) {
    TACTOOTH_ASSERT(child >= 0 && child < AabbTree::kWidth);
    TACTOOTH_ASSERT(leaf.count > 0 && leaf.count <= 8);
    TACTOOTH_ASSERT(last_ > 0 && last_ <= 8);
    if (last_ == 8) {
        Group& group = groups_.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(group.low[axis], 8, std::numeric_limits<float>::infinity());
            std::fill_n(group.high[axis], 8, std::numeric_limits<float>::infinity());
        }
        last_ = 0;
    }
    Group& group = groups_.back();
    for (int axis = 0; axis < 3; ++axis) {
        group.low[axis][last_] = node.low[axis][child];
        group.high[axis][last_] = node.high[axis][child];
    }
    group.leaf[last_++] = &leaf;
}

std::optional<ClosestPoint> LeafCache::closest(const Vec3& query, double within) const {
    TACTOOTH_ASSERT(query.allFinite());
    TACTOOTH_ASSERT(within >= 0);
    const double slack = slackNear(query);
    const Vec3x8 query8 = broadcastPoint(query);
    std::optional<ClosestPoint> best;
    double bestSquared = within * within;
    double reach = within + slack;
    for (const Group& group : groups_) {
        std::uint32_t leaves =
            boxesWithin(squaredBoxDistances(Vec3x8::load(group.low), Vec3x8::load(group.high), query8), reach);
        for (; leaves != 0; leaves &= leaves - 1) {
            const AabbTree::Leaf& leaf = *group.leaf[std::countr_zero(leaves)];
            for (std::uint32_t near = trianglesWithin(leaf, query8, reach); near != 0; near &= near - 1) {
                const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
                const Vec3 point = closestOnTriangle(query, leafCorner(leaf, 0, lane), leafCorner(leaf, 1, lane),
                                                     leafCorner(leaf, 2, lane));
                const double squared = (point - query).squaredNorm();
                if (squared > bestSquared) continue;
                if (squared == bestSquared && best && leaf.triangle[lane] > best->triangle) continue;
                bestSquared = squared;
                best = ClosestPoint{point, 0, leaf.triangle[lane]};
                reach = std::sqrt(squared) + slack;
            }
        }
    }
    if (best) best->distance = std::sqrt(bestSquared);
    TACTOOTH_ASSERT(!best || best->distance <= within * (1 + 1e-12));
    return best;
}

}  // namespace tactooth
