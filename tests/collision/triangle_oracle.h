// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/narrow/triangle3.h"
#include "collision/narrow/triangle_point.h"

namespace tactooth::test {

/// Distance of two segments, from the clamped closed form of the two lines and from the four ends.
inline double segmentDistance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    double best = std::min({(closestOnSegment(a, c, d) - a).norm(), (closestOnSegment(b, c, d) - b).norm(),
                            (closestOnSegment(c, a, b) - c).norm(), (closestOnSegment(d, a, b) - d).norm()});
    const Vec3 u = b - a;
    const Vec3 v = d - c;
    const Vec3 w = a - c;
    const double determinant = u.dot(u) * v.dot(v) - u.dot(v) * u.dot(v);
    if (determinant > 0) {
        const double s = (u.dot(v) * v.dot(w) - v.dot(v) * u.dot(w)) / determinant;
        const double t = (u.dot(u) * v.dot(w) - u.dot(v) * u.dot(w)) / determinant;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) best = std::min(best, (a + s * u - c - t * v).norm());
    }
    return best;
}

/// Whether the segment crosses the triangle, borders included.
inline bool segmentCrosses(const Vec3& from, const Vec3& to, const Triangle3& t) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double start = normal.dot(from - t[0]);
    const double end = normal.dot(to - t[0]);
    if (start * end > 0 || start == end) return false;
    const Vec3 point = from + start / (start - end) * (to - from);
    return (closestOnTriangle(point, t[0], t[1], t[2]) - point).norm() < 1e-13 * (1 + point.norm());
}

/// Distance of two triangles, by brute force over all pairs of features; 0 if they cross.
inline double triangleDistance(const Triangle3& a, const Triangle3& b) {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        best = std::min(best, (closestOnTriangle(a[i], b[0], b[1], b[2]) - a[i]).norm());
        best = std::min(best, (closestOnTriangle(b[i], a[0], a[1], a[2]) - b[i]).norm());
        if (segmentCrosses(a[i], a[(i + 1) % 3], b) || segmentCrosses(b[i], b[(i + 1) % 3], a)) return 0;
        for (int j = 0; j < 3; ++j) {
            best = std::min(best, segmentDistance(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
        }
    }
    return best;
}

}  // namespace tactooth::test
