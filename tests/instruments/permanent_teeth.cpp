// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/permanent_teeth.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "collision/bvh/closest_point.h"
#include "geometry/mesh/mesh_report.h"
#include "instruments/mesh_checks.h"

namespace tactooth::test {
namespace {

constexpr double kLeast = 0.05;  // mm between two layers

/// The smallest depth of a vertex of `inner` above `from` below the surface of `outer`.
double leastDepth(const TriangleMesh& inner, const TriangleMesh& outer, double from) {
    const SurfacePart part(outer);
    double least = 1e9;
    for (const Vec3f& vertex : inner.vertices) {
        if (vertex.z() < from) continue;
        const Vec3 point = vertex.cast<double>();
        const auto near = closestPoint(part, point, least);
        if (near) least = near->distance;
        if (!contains(part, point)) return -1;
    }
    return least;
}

}  // namespace

void expectValidLayers(const BuiltinTooth& tooth) {
    for (const TriangleMesh* layer : {&tooth.outer, &tooth.enamel, &tooth.dentin, &tooth.pulp}) {
        const MeshReport report = reportOn(*layer);
        EXPECT_TRUE(report.watertight()) << tooth.fdi;
        EXPECT_GT(report.signedVolume, 0) << tooth.fdi;
        EXPECT_EQ(report.shells.size(), 1u) << tooth.fdi;
        EXPECT_FALSE(selfIntersects(*layer)) << tooth.fdi;
    }
}

void expectNestedLayers(const BuiltinTooth& tooth) {
    EXPECT_GE(leastDepth(tooth.pulp, tooth.dentin, -1e9), kLeast) << tooth.fdi;
    // Above the highest point of the cervical line and its feather edge, the dentin is covered all around.
    constexpr double kCovered = 4.6;  // mm
    EXPECT_GE(leastDepth(tooth.dentin, tooth.outer, kCovered), kLeast) << tooth.fdi;
}

}  // namespace tactooth::test
