// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh/mesh_extent.h"
#include "geometry/util/messages.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace tactooth {
namespace {

TEST(MeshExtent, AToothInAnyUnitIsNear) {
    for (const double size : {1e-6, 1.0, 20.0, 2e4, 1e6}) {
        EXPECT_TRUE(checkExtent(test::box(Vec3::Constant(-size), Vec3::Constant(size)), msg::kTheSurface)) << size;
    }
}

TEST(MeshExtent, AStrayCornerIsSaidWithItsDistance) {
    for (const double far : {1.1e6, 1e8, 1e20, 3e38}) {
        for (int axis = 0; axis < 6; ++axis) {
            TriangleMesh mesh = test::box(Vec3::Constant(-1), Vec3::Constant(1));
            mesh.vertices[3][axis % 3] = static_cast<float>(axis < 3 ? far : -far);
            const auto reach = checkExtent(mesh, {msg::kSurfaceOf, "the tooth"});
            ASSERT_FALSE(reach) << far;
            EXPECT_TRUE(reach.error().message().starts_with("the surface of the tooth reaches "))
                << reach.error().message();
        }
    }
    EXPECT_EQ(checkExtent(test::box(Vec3(0, 0, 0), Vec3(1, 2e6, 1)), msg::kTheSurface).error().message(),
              "the surface reaches 2e+06 mm from its origin, farther than anything can be felt or cut (1 km): look for "
              "a stray corner, or check the unit");
}

}  // namespace
}  // namespace tactooth
