// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mouth_checks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision/bvh/closest_point.h"
#include "geometry/mesh/mesh_report.h"
#include "instruments/mesh_checks.h"

namespace tactooth::test {
namespace {

/// Smallest distance of a vertex of `a` from `b`, negative if one is inside.
double clearance(const TriangleMesh& a, const TriangleMesh& b) {
    const SurfacePart part(b);
    constexpr double kFar = 1.0;
    Box3 near = part.tree().box();
    near.min().array() -= kFar;
    near.max().array() += kFar;
    double least = kFar;
    for (const Vec3f& v : a.vertices) {
        const Vec3 point = v.cast<double>();
        if (!near.contains(point)) continue;
        const auto found = closestPoint(part, point, kFar);
        if (!found) continue;
        least = std::min(least, contains(part, point) ? -found->distance : found->distance);
    }
    return least;
}

}  // namespace

TriangleMesh placed(const BuiltinMouth& in, int fdi) {
    const MouthTooth* tooth = in.find(fdi);
    return transformed(tooth->tooth.outer, in.poseOf(*tooth));
}

double between(const TriangleMesh& a, const TriangleMesh& b) { return std::min(clearance(a, b), clearance(b, a)); }

void expectValidGingivae(const MouthLayout& layout) {
    for (const TriangleMesh* gum : {&layout.upperGingiva, &layout.lowerGingiva}) {
        SCOPED_TRACE(gum == &layout.upperGingiva ? "upper gum" : "lower gum");
        const MeshReport report = reportOn(*gum);
        EXPECT_TRUE(report.watertight());
        EXPECT_EQ(report.shells.size(), 1u);
        EXPECT_GT(report.signedVolume, 10000);
        EXPECT_FALSE(selfIntersects(*gum));
    }
}

}  // namespace tactooth::test
