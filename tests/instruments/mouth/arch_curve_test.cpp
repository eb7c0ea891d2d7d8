// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "instruments/mouth/arch_curve.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

TEST(ArchCurve, PassesTheLowerCanineAndFirstMolarOfAnAverageMouth) {
    const ArchCurve line;
    EXPECT_NEAR(line.depth(13), 5.5, 0.1);
    EXPECT_NEAR(line.depth(23), 22, 0.1);
    EXPECT_NEAR(line.halfWidth(22), 23, 0.1);
}

TEST(ArchCurve, PlacesAreAsFarAlongTheLineAsTheirLengthSays) {
    const ArchCurve line;
    double walked = 0;
    Vec3 last = line.at(0).point;
    for (double s = 0.05; s <= 60.001; s += 0.05) {
        const Vec3 point = line.at(s).point;
        walked += (point - last).norm();
        last = point;
        ASSERT_NEAR(walked, s, 0.01);
    }
}

TEST(ArchCurve, DirectionsAreSquareAndTheSidesAreMirrorImages) {
    const ArchCurve line(1.05);
    for (const double s : {1.0, 12.0, 25.0, 58.0}) {
        const ArchCurve::Place right = line.at(s), left = line.at(-s);
        EXPECT_NEAR(right.along.dot(right.outward), 0, 1e-12);
        EXPECT_NEAR(right.outward.norm(), 1, 1e-12);
        EXPECT_GT(right.outward.dot(right.point - Vec3(0, -25, 0)), 0);
        EXPECT_NEAR(left.point.x(), -right.point.x(), 1e-9);
        EXPECT_NEAR(left.outward.y(), right.outward.y(), 1e-9);
    }
}

TEST(ArchCurve, CoordinatesFindThePlaceAgain) {
    const ArchCurve line;
    for (const double s : {-55.0, -31.0, -8.0, 3.0, 19.0, 44.0}) {
        for (const double outward : {-4.0, -1.0, 0.0, 2.5, 6.0}) {
            const ArchCurve::Place place = line.at(s);
            const Vec3 point = place.point + outward * place.outward;
            const ArchCurve::Coordinates found = line.of(point.x(), point.y());
            EXPECT_NEAR(found.s, s, 0.02);
            EXPECT_NEAR(found.outward, outward, 0.02);
        }
    }
}

TEST(ArchCurve, TheOcclusalSurfaceIsLowestAtThePremolarsAndRisesBackward) {
    EXPECT_NEAR(occlusalPlane(0), 0, 1e-12);
    EXPECT_LT(occlusalPlane(18), occlusalPlane(10));
    EXPECT_LT(occlusalPlane(18), occlusalPlane(30));
    EXPECT_GT(occlusalPlane(45), 1);
}

}  // namespace
}  // namespace tactooth
