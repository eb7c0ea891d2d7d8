// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/near_leaves.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "collision/simd8.h"
#include "collision/triangle_point.h"

namespace tactooth {
namespace {

Vec3x8 everywhere(const Vec3& v) {
    return Vec3x8::all(static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z()));
}

/// One bit for each of eight boxes that come within `reach` of a point. Single precision: `slack` is in the reach.
std::uint32_t boxesWithin(const Vec3x8& low, const Vec3x8& high, const Vec3x8& query, double reach) {
    const Vec3x8 gap = max(max(low - query, query - high), Vec3x8::all(0, 0, 0));
    return lessEqual(dot(gap, gap), Float8::all(static_cast<float>(reach * reach * (1 + 1e-6))));
}

std::uint32_t trianglesWithin(const AabbTree::Leaf& leaf, const Vec3x8& query, double reach) {
    const Vec3x8 a = Vec3x8::load(leaf.corner[0]);
    const Vec3x8 b = Vec3x8::load(leaf.corner[1]);
    const Vec3x8 c = Vec3x8::load(leaf.corner[2]);
    return boxesWithin(min(min(a, b), c), max(max(a, b), c), query, reach) & ((1U << leaf.count) - 1U);
}

Vec3 cornerOf(const AabbTree::Leaf& leaf, int corner, int lane) {
    return {leaf.corner[corner][0][lane], leaf.corner[corner][1][lane], leaf.corner[corner][2][lane]};
}

/// What the rounding of a query to single precision can hide of a distance, mm.
double slackAt(const Vec3& query) { return 1e-6 * (1 + query.cwiseAbs().maxCoeff()); }

}  // namespace

NearLeaves::NearLeaves(const SurfacePart& part, const Vec3& centre, double reach) {
    const AabbTree& tree = part.tree();
    if (tree.empty()) return;
    const Vec3x8 query = everywhere(centre);
    const double farthest = reach + 2 * slackAt(centre);
    std::array<AabbTree::Link, AabbTree::kStackSize> stack;
    int size = 0;
    stack[size++] = tree.rootLink();
    while (size > 0) {
        const AabbTree::Node& node = tree.node(stack[--size]);
        std::uint32_t near = boxesWithin(Vec3x8::load(node.low), Vec3x8::load(node.high), query, farthest);
        for (; near != 0; near &= near - 1) {
            const int child = std::countr_zero(near);
            if (!(node.low[0][child] <= node.high[0][child])) continue;  // absent
            const AabbTree::Link link = node.child[child];
            if (!link.isLeaf()) {
                stack[size++] = link;
            } else if (trianglesWithin(tree.leaf(link), query, farthest) != 0) {
                add(node, child, tree.leaf(link));
            }
        }
    }
}

void NearLeaves::add(const AabbTree::Node& node, int child, const AabbTree::Leaf& leaf) {
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

std::optional<ClosestPoint> NearLeaves::closest(const Vec3& query, double within) const {
    const double slack = slackAt(query);
    const Vec3x8 query8 = everywhere(query);
    std::optional<ClosestPoint> best;
    double bestSquared = within * within;
    double reach = within + slack;
    for (const Group& group : groups_) {
        std::uint32_t leaves = boxesWithin(Vec3x8::load(group.low), Vec3x8::load(group.high), query8, reach);
        for (; leaves != 0; leaves &= leaves - 1) {
            const AabbTree::Leaf& leaf = *group.leaf[std::countr_zero(leaves)];
            for (std::uint32_t near = trianglesWithin(leaf, query8, reach); near != 0; near &= near - 1) {
                const int lane = std::countr_zero(near);
                const Vec3 point =
                    closestOnTriangle(query, cornerOf(leaf, 0, lane), cornerOf(leaf, 1, lane), cornerOf(leaf, 2, lane));
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
    return best;
}

}  // namespace tactooth
