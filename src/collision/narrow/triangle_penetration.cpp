// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/narrow/triangle_penetration.h"

#include <limits>

#include "geometry/util/assert.h"
#include "geometry/util/pose.h"

// Expanding polytope: G. van den Bergen, "Proximity Queries and Penetration Depth Computation on 3D Game Objects", GDC
// 2001. The depth is the distance of the origin from the boundary of the Minkowski difference of the two sets. Differs
// from the paper: the difference of two triangles has few faces (two from the triangles' own planes, nine from pairs of
// edges, each with its opposite). So all of them are tested instead of being found by expansion: the result is exact,
// and the work is the same for every pair.

namespace tactooth {
namespace {

void keepShallower(const Triangle3& a, const Triangle3& b, const Vec3& axis, TrianglePenetration& best) {
    const double length = axis.norm();
    if (!(length > 0)) return;  // parallel edges span no face
    const Vec3 unit = axis / length;
    for (const Vec3& normal : {unit, Vec3(-unit)}) {
        const double depth = highestAlong(a, normal) - lowestAlong(b, normal);
        if (depth < best.depth) best = {depth, normal};
    }
}

}  // namespace

TrianglePenetration penetrationOf(const Triangle3& a, const Triangle3& b) {
    TACTOOTH_ASSERT(a[0].allFinite() && b[0].allFinite());
    TrianglePenetration best{std::numeric_limits<double>::infinity(), Vec3::Zero()};
    keepShallower(a, b, (a[1] - a[0]).cross(a[2] - a[0]), best);
    keepShallower(a, b, (b[1] - b[0]).cross(b[2] - b[0]), best);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            keepShallower(a, b, (a[(i + 1) % 3] - a[i]).cross(b[(j + 1) % 3] - b[j]), best);
        }
    }
    TACTOOTH_ASSERT(best.depth == std::numeric_limits<double>::infinity() || isUnit(best.normal));
    return best;
}

}  // namespace tactooth
