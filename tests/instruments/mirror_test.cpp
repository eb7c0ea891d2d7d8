// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mirror.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "instruments/mesh_checks.h"
#include "support/mesh_checks.h"

namespace tactooth {
namespace {

TEST(Mirror, IsClosedAndItsPartsDoNotIntersect) {
    for (const double diameter : {18.0, 22.0, 24.0}) {
        const DentalMirror mirror = makeMirror(diameter);
        EXPECT_EQ(test::unpairedEdges(mirror.surface), 0);
        EXPECT_GT(test::volumeOf(mirror.surface), 1000);
        EXPECT_FALSE(test::selfIntersects(mirror.surface));
    }
}

TEST(Mirror, HeadHasItsDiameter) {
    for (const double diameter : {18.0, 22.0, 24.0}) {
        const Box3 box = boundingBox(makeMirror(diameter).surface);
        EXPECT_NEAR(box.sizes().y(), diameter, 1e-5);
        EXPECT_NEAR(box.min().x(), -diameter / 2, 1e-5);
        EXPECT_DOUBLE_EQ(mirrorHeadOf(makeMirror(diameter).disc.radius), diameter);
    }
}

TEST(Mirror, GlassIsTheDisc) {
    const DentalMirror mirror = makeMirror();
    ASSERT_LT(mirror.glassBegin, mirror.surface.triangles.size());
    double area = 0, farthest = 0;
    for (std::size_t i = mirror.glassBegin; i < mirror.surface.triangles.size(); ++i) {
        const Vec3 areaVector = mirror.surface.areaVector(i);
        for (int corner = 0; corner < 3; ++corner) {
            farthest = std::max(farthest,
                                std::hypot(mirror.surface.corner(i, corner).x(), mirror.surface.corner(i, corner).y()));
        }
        if (areaVector.normalized().dot(mirror.disc.normal) < 0.999) continue;
        area += areaVector.norm() / 2;
        for (int corner = 0; corner < 3; ++corner) {
            EXPECT_NEAR((mirror.surface.corner(i, corner) - mirror.disc.centre).dot(mirror.disc.normal), 0, 1e-6);
        }
    }
    EXPECT_NEAR(area, std::numbers::pi * mirror.disc.radius * mirror.disc.radius, 0.005 * area);
    EXPECT_NEAR(farthest, mirror.disc.radius, 1e-5);
}

TEST(Mirror, HandleLeavesAtFortyFiveDegreesBehindTheGlass) {
    const DentalMirror mirror = makeMirror();
    Vec3 end = Vec3::Zero();
    for (const Vec3f& v : mirror.surface.vertices) {
        if (v.x() > end.x()) end = v.cast<double>();
    }
    EXPECT_GT(end.norm(), 140);
    EXPECT_NEAR(std::atan2(-end.z(), end.x() - 11) * 180 / std::numbers::pi, 45, 3);
}

}  // namespace
}  // namespace tactooth
