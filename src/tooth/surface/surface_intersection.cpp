// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/surface/surface_intersection.h"

#include <algorithm>
#include <cmath>

#include "geometry/util/assert.h"
#include "geometry/util/exact_sign.h"

// Source: simulation of simplicity (H. Edelsbrunner, E. Mücke, ACM Transactions on Graphics 9, 1990). Difference: the
// perturbation shifts one whole surface against the other, and not every coordinate. The shift of the wall decides each
// test of a corner against a face and of an edge against an edge, unless a face has no area. No edge passes through
// such a face. Its own edges pass through other faces, always two of them at the same place, and the cut line passes
// there too.

namespace tactooth {
namespace {

int firstNonZeroCross(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d) {
    for (int axis = 0; axis < 3; ++axis) {
        if (const int sign = crossProductSign(a, b, c, d, axis)) return sign;
    }
    return 0;
}

/// Side of the face on which a corner of the other surface lies: 1 in front, -1 behind, 0 if the face has no area. The
/// perturbation moves a wall corner along the normal of a base face, and a base corner against the normal of a wall
/// face.
int sideOf(const IntersectingFace& face, const ExactPlane& plane, const Vec3f& point, bool faceIsWall) {
    if (const int sign = plane.sideOf(point)) return sign;
    const int shifted = firstNonZeroCross(face.corner[0], face.corner[1], face.corner[0], face.corner[2]);
    return faceIsWall ? -shifted : shifted;
}

/// Whether all corners lie on the same side of a face.
bool areOnOneSide(const std::array<int, 3>& side) { return side[0] != 0 && side[0] == side[1] && side[1] == side[2]; }

/// Sign of the volume of the tetrahedron of base edge ab and wall edge pq.
int turnOf(const Vec3f& a, const Vec3f& b, const Vec3f& p, const Vec3f& q) {
    if (const int sign = orientationSign(a, b, p, q)) return sign;
    return firstNonZeroCross(a, b, q, p);
}

bool passesThrough(const Vec3f& from, const Vec3f& to, const IntersectingFace& face, bool faceIsWall) {
    int first = 0;
    for (int i = 0; i < 3; ++i) {
        const Vec3f& c = face.corner[i];
        const Vec3f& d = face.corner[(i + 1) % 3];
        const int turn = faceIsWall ? turnOf(from, to, c, d) : turnOf(c, d, from, to);
        if (turn == 0 || (i > 0 && turn != first)) return false;
        first = turn;
    }
    return true;
}

/// Computed from the end of the edge with the lower id, so that every face at that edge gets the same bits. Clamped to
/// the box of the face, so that rounding lifts no point off an axis-parallel face.
IntersectionPoint pointOn(const IntersectingFace& edgeFace, int edge, const IntersectingFace& face, bool onBaseEdge) {
    TACTOOTH_ASSERT(edge >= 0 && edge < 3);
    int low = edge;
    int high = (edge + 1) % 3;
    if (edgeFace.id[low] > edgeFace.id[high]) std::swap(low, high);
    TACTOOTH_ASSERT(edgeFace.id[low] < edgeFace.id[high]);
    const Vec3 a = edgeFace.corner[low].cast<double>();
    const Vec3 b = edgeFace.corner[high].cast<double>();
    const Vec3 origin = face.corner[0].cast<double>();
    const Vec3 normal = (face.corner[1].cast<double>() - origin).cross(face.corner[2].cast<double>() - origin);
    const double heightA = std::abs(normal.dot(a - origin));
    const double heightB = std::abs(normal.dot(b - origin));
    const double span = heightA + heightB;
    const double along = span > 0 ? heightA / span : 0.5;
    const Vec3f lowest = face.corner[0].cwiseMin(face.corner[1]).cwiseMin(face.corner[2]);
    const Vec3f highest = face.corner[0].cwiseMax(face.corner[1]).cwiseMax(face.corner[2]);
    const Vec3 point = (a + along * (b - a)).cwiseMax(lowest.cast<double>()).cwiseMin(highest.cast<double>());
    TACTOOTH_ASSERT(point.allFinite());
    TACTOOTH_ASSERT(along >= 0 && along <= 1);
    return {point, onBaseEdge, edge, along, {edgeFace.id[low], edgeFace.id[high]}};
}

}  // namespace

std::optional<FaceIntersection> intersectionOf(const IntersectingFace& base, const IntersectingFace& wall) {
    for (int i = 0; i < 3; ++i) TACTOOTH_ASSERT(base.corner[i].allFinite() && wall.corner[i].allFinite());
    const auto sidesOf = [](const IntersectingFace& face, const IntersectingFace& other, bool faceIsWall) {
        const ExactPlane plane(face.corner[0], face.corner[1], face.corner[2]);
        std::array<int, 3> side;
        for (int i = 0; i < 3; ++i) side[i] = sideOf(face, plane, other.corner[i], faceIsWall);
        return side;
    };
    const std::array<int, 3> baseSide = sidesOf(wall, base, true);
    if (areOnOneSide(baseSide)) return std::nullopt;
    const std::array<int, 3> wallSide = sidesOf(base, wall, false);
    if (areOnOneSide(wallSide)) return std::nullopt;

    std::optional<IntersectionPoint> start;
    std::optional<IntersectionPoint> end;
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3;
        if (baseSide[i] != baseSide[next] && passesThrough(base.corner[i], base.corner[next], wall, true)) {
            // The outline of the base face leaves the kept part where it comes to the front of the wall.
            (baseSide[i] < 0 ? start : end) = pointOn(base, i, wall, true);
        }
        if (wallSide[i] != wallSide[next] && passesThrough(wall.corner[i], wall.corner[next], base, false)) {
            (wallSide[i] < 0 ? end : start) = pointOn(wall, i, base, false);
        }
    }
    if (!start || !end) return std::nullopt;
    return FaceIntersection{*start, *end};
}

}  // namespace tactooth
