// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/closest_point.h"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>

#include "collision/near_point.h"
#include "collision/triangle_point.h"

// Best-first descent with the children of a node visited nearest first: N. Roussopoulos, S. Kelley, F. Vincent,
// "Nearest Neighbor Queries", SIGMOD 1995. Inside test: parity of the crossings of one ray; a ray that grazes an edge
// or a corner is thrown away and another direction is taken. Differs from the paper: the boxes are looked at eight at a
// time, and pruned by the distance to a box alone, without the paper's upper bound.

namespace tactooth {
namespace {

struct Visit {
    AabbTree::Link link;
    float squaredDistance;
};

/// A ray direction that no edge of an axis-aligned or symmetric model lies along, one for each try.
Vec3 rayDirection(int attempt) {
    const double angle = 0.7548776662466927 * (attempt + 1);  // plastic number: spreads the tries evenly
    return Vec3(std::cos(5.1 * angle), std::sin(7.3 * angle), 0.5698402909980532 + 0.1 * attempt).normalized();
}

enum class RayHit { Miss, Hit, Grazing };

/// Crossing of the ray from `origin` along `direction` with a triangle (T. Moeller and B. Trumbore, "Fast, Minimum
/// Storage Ray/Triangle Intersection", 1997), with the borderline named instead of guessed.
RayHit crosses(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c) {
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
    return RayHit::Hit;
}

/// The boxes of a node that a ray enters, one bit each. Conservative: the box is grown by a rounding margin.
std::uint32_t boxesOnRay(const AabbTree::Node& node, const Vec3& origin, const Vec3& direction, double margin) {
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

/// Whether the ray crosses the triangles (but those that `hidden` names) an odd number of times; nothing if it grazed
/// an edge.
std::optional<bool> crossesOddly(const AabbTree& tree, const TriangleMask* hidden, const Vec3& origin,
                                 const Vec3& direction) {
    if (tree.empty()) return false;
    const double margin = 1e-6 * tree.box().diagonal().norm();
    std::array<AabbTree::Link, AabbTree::kStackSize> stack;
    int size = 0;
    stack[size++] = tree.rootLink();
    bool odd = false;
    while (size > 0) {
        const AabbTree::Link link = stack[--size];
        if (link.isLeaf()) {
            const AabbTree::Leaf& leaf = tree.leaf(link);
            for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
                if (hidden != nullptr && isHidden(*hidden, leaf.triangle[lane])) continue;
                const RayHit hit = crosses(origin, direction, leafCorner(leaf, 0, lane), leafCorner(leaf, 1, lane),
                                           leafCorner(leaf, 2, lane));
                if (hit == RayHit::Grazing) return std::nullopt;
                odd ^= hit == RayHit::Hit;
            }
            continue;
        }
        const AabbTree::Node& node = tree.node(link);
        for (std::uint32_t hits = boxesOnRay(node, origin, direction, margin); hits != 0; hits &= hits - 1) {
            stack[size++] = node.child[std::countr_zero(hits)];
        }
    }
    return odd;
}

/// Whether a ray may enter `box`; `margin`: as that of boxesOnRay, or larger.
bool mayEnter(const Box3& box, const Vec3& origin, const Vec3& inverseDirection, double margin) {
    const Eigen::Array3d first = (box.min().array() - margin - origin.array()) * inverseDirection.array();
    const Eigen::Array3d second = (box.max().array() + margin - origin.array()) * inverseDirection.array();
    return std::max(0.0, first.min(second).maxCoeff()) <= first.max(second).minCoeff();
}

}  // namespace

std::optional<ClosestPoint> closestPoint(const SurfacePart& part, const Vec3& query, double within) {
    const AabbTree& tree = part.tree();
    if (tree.empty()) return std::nullopt;
    const double slack = slackNear(query);
    const Vec3x8 query8 = inAllLanes(query);
    std::array<Visit, AabbTree::kStackSize> stack;
    int size = 0;
    stack[size++] = {tree.rootLink(), 0.0F};
    std::optional<ClosestPoint> best;
    double bestSquared = within * within;
    double reach = within + slack;
    while (size > 0) {
        const Visit visit = stack[--size];
        if (visit.squaredDistance > reach * reach) continue;
        if (visit.link.isLeaf()) {
            const AabbTree::Leaf& leaf = tree.leaf(visit.link);
            std::array<float, 8> distances;
            squaredBoxDistances(leaf, query8).store(distances.data());
            for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
                if (!(distances[lane] <= reach * reach)) continue;
                const Vec3 point = closestOnTriangle(query, leafCorner(leaf, 0, lane), leafCorner(leaf, 1, lane),
                                                     leafCorner(leaf, 2, lane));
                const double squared = (point - query).squaredNorm();
                if (squared < bestSquared ||
                    (squared == bestSquared && (!best || leaf.triangle[lane] < best->triangle))) {
                    bestSquared = squared;
                    best = ClosestPoint{point, 0, leaf.triangle[lane]};
                    reach = std::sqrt(squared) + slack;
                }
            }
            continue;
        }
        const AabbTree::Node& node = tree.node(visit.link);
        std::array<float, 8> distances;
        squaredBoxDistances(node, query8).store(distances.data());
        const int first = size;
        for (int i = 0; i < AabbTree::kWidth; ++i) {
            if (!(distances[i] <= reach * reach) || std::isinf(distances[i])) continue;  // infinite: an absent child
            int place = size++;
            for (; place > first && stack[place - 1].squaredDistance < distances[i]; --place)
                stack[place] = stack[place - 1];
            stack[place] = {node.child[i], distances[i]};
        }
    }
    if (best) best->distance = std::sqrt(bestSquared);
    return best;
}

bool contains(const Surface& surface, const Vec3& query) {
    if (surface.base->tree().empty() || !surface.base->tree().box().contains(query)) return false;
    const VisibleBase base = visibleBase(surface);
    const double margin = 1e-6 * surface.base->tree().box().diagonal().norm();
    constexpr int kAttempts = 16;  // each try grazes an edge with a chance far below one in a million
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const Vec3 direction = rayDirection(attempt);
        std::optional<bool> odd = crossesOddly(base.tree, base.hidden, query, direction);
        const Vec3 inverse = direction.cwiseInverse();
        for (std::size_t i = 0; i < surface.patches.size() && odd; ++i) {
            if (!mayEnter(surface.patches[i]->tree().box(), query, inverse, margin)) continue;
            const std::optional<bool> patch = crossesOddly(surface.patches[i]->tree(), nullptr, query, direction);
            odd = patch ? std::optional(*odd != *patch) : std::nullopt;
        }
        if (odd) return *odd;
    }
    return false;  // every ray grazes: the point lies on the surface itself
}

bool contains(const SurfacePart& part, const Vec3& query) {
    // A view of the part that does not own it, as the base of a surface without patches.
    return contains(Surface{std::shared_ptr<const SurfacePart>(std::shared_ptr<void>(), &part), nullptr, {}, 0}, query);
}

double signedDistance(const SurfacePart& part, const Vec3& query) {
    const std::optional<ClosestPoint> closest = closestPoint(part, query);
    assert(closest.has_value());
    return contains(part, query) ? -closest->distance : closest->distance;
}

}  // namespace tactooth
