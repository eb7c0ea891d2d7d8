// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/low_speed_handpiece.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "instruments/contra_angle.h"
#include "instruments/mesh_checks.h"
#include "instruments/turbine.h"
#include "support/mesh_checks.h"

namespace tactooth {
namespace {

/// Largest |y| of the part of a mesh between two places along x.
double halfWidth(const TriangleMesh& mesh, double from, double to) {
    double widest = 0;
    for (const Vec3f& v : mesh.vertices) {
        if (v.x() > from && v.x() < to) widest = std::max(widest, static_cast<double>(std::abs(v.y())));
    }
    return widest;
}

TEST(LowSpeedHandpiece, IsOneClosedBodyOfAsManyTrianglesAsAskedFor) {
    const TriangleMesh mesh = makeLowSpeedHandpiece(9000);
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), 9000, 10);
    EXPECT_EQ(test::unpairedEdges(mesh), 0);
    EXPECT_FALSE(test::selfIntersects(mesh));
    EXPECT_EQ(static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size() / 2), 2);
}

/// Published sizes of handpieces: a head 9 to 12 mm wide and 11 to 14 mm high.
TEST(LowSpeedHandpiece, HasAWiderHeadNeckAndMotorThanTheOtherHandpieces) {
    const TriangleMesh lowSpeed = makeLowSpeedHandpiece(6000), electric = makeContraAngle(6000);
    const TriangleMesh turbine = makeTurbine(6000);
    EXPECT_NEAR(2 * halfWidth(lowSpeed, -20, 0), 11.4, 0.4);
    EXPECT_NEAR(2 * halfWidth(lowSpeed, 60, 200), 22, 0.4);
    for (const TriangleMesh* other : {&electric, &turbine}) {
        EXPECT_GT(halfWidth(lowSpeed, -20, 0), halfWidth(*other, -20, 0) + 0.2);
        EXPECT_GT(halfWidth(lowSpeed, 10, 14), halfWidth(*other, 10, 14) + 0.5);
        EXPECT_GT(halfWidth(lowSpeed, 60, 200), halfWidth(*other, 60, 200) + 0.5);
    }
}

TEST(LowSpeedHandpiece, TheHeadSurroundsTheShaftAndTheLatchStandsOverItsEdge) {
    const TriangleMesh mesh = makeLowSpeedHandpiece(6000);
    EXPECT_NEAR(boundingBox(mesh).min().z(), 9, 0.5);
    double top = 0, back = 0;
    for (const Vec3f& v : mesh.vertices) {
        if (v.x() > 5) continue;
        top = std::max(top, static_cast<double>(v.z()));
        back = std::min(back, static_cast<double>(v.x()));
    }
    EXPECT_NEAR(top, 24.1, 0.4);
    EXPECT_LT(back, -5.95);
}

}  // namespace
}  // namespace tactooth
