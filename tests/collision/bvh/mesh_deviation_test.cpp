// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/bvh/mesh_deviation.h"

#include <gtest/gtest.h>

#include <numbers>

#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(MeshDeviation, SurfacesThatAreTheSameAreNotApart) {
    const TriangleMesh ball = test::sphere(Vec3(1, 2, 3), 5, 24, 12);
    EXPECT_LT(hausdorffDistance(ball, ball), 1e-6);
    EXPECT_EQ(maxVertexDistance(ball, ball), 0);
}

TEST(MeshDeviation, SeesBothSurfaces) {
    const TriangleMesh box = test::box(Vec3::Zero(), Vec3(4, 4, 4));
    TriangleMesh withAnotherBox = box;
    append(withAnotherBox, test::box(Vec3(7, 0, 0), Vec3(8, 4, 4)));
    EXPECT_NEAR(hausdorffDistance(box, withAnotherBox), 4, 1e-6);
    EXPECT_NEAR(hausdorffDistance(withAnotherBox, box), 4, 1e-6);
    EXPECT_EQ(maxVertexDistance(box, withAnotherBox), 0);
    EXPECT_NEAR(maxVertexDistance(withAnotherBox, box), 4, 1e-6);
}

TEST(MeshDeviation, SeesTheSagBetweenVertices) {
    // Two cylinders, the coarse one inscribed in the fine one: its sides sag by r (1 - cos(pi / sectors)).
    const TriangleMesh coarse = test::cylinder(Vec3::Zero(), 3, 5, 12);
    const TriangleMesh fine = test::cylinder(Vec3::Zero(), 3, 5, 240);
    EXPECT_NEAR(hausdorffDistance(coarse, fine), 3 * (1 - std::cos(std::numbers::pi / 12)), 1e-3);
}

}  // namespace
}  // namespace tactooth
