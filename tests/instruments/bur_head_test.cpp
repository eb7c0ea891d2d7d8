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

TEST(BurHead, OfNothingIsUnknown) { EXPECT_EQ(burHeadOf({}).length, 0); }

}  // namespace
}  // namespace tactooth
