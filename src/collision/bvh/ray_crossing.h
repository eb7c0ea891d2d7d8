// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Private to closest_point.cpp and winding.cpp: the crossings of a ray with the triangles of a tree. A ray that grazes
// an edge or a corner is rejected, and another direction is tried.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "collision/bvh/point_box_distance.h"
#include "collision/bvh/surface.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// Each ray grazes an edge with a probability far below one in a million.
inline constexpr int kRayAttempts = 16;

/// A ray direction for each attempt. No edge of an axis-aligned or symmetric model is parallel to it.
inline Vec3 rayDirection(int attempt) {
    TACTOOTH_ASSERT(attempt >= 0 && attempt < kRayAttempts);
    const double angle = 0.7548776662466927 * (attempt + 1);  // plastic number: spreads the attempts evenly
    return Vec3(std::cos(5.1 * angle), std::sin(7.3 * angle), 0.5698402909980532 + 0.1 * attempt).normalized();
}

enum class RayHit { Miss, Entering, Leaving, Grazing };

/// Crossing of the ray from `origin` along `direction` with a triangle: T. Moeller, B. Trumbore, "Fast, Minimum Storage
/// Ray/Triangle Intersection", J. Graphics Tools 2(1), 1997. Differs from the paper: a ray near an edge is reported as
/// grazing. Entering: against the triangle's normal.
inline RayHit crosses(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c) {
    constexpr double kBorder = 1e-9;  // of the barycentric coordinates: far above rounding, far below any real edge
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 p = direction.cross(ac);
    const double determinant = ab.dot(p);
    if (std::abs(determinant) <= kBorder * ab.norm() * ac.norm()) {
        const Vec3 normal = ab.cross(ac);
        const bool inPlane = std::abs(normal.dot(origin - a)) <= kBorder * normal.norm();
        return inPlane && normal.squaredNorm() > 0 ? RayHit::Grazing : RayHit::Miss;
    }
    const Vec3 s = origin - a;
    const double u = s.dot(p) / determinant;
    const Vec3 q = s.cross(ab);
    const double v = direction.dot(q) / determinant;
    const double t = ac.dot(q) / determinant;
    if (u < -kBorder || v < -kBorder || u + v > 1 + kBorder || t < 0) return RayHit::Miss;
    if (u < kBorder || v < kBorder || u + v > 1 - kBorder) return RayHit::Grazing;
    return determinant < 0 ? RayHit::Leaving : RayHit::Entering;
}

/// One bit for each box of a node that a ray enters. Conservative: the boxes are grown by `margin` (mm) for rounding.
inline std::uint32_t boxesOnRay(const AabbTree::Node& node, const Vec3& origin, const Vec3& direction, double margin) {
    std::uint32_t hits = 0;
    for (int i = 0; i < AabbTree::kWidth; ++i) {
        if (!(node.low[0][i] <= node.high[0][i])) continue;
        double enter = 0;
        double leave = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) {
            const double inverse = 1 / direction[axis];
            const double first = (node.low[axis][i] - margin - origin[axis]) * inverse;
            const double second = (node.high[axis][i] + margin - origin[axis]) * inverse;
            enter = std::max(enter, std::min(first, second));
            leave = std::min(leave, std::max(first, second));
        }
        if (enter <= leave) hits |= 1U << i;
    }
    return hits;
}

/// Calls `visit(triangle, hit)` for each triangle that the ray crosses or grazes, without those in `hidden`, until it
/// returns false. Then the result is false.
template <class Visit>
bool visitCrossings(const AabbTree& tree, const TriangleMask* hidden, const Vec3& origin, const Vec3& direction,
                    Visit&& visit) {
    if (tree.empty()) return true;
    const double margin = 1e-6 * tree.box().diagonal().norm();
    std::array<AabbTree::Link, AabbTree::kStackSize> stack;
    TACTOOTH_ASSERT(origin.allFinite() && direction.allFinite());
    int size = 0;
    stack[size++] = tree.rootLink();
    while (size > 0) {
        const AabbTree::Link link = stack[--size];
        if (link.isLeaf()) {
            const AabbTree::Leaf& leaf = tree.leaf(link);
            for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
                if (hidden != nullptr && isHidden(*hidden, leaf.triangle[lane])) continue;
                const RayHit hit = crosses(origin, direction, leafCorner(leaf, 0, lane), leafCorner(leaf, 1, lane),
                                           leafCorner(leaf, 2, lane));
                if (hit == RayHit::Miss) continue;
                if (!visit(leaf.triangle[lane], hit)) return false;
            }
            continue;
        }
        const AabbTree::Node& node = tree.node(link);
        for (std::uint32_t hits = boxesOnRay(node, origin, direction, margin); hits != 0; hits &= hits - 1) {
            TACTOOTH_ASSERT(size < AabbTree::kStackSize);
            stack[size++] = node.child[std::countr_zero(hits)];
        }
    }
    return true;
}

}  // namespace tactooth
