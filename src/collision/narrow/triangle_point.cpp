// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/narrow/triangle_point.h"

#include <algorithm>

#include "geometry/util/assert.h"

// Voronoi regions of a triangle: C. Ericson, "Real-Time Collision Detection", 2005, section 5.1.5. Differs from the
// book: three segment queries handle the regions of edges and corners. They are robust for needles.

namespace tactooth {

Vec3 closestOnSegment(const Vec3& query, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double length = ab.squaredNorm();
    if (length == 0) return a;
    const double along = std::clamp((query - a).dot(ab) / length, 0.0, 1.0);
    TACTOOTH_ASSERT(along >= 0 && along <= 1);
    return a + along * ab;
}

Vec3 closestOnTriangle(const Vec3& query, const Vec3& a, const Vec3& b, const Vec3& c) {
    TACTOOTH_ASSERT(query.allFinite());
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 normal = ab.cross(ac);
    const double area = normal.squaredNorm();
    if (area > 0) {
        const Vec3 aq = query - a;
        const double v = aq.cross(ac).dot(normal) / area;
        const double w = ab.cross(aq).dot(normal) / area;
        if (v >= 0 && w >= 0 && v + w <= 1) return query - normal * (aq.dot(normal) / area);
    }
    const Vec3 candidates[] = {closestOnSegment(query, a, b), closestOnSegment(query, b, c),
                               closestOnSegment(query, c, a)};
    return *std::min_element(std::begin(candidates), std::end(candidates), [&](const Vec3& p, const Vec3& q) {
        return (p - query).squaredNorm() < (q - query).squaredNorm();
    });
}

}  // namespace tactooth
