// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/narrow/gjk.h"

#include <cmath>

#include "collision/narrow/minkowski_simplex.h"

// E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A Fast Procedure for Computing the Distance Between Complex Objects in
// Three-Dimensional Space", IEEE J. Robotics and Automation 4(2), 1988; G. van den Bergen, "A Fast and Robust GJK
// Implementation for Collision Detection of Convex Objects", J. Graphics Tools 4(2), 1999. Differs from the papers:
// the difference of two triangles has nine corners (18 if one is swept), so a support point that is already in the
// simplex ends the search exactly; and the answer carries the slab that the found direction really separates, which a
// caller can trust without trusting the convergence.

namespace tactooth {
namespace {

using Points = std::span<const Vec3>;

constexpr int kMaxIterations = 24;     // 9 to 18 support points exist: 4-5 rounds are usual, more means rounding
constexpr double kTouching = 1e-14;    // of the triangles' size: closer than this is contact
constexpr double kFairGap = 0.5;       // of the distance: less than that of a slab is a fault of its direction
constexpr double kNearlyAsWide = 0.7;  // of the distance: a slab that is remembered shall last for some steps
constexpr double kDualityGap = 1e-15;  // relative: below it a further round cannot improve a double

int supportIndex(Points points, const Vec3& direction) {
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

/// Takes the normal of a plane, either way round, if the slab along it is wider than the result's.
void prefer(Points a, Points b, const Vec3& normal, GjkResult& result) {
    const double length = normal.norm();
    if (length == 0) return;
    for (const Vec3& unit : {Vec3(normal / length), Vec3(-normal / length)}) {
        const double gap = slabWidth(a, b, unit);
        if (gap > result.gap) result.gap = gap, result.normal = unit;
    }
}

Vec3 normalOf(Points triangle) { return (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]); }

/// The normal of the features that the simplex names is more exact than the difference of two nearly equal points. Far
/// below their size a corner over an edge has none: then one of the triangles' own, which stands beside the other.
void refineNormal(Points a, Points b, const MinkowskiSimplex& simplex, GjkResult& result) {
    if (simplex.size() == 3) prefer(a, b, simplex.edge(0, 1).cross(simplex.edge(0, 2)), result);
    if (result.gap >= kFairGap * result.distance) return;
    prefer(a, b, normalOf(a), result);
    prefer(a, b, normalOf(b), result);
}

/// The slab across the way to the nearest point found so far.
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
    for (int i = 0; i < simplex.size(); ++i) {
        result.onA += simplex.weight(i) * a[simplex.point(i).onA];
        result.onB += simplex.weight(i) * b[simplex.point(i).onB];
    }
    return result;
}

/// `isEnough(squared, along)`: whether the slab across the way to the nearest point will do, given that way squared and
/// the slab's width times it.
template <class IsEnough>
GjkResult search(Points a, Points b, const Vec3& guess, const IsEnough& isEnough) {
    MinkowskiSimplex simplex;
    simplex.add(support(a, b, -guess));
    const double touching = kTouching * kTouching * std::max(squaredSize(a), squaredSize(b));
    Vec3 nearest = simplex.nearestToOrigin();
    for (int round = 1; round <= kMaxIterations; ++round) {
        const double squared = nearest.squaredNorm();
        if (squared <= touching) return {.iterations = round};
        const MinkowskiPoint next = support(a, b, -nearest);
        const double along = nearest.dot(next.point);
        const bool converged = simplex.holds(next) || squared - along <= kDualityGap * squared;
        if (converged) return separatedResult(a, b, simplex, nearest, round);
        if (isEnough(squared, along)) return slabAcross(a, b, nearest, round);
        simplex.add(next);
        nearest = simplex.nearestToOrigin();
        if (simplex.size() == 4) return {.iterations = round};  // the origin is inside: overlap
    }
    return separatedResult(a, b, simplex, nearest, kMaxIterations);
}

}  // namespace

GjkResult distanceBetween(Points a, Points b, const Vec3& guess) {
    return search(a, b, guess, [](double, double) { return false; });
}

GjkResult separateConvex(Points a, Points b, const Vec3& guess, double least) {
    return search(a, b, guess, [least](double squared, double along) {
        return along > kNearlyAsWide * squared && along > least * std::sqrt(squared);
    });
}

}  // namespace tactooth
