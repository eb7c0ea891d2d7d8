// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/aabb_tree.h"
#include "collision/narrow/simd8.h"

// For searches of the triangles near a point: distances from eight boxes at a time, in single precision.

namespace tactooth {

/// A point in all eight lanes, rounded to single precision; see slackNear for the error.
[[nodiscard]] inline Vec3x8 broadcastPoint(const Vec3& point) {
    return Vec3x8::all(static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z()));
}

/// By how much (mm) a computed distance from `point` to a box may be too large.
[[nodiscard]] inline double slackNear(const Vec3& point) { return 1e-6 * (1 + point.cwiseAbs().maxCoeff()); }

/// Squared distances from a point to eight boxes, mm^2.
[[nodiscard]] inline Float8 squaredBoxDistances(const Vec3x8& low, const Vec3x8& high, const Vec3x8& query) {
    const Vec3x8 gap = max(max(low - query, query - high), Vec3x8::all(0, 0, 0));
    return dot(gap, gap);
}

/// Squared distances to the boxes of a node's children, mm^2; infinite for absent children.
[[nodiscard]] inline Float8 squaredBoxDistances(const AabbTree::Node& node, const Vec3x8& query) {
    return squaredBoxDistances(Vec3x8::load(node.low), Vec3x8::load(node.high), query);
}

/// Squared distances to the boxes of a leaf's triangles, mm^2. Lanes beyond its count have no meaning.
[[nodiscard]] inline Float8 squaredBoxDistances(const AabbTree::Leaf& leaf, const Vec3x8& query) {
    const Vec3x8 a = Vec3x8::load(leaf.corner[0]);
    const Vec3x8 b = Vec3x8::load(leaf.corner[1]);
    const Vec3x8 c = Vec3x8::load(leaf.corner[2]);
    return squaredBoxDistances(min(min(a, b), c), max(max(a, b), c), query);
}

/// A corner (0 to 2) of a triangle of a leaf, mm.
[[nodiscard]] inline Vec3 leafCorner(const AabbTree::Leaf& leaf, int corner, std::uint32_t lane) {
    TACTOOTH_ASSERT(corner >= 0 && corner < 3 && lane < leaf.count);
    return {leaf.corner[corner][0][lane], leaf.corner[corner][1][lane], leaf.corner[corner][2][lane]};
}

}  // namespace tactooth
