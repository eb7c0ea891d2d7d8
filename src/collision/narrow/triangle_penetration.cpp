// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/narrow/triangle_penetration.h"

#include <limits>

// Expanding polytope: G. van den Bergen, "Proximity Queries and Penetration Depth Computation on 3D Game Objects", GDC
// 2001. The depth is the distance of the origin from the border of the difference of the two sets. Differs from the
// paper: the difference of two triangles has so few faces (two from the triangles' own planes, nine from pairs of
// edges, each with its opposite) that all of them are looked at instead of being found by expansion: the answer is
// exact and the work the same for every pair.

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
    TrianglePenetration best{std::numeric_limits<double>::infinity(), Vec3::Zero()};
    keepShallower(a, b, (a[1] - a[0]).cross(a[2] - a[0]), best);
    keepShallower(a, b, (b[1] - b[0]).cross(b[2] - b[0]), best);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            keepShallower(a, b, (a[(i + 1) % 3] - a[i]).cross(b[(j + 1) % 3] - b[j]), best);
        }
    }
    return best;
}

}  // namespace tactooth
