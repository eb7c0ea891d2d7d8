// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/closest_point.h"

#include <array>
#include <cmath>

#include "collision/bvh/point_box_distance.h"
#include "collision/bvh/ray_crossing.h"
#include "collision/narrow/triangle_point.h"
#include "geometry/util/assert.h"

// Best-first descent with the children of a node visited nearest first: N. Roussopoulos, S. Kelley, F. Vincent,
// "Nearest Neighbor Queries", SIGMOD 1995, section 3. Differs from the paper: eight boxes are tested at a time, and
// pruned by the distance to a box alone, without the paper's upper bound. Inside test: parity of the crossings of one
// ray. A ray that grazes an edge or a corner is rejected, and another direction is tried.

namespace tactooth {
namespace {

struct Visit {
    AabbTree::Link link;
    float squaredDistance;
};

/// Whether the ray crosses the triangles, without those in `hidden`, an odd number of times. None if it grazed an edge.
std::optional<bool> crossesOddly(const AabbTree& tree, const TriangleMask* hidden, const Vec3& origin,
                                 const Vec3& direction) {
    bool odd = false;
    const bool isClear = visitCrossings(tree, hidden, origin, direction, [&](std::uint32_t, RayHit hit) {
        odd = !odd;
        return hit != RayHit::Grazing;
    });
    return isClear ? std::optional(odd) : std::nullopt;
}

/// Whether a ray may enter `box`. `margin` is that of boxesOnRay, or larger.
bool mayEnter(const Box3& box, const Vec3& origin, const Vec3& inverseDirection, double margin) {
    const Eigen::Array3d first = (box.min().array() - margin - origin.array()) * inverseDirection.array();
    const Eigen::Array3d second = (box.max().array() + margin - origin.array()) * inverseDirection.array();
    return std::max(0.0, first.min(second).maxCoeff()) <= first.max(second).minCoeff();
}

}  // namespace

std::optional<ClosestPoint> closestPoint(const SurfacePart& part, const Vec3& query, double within) {
    TACTOOTH_ASSERT(query.allFinite());
    TACTOOTH_ASSERT(within >= 0);
    const AabbTree& tree = part.tree();
    if (tree.empty()) return std::nullopt;
    const double slack = slackNear(query);
    const Vec3x8 query8 = broadcastPoint(query);
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
            TACTOOTH_ASSERT(size < AabbTree::kStackSize);
            int place = size++;
            for (; place > first && stack[place - 1].squaredDistance < distances[i]; --place)
                stack[place] = stack[place - 1];
            stack[place] = {node.child[i], distances[i]};
        }
    }
    if (best) best->distance = std::sqrt(bestSquared);
    TACTOOTH_ASSERT(!best || best->distance <= within);
    return best;
}

bool contains(const Surface& surface, const Vec3& query) {
    TACTOOTH_ASSERT(surface.base != nullptr);
    if (surface.base->tree().empty() || !surface.base->tree().box().contains(query)) return false;
    const VisibleBase base = visibleBase(surface);
    const double margin = 1e-6 * surface.base->tree().box().diagonal().norm();
    for (int attempt = 0; attempt < kRayAttempts; ++attempt) {
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
    // A surface without patches, whose base refers to the part but does not own it.
    return contains(Surface{std::shared_ptr<const SurfacePart>(std::shared_ptr<void>(), &part), nullptr, {}, 0}, query);
}

double signedDistance(const SurfacePart& part, const Vec3& query) {
    const std::optional<ClosestPoint> closest = closestPoint(part, query);
    TACTOOTH_ASSERT(closest.has_value());
    return contains(part, query) ? -closest->distance : closest->distance;
}

}  // namespace tactooth
