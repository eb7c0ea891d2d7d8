// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/narrow/minkowski_simplex.h"

#include <cmath>
#include <limits>

#include "geometry/util/assert.h"

// Sub-simplices are tried from the largest to the smallest, each by its own barycentric coordinates, much like the
// signed volumes of M. Montanari, N. Petrinic, E. Barbieri, "Improving the GJK Algorithm for Faster and More
// Reliable Distance Queries Between Convex Objects", ACM Trans. Graphics 36(3), 2017. Differs from the paper: if the
// sign of a coordinate is uncertain (a sliver), every smaller sub-simplex is tried and the nearest wins.

namespace tactooth {
namespace {

constexpr double kFlat = 1e-12;  // sine-like measure below which a triangle or tetrahedron is taken as degenerate

/// A candidate: up to three corners with weights.
struct Nearest {
    double squared = std::numeric_limits<double>::infinity();
    Vec3 point = Vec3::Zero();
    int size = 0;
    std::array<int, 3> corner{};
    std::array<double, 3> weight{};
};

using Corners = std::array<Vec3, 4>;

void keepNearer(Nearest& best, const Nearest& candidate) {
    if (candidate.squared < best.squared) best = candidate;
}

Nearest onCorner(const Corners& p, int i) { return {p[i].squaredNorm(), p[i], 1, {i, 0, 0}, {1, 0, 0}}; }

Nearest onEdge(const Corners& p, int i, int j) {
    const Vec3 edge = p[j] - p[i];
    const double length = edge.squaredNorm();
    const double along = length > 0 ? -p[i].dot(edge) / length : 0;
    if (along <= 0) return onCorner(p, i);
    if (along >= 1) return onCorner(p, j);
    const Vec3 point = p[i] + along * edge;
    return {point.squaredNorm(), point, 2, {i, j, 0}, {1 - along, along, 0}};
}

Nearest onFace(const Corners& p, int i, int j, int k) {
    const Vec3 ij = p[j] - p[i];
    const Vec3 ik = p[k] - p[i];
    const Vec3 normal = ij.cross(ik);
    const double area = normal.squaredNorm();
    if (area > kFlat * kFlat * ij.squaredNorm() * ik.squaredNorm()) {
        const double v = -p[i].cross(ik).dot(normal) / area;
        const double w = -ij.cross(p[i]).dot(normal) / area;
        if (v > 0 && w > 0 && v + w < 1) {
            const Vec3 point = normal * (p[i].dot(normal) / area);
            return {point.squaredNorm(), point, 3, {i, j, k}, {1 - v - w, v, w}};
        }
    }
    Nearest best = onEdge(p, i, j);
    keepNearer(best, onEdge(p, j, k));
    keepNearer(best, onEdge(p, k, i));
    return best;
}

/// Whether the origin lies strictly beyond the face (i, j, k), seen from corner `opposite`; also true if the
/// tetrahedron is too flat to tell.
bool isBeyond(const Corners& p, int i, int j, int k, int opposite) {
    const Vec3 normal = (p[j] - p[i]).cross(p[k] - p[i]);
    const double inner = normal.dot(p[opposite] - p[i]);
    const double origin = -normal.dot(p[i]);
    const bool flat = std::abs(inner) <= kFlat * normal.norm() * (p[opposite] - p[i]).norm();
    return flat || (inner > 0 ? origin < 0 : origin > 0);
}

/// The nearest point on the surface of the tetrahedron, or a size of 0 if the origin is inside.
Nearest onTetrahedron(const Corners& p) {
    constexpr int kFaces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
    Nearest best;
    for (const auto& [i, j, k, opposite] : kFaces) {
        if (isBeyond(p, i, j, k, opposite)) keepNearer(best, onFace(p, i, j, k));
    }
    return best;
}

}  // namespace

bool MinkowskiSimplex::holds(const MinkowskiPoint& other) const {
    for (int i = 0; i < size_; ++i) {
        if (points_[i].onA == other.onA && points_[i].onB == other.onB) return true;
    }
    return false;
}

Vec3 MinkowskiSimplex::nearestToOrigin() {
    TACTOOTH_ASSERT(size_ >= 1 && size_ <= 4);
    const Corners p = {points_[0].point, points_[1].point, points_[2].point, points_[3].point};
    Nearest best;
    switch (size_) {
        case 1:
            best = onCorner(p, 0);
            break;
        case 2:
            best = onEdge(p, 0, 1);
            break;
        case 3:
            best = onFace(p, 0, 1, 2);
            break;
        default:
            best = onTetrahedron(p);
            break;
    }
    if (best.size == 0) return Vec3::Zero();
    TACTOOTH_ASSERT(best.size <= size_);
    const std::array<MinkowskiPoint, 4> old = points_;
    for (int i = 0; i < best.size; ++i) {
        points_[i] = old[best.corner[i]];
        weights_[i] = best.weight[i];
    }
    size_ = best.size;
    return best.point;
}

}  // namespace tactooth
