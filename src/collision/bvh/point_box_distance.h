// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/aabb_tree.h"
#include "collision/narrow/simd8.h"

// What all who look for the triangles near a point have in common: eight boxes at a time, in single precision.

namespace tactooth {

/// A point for comparisons with eight boxes; slackNear says what its rounding may hide.
[[nodiscard]] inline Vec3x8 broadcastPoint(const Vec3& point) {
    return Vec3x8::all(static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z()));
}

/// mm by which a distance from `point` to a box may come out too large.
[[nodiscard]] inline double slackNear(const Vec3& point) { return 1e-6 * (1 + point.cwiseAbs().maxCoeff()); }

/// Squared distances from a point to eight boxes, mm^2.
[[nodiscard]] inline Float8 squaredBoxDistances(const Vec3x8& low, const Vec3x8& high, const Vec3x8& query) {
    const Vec3x8 gap = max(max(low - query, query - high), Vec3x8::all(0, 0, 0));
    return dot(gap, gap);
}

/// The same to the boxes of a node's children; infinite where there is none.
[[nodiscard]] inline Float8 squaredBoxDistances(const AabbTree::Node& node, const Vec3x8& query) {
    return squaredBoxDistances(Vec3x8::load(node.low), Vec3x8::load(node.high), query);
}

/// The same to the boxes of a leaf's triangles; of any value beyond its count.
[[nodiscard]] inline Float8 squaredBoxDistances(const AabbTree::Leaf& leaf, const Vec3x8& query) {
    const Vec3x8 a = Vec3x8::load(leaf.corner[0]);
    const Vec3x8 b = Vec3x8::load(leaf.corner[1]);
    const Vec3x8 c = Vec3x8::load(leaf.corner[2]);
    return squaredBoxDistances(min(min(a, b), c), max(max(a, b), c), query);
}

[[nodiscard]] inline Vec3 leafCorner(const AabbTree::Leaf& leaf, int corner, std::uint32_t lane) {
    return {leaf.corner[corner][0][lane], leaf.corner[corner][1][lane], leaf.corner[corner][2][lane]};
}

}  // namespace tactooth
