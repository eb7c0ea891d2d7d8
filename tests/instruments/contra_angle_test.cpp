// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/contra_angle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "instruments/mesh_checks.h"
#include "instruments/turbine.h"
#include "support/mesh_checks.h"

namespace tactooth {
namespace {

TEST(ContraAngle, IsOneClosedBodyOfAsManyTrianglesAsAskedFor) {
    const TriangleMesh mesh = makeContraAngle(9000);
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), 9000, 10);
    EXPECT_EQ(test::unpairedEdges(mesh), 0);
    EXPECT_FALSE(test::selfIntersects(mesh));
    EXPECT_EQ(static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size() / 2), 2);
}

TEST(ContraAngle, HasASmallHeadAndAWiderHandleThanATurbine) {
    const TriangleMesh mesh = makeContraAngle(6000);
    double head = 0, handle = 0;
    for (const Vec3f& v : mesh.vertices) {
        if (v.x() < 0) head = std::max(head, static_cast<double>(std::abs(v.y())));
        if (v.x() > 60) handle = std::max(handle, static_cast<double>(std::abs(v.y())));
    }
    EXPECT_NEAR(2 * head, 9, 0.5);
    EXPECT_NEAR(2 * handle, 20, 0.5);
    EXPECT_GT(boundingBox(mesh).sizes().y(), boundingBox(makeTurbine(6000)).sizes().y());
    EXPECT_NEAR(boundingBox(mesh).min().z(), 9, 0.5);
}

TEST(Turbine, CanBeAsFineAsThePublishedOne) { EXPECT_EQ(makeTurbine(20988).triangles.size(), 20988u); }

}  // namespace
}  // namespace tactooth
