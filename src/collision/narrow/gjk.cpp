// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/narrow/gjk.h"

#include <cmath>

#include "collision/narrow/minkowski_simplex.h"
#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

// E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A Fast Procedure for Computing the Distance Between Complex Objects in
// Three-Dimensional Space", IEEE J. Robotics and Automation 4(2), 1988; G. van den Bergen, "A Fast and Robust GJK
// Implementation for Collision Detection of Convex Objects", J. Graphics Tools 4(2), 1999. Differs from the papers: the
// difference of two triangles has nine corners (18 if one is swept), so a support point that is already in the simplex
// ends the search exactly. And the result contains the slab that the direction found really separates: a caller can
// trust it even if the search has not converged.

namespace tactooth {
namespace {

using Points = std::span<const Vec3>;

constexpr int kMaxIterations = 24;     // 9 to 18 support points exist: 4-5 iterations are usual, more means rounding
constexpr double kTouching = 1e-14;    // of the triangles' size: a smaller distance is contact
constexpr double kFairGap = 0.5;       // of the distance: a narrower slab means a poor direction
constexpr double kNearlyAsWide = 0.7;  // of the distance: a remembered slab shall last for some steps
constexpr double kDualityGap = 1e-15;  // relative: below it a further iteration cannot improve a double

/// The point farthest along a direction.
int supportIndex(Points points, const Vec3& direction) {
    TACTOOTH_ASSERT(!points.empty());
    int best = 0;
    double farthest = direction.dot(points[0]);
    for (int i = 1; i < static_cast<int>(points.size()); ++i) {
        if (const double along = direction.dot(points[i]); along > farthest) farthest = along, best = i;
    }
    return best;
}

MinkowskiPoint support(Points a, Points b, const Vec3& direction) {
    const int onA = supportIndex(a, -direction);
    const int onB = supportIndex(b, direction);
    return {b[onB] - a[onA], onA, onB};
}

double squaredSize(Points points) {
    return (points[1] - points[0]).squaredNorm() + (points[2] - points[0]).squaredNorm();
}

double slabWidth(Points a, Points b, const Vec3& normal) { return lowestAlong(b, normal) - highestAlong(a, normal); }

/// Takes the normal of a plane, in either sense, if the slab along it is wider than that of the result.
void prefer(Points a, Points b, const Vec3& normal, GjkResult& result) {
    const double length = normal.norm();
    if (length == 0) return;
    for (const Vec3& unit : {Vec3(normal / length), Vec3(-normal / length)}) {
        const double gap = slabWidth(a, b, unit);
        if (gap > result.gap) result.gap = gap, result.normal = unit;
    }
}

Vec3 normalOf(Points triangle) { return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]); }

/// Replaces the normal by one of the features in the simplex: it is more exact than the difference of two nearly equal
/// points. At a distance far below their size, a corner over an edge has no such normal. Then the normal of one of the
/// triangles is tried, if it separates the other.
void refineNormal(Points a, Points b, const MinkowskiSimplex& simplex, GjkResult& result) {
    if (simplex.size() == 3) prefer(a, b, simplex.edge(0, 1).cross(simplex.edge(0, 2)), result);
    if (result.gap >= kFairGap * result.distance) return;
    prefer(a, b, normalOf(a), result);
    prefer(a, b, normalOf(b), result);
}

/// The slab across the vector to the nearest point found so far.
GjkResult slabAcross(Points a, Points b, const Vec3& nearest, int iterations) {
    GjkResult result;
    result.iterations = iterations;
    result.distance = nearest.norm();
    result.normal = nearest / result.distance;
    result.gap = slabWidth(a, b, result.normal);
    result.separated = result.gap > 0;
    return result;
}

GjkResult separatedResult(Points a, Points b, const MinkowskiSimplex& simplex, const Vec3& nearest, int iterations) {
    GjkResult result = slabAcross(a, b, nearest, iterations);
    if (result.gap < result.distance * (1 - 1e-9)) refineNormal(a, b, simplex, result);
    result.separated = result.gap > 0;
    if (!result.separated) return {.iterations = iterations};
    TACTOOTH_ASSERT(isUnit(result.normal));
    for (int i = 0; i < simplex.size(); ++i) {
        result.onA += simplex.weight(i) * a[simplex.point(i).onA];
        result.onB += simplex.weight(i) * b[simplex.point(i).onB];
    }
    return result;
}

/// `isEnough(squared, along)`: whether the slab across the vector to the nearest point is wide enough. `squared` is the
/// squared length of that vector, `along` its length times the width of the slab.
template <class IsEnough>
GjkResult search(Points a, Points b, const Vec3& guess, const IsEnough& isEnough) {
    TACTOOTH_ASSERT(a.size() >= 3 && b.size() >= 3);
    TACTOOTH_ASSERT(guess.allFinite());
    MinkowskiSimplex simplex;
    simplex.add(support(a, b, -guess));
    const double touching = kTouching * kTouching * std::max(squaredSize(a), squaredSize(b));
    Vec3 nearest = simplex.nearestToOrigin();
    for (int iteration = 1; iteration <= kMaxIterations; ++iteration) {
        const double squared = nearest.squaredNorm();
        if (squared <= touching) return {.iterations = iteration};
        const MinkowskiPoint next = support(a, b, -nearest);
        const double along = nearest.dot(next.point);
        const bool converged = simplex.holds(next) || squared - along <= kDualityGap * squared;
        if (converged) return separatedResult(a, b, simplex, nearest, iteration);
        if (isEnough(squared, along)) return slabAcross(a, b, nearest, iteration);
        simplex.add(next);
        nearest = simplex.nearestToOrigin();
        if (simplex.size() == 4) return {.iterations = iteration};  // the origin is inside: overlap
    }
    return separatedResult(a, b, simplex, nearest, kMaxIterations);
}

}  // namespace

GjkResult distanceBetween(Points a, Points b, const Vec3& guess) {
    return search(a, b, guess, [](double, double) { return false; });
}

GjkResult separateConvex(Points a, Points b, const Vec3& guess, double least) {
    TACTOOTH_ASSERT(least >= 0);
    return search(a, b, guess, [least](double squared, double along) {
        return along > kNearlyAsWide * squared && along > least * std::sqrt(squared);
    });
}

}  // namespace tactooth
