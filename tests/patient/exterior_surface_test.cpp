// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/exterior_surface.h"

#include <gtest/gtest.h>

#include <numbers>

#include "instruments/builtin_tooth.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(ExteriorSurface, WallsOfAVoidAreReported) {
    TriangleMesh mesh = test::sphere(Vec3(1, 2, 3), 6, 32, 24);
    const std::size_t outside = mesh.triangles.size();
    TriangleMesh hollow = test::sphere(Vec3(1, 2, 3), 2, 24, 16);
    for (Triangle& triangle : hollow.triangles) std::swap(triangle[0], triangle[1]);
    append(mesh, hollow);
    const ExteriorSurface exterior = exteriorSurface(SurfacePart(mesh));
    EXPECT_EQ(exterior.exterior.triangles.size(), outside);
    EXPECT_NEAR(exterior.pulpWallArea, 4 * std::numbers::pi * 4, 2);
}

TEST(ExteriorSurface, AToothIsAllOutsideFissuresToo) {
    const BuiltinTooth molar = makeTooth({.fdi = 36, .triangles = 4000, .seed = 0, .lesion = {}});
    EXPECT_LT(exteriorSurface(SurfacePart(molar.outer)).pulpWallArea, 1);
}

}  // namespace
}  // namespace tactooth
