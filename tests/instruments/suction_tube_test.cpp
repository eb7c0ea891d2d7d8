// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/suction_tube.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "instruments/mesh_checks.h"
#include "support/mesh_checks.h"

namespace tactooth {
namespace {

TEST(SuctionTube, IsClosedAndTurnedOutward) {
    const TriangleMesh mesh = makeSuctionTube();
    EXPECT_EQ(test::unpairedEdges(mesh), 0);
    EXPECT_GT(test::volumeOf(mesh), 1000);
    EXPECT_FALSE(test::selfIntersects(mesh));
}

TEST(SuctionTube, OpensAtTheOrigin) {
    const TriangleMesh mesh = makeSuctionTube();
    EXPECT_NEAR(boundingBox(mesh).min().z(), 0, 1e-6);
    // The bore is free for the width of the tube behind its opening.
    const double nearest = std::transform_reduce(
        mesh.vertices.begin(), mesh.vertices.end(), 100.0, [](double a, double b) { return std::min(a, b); },
        [](const Vec3f& v) { return v.z() < 6 ? double{v.head<2>().norm()} : 100.0; });
    EXPECT_GT(nearest, 2);
}

}  // namespace
}  // namespace tactooth
