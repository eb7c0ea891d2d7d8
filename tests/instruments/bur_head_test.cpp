// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/bur_head.h"

#include <gtest/gtest.h>

#include "instruments/bur_shape.h"

namespace tactooth {
namespace {

TEST(BurHead, IsFoundOnEveryBurOfTheCatalogueAtEveryResolution) {
    constexpr double kLastBlade = 0.35;  // mm: blades fade out at the end of the head
    for (const BurSpec& spec : burCatalogue()) {
        for (const int triangles : {kContactBurTriangles, 6000}) {
            const BurHead head = burHeadOf(makeBur(spec, triangles).surface);
            EXPECT_NEAR(head.length, spec.headLength, kLastBlade) << spec.name << ", " << triangles;
            EXPECT_NEAR(head.radius, spec.headDiameter / 2, 0.03) << spec.name << ", " << triangles;
        }
    }
}

TEST(BurHead, OfAConeWithoutANeckEndsWhereTheShankBegins) {
    TriangleMesh cone;
    cone.vertices.emplace_back(0.F, 0.F, 0.F);
    for (const float z : {4.F, 12.F}) {
        for (const float side : {-1.F, 1.F}) {
            cone.vertices.emplace_back(0.8F * side, 0.F, z);
            cone.vertices.emplace_back(0.F, 0.8F * side, z);
        }
    }
    const BurHead head = burHeadOf(cone);
    EXPECT_NEAR(head.length, 4, 1e-6);
    EXPECT_NEAR(head.radius, 0.8, 1e-6);
}

TEST(BurHead, ItsCapIsADiscAsWideAsTheNeckThatFacesTheShank) {
    const BurHead head = burHeadOf(makeBur(*findBur("4")).surface);
    EXPECT_LT(head.neck, head.radius);
    const TriangleMesh cap = headCap(head);
    ASSERT_FALSE(cap.triangles.empty());
    double area = 0;
    for (const auto& triangle : cap.triangles) {
        const Vec3 a = cap.vertices[triangle[0]].cast<double>(), b = cap.vertices[triangle[1]].cast<double>(),
                   c = cap.vertices[triangle[2]].cast<double>();
        EXPECT_NEAR(a.z(), head.length, 1e-5);
        EXPECT_GT((b - a).cross(c - a).z(), 0);
        area += 0.5 * (b - a).cross(c - a).norm();
    }
    EXPECT_NEAR(area, 3.14159 * head.neck * head.neck, 0.03 * area);
    EXPECT_TRUE(headCap({}).triangles.empty());
}

TEST(BurHead, OfNothingIsUnknown) { EXPECT_EQ(burHeadOf({}).length, 0); }

}  // namespace
}  // namespace tactooth
