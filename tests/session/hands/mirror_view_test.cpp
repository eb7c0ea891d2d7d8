// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/mirror_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "hands/pinhole.h"
#include "support/shapes.h"

namespace tactooth {
namespace {

Surface boxSurface(const Vec3& low, const Vec3& high) {
    Surface surface;
    surface.base = std::make_shared<const SurfacePart>(test::box(low, high));
    return surface;
}

Vec3 randomVec(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double x = uniform(random), y = uniform(random);
    return {x, y, uniform(random)};
}

/// Turned halfway between the eye and a place, and a little aside.
MirrorDisc glassThatShows(const Vec3& place, const Vec3& centre, const test::Pinhole& picture, std::mt19937& random) {
    const Vec3 normal = ((place - centre).normalized() + (picture.eye() - centre).normalized()).normalized();
    return {centre, (normal + 0.1 * randomVec(random)).normalized(), 10};
}

TEST(MirrorView, ReflectsARightAngleAtAGlassOfFortyFiveDegrees) {
    const test::Pinhole picture({0, 0});  // from +x
    const MirrorDisc glass{Vec3(-10, 0, 0), Vec3(1, 1, 0).normalized(), 10};
    const Ray ray = MirrorView(picture, glass).rayThrough(Vec2(500, 400));
    EXPECT_LT((ray.origin - Vec3(-10, 0, 0)).norm(), 1e-12);
    EXPECT_LT((ray.direction - Vec3(0, 1, 0)).norm(), 1e-12);
}

TEST(MirrorView, LeavesTheGlassInThePlaneOfTheNormalUnderTheAngleAtWhichItCame) {
    std::mt19937 random(1);
    const test::Pinhole picture;
    for (int i = 0; i < 100; ++i) {
        const MirrorDisc glass =
            glassThatShows(3 * randomVec(random), Vec3(0, -15, 3) + 3 * randomVec(random), picture, random);
        const Vec2 pixel = picture.pixelOf(glass.centre) + 40 * randomVec(random).head<2>();
        const Ray in = picture.rayThrough(pixel), out = MirrorView(picture, glass).rayThrough(pixel);
        EXPECT_NEAR((out.origin - glass.centre).dot(glass.normal), 0, 1e-10);
        EXPECT_LT((out.origin - in.origin).cross(in.direction).norm(), 1e-9);
        EXPECT_NEAR(out.direction.dot(glass.normal), -in.direction.dot(glass.normal), 1e-12);
        EXPECT_NEAR(out.direction.dot(in.direction.cross(glass.normal)), 0, 1e-12);
        EXPECT_NEAR(out.direction.norm(), 1, 1e-12);
        // Every place on the way has its image on the straight line of sight.
        const Vec3 image = mirrorImage(glass, out.origin + 7 * out.direction);
        EXPECT_LT((image - in.origin).cross(in.direction).norm(), 1e-9);
    }
}

TEST(MirrorView, ItsAxesAreThoseOfThePictureReflectedAndLeftHanded) {
    std::mt19937 random(2);
    const test::Pinhole picture;
    const MirrorDisc glass = glassThatShows(Vec3::Zero(), Vec3(0, -15, 3), picture, random);
    const Mat3 axes = MirrorView(picture, glass).eyeAxes();
    EXPECT_NEAR(axes.determinant(), -1, 1e-12);
    // A place that moves along them has an image that moves to the right, and up, in the picture.
    const Vec3 place(0, 0, 3);
    const auto pixelOf = [&](const Vec3& at) { return picture.pixelOf(mirrorImage(glass, at)); };
    const Vec2 right = pixelOf(place + 1e-4 * axes.col(0)) - pixelOf(place);
    const Vec2 up = pixelOf(place + 1e-4 * axes.col(1)) - pixelOf(place);
    EXPECT_GT(right.x(), 0);
    EXPECT_NEAR(right.y() / right.x(), 0, 1e-3);
    EXPECT_LT(up.y(), 0);
    EXPECT_NEAR(up.x() / up.y(), 0, 1e-3);
}

TEST(MirrorView, TheGlassEndsAtItsRadius) {
    const test::Pinhole picture({0, 0});
    const MirrorDisc glass{Vec3::Zero(), Vec3::UnitX(), 5};
    const Surface nothingNear = boxSurface(Vec3(90, 90, 90), Vec3(91, 91, 91));
    for (int i = 0; i < 36; ++i) {
        const double angle = std::numbers::pi / 18 * i;
        const Vec3 edge(0, std::cos(angle), std::sin(angle));
        EXPECT_TRUE(showsGlass(picture, picture.pixelOf(4.99 * edge), glass, nothingNear)) << i;
        EXPECT_FALSE(showsGlass(picture, picture.pixelOf(5.01 * edge), glass, nothingNear)) << i;
    }
}

TEST(MirrorView, ShowsNothingFromBehindNorWhereAToothIsBeforeIt) {
    const test::Pinhole picture({0, 0});
    const Surface before = boxSurface(Vec3(3, -2, -2), Vec3(4, 0, 2));
    const Surface behind = boxSurface(Vec3(-4, -2, -2), Vec3(-3, 0, 2));
    const MirrorDisc glass{Vec3::Zero(), Vec3::UnitX(), 5};
    const Vec2 left = picture.pixelOf(Vec3(0, -1, 0)), right = picture.pixelOf(Vec3(0, 1, 0));
    EXPECT_FALSE(showsGlass(picture, left, glass, before));
    EXPECT_TRUE(showsGlass(picture, right, glass, before));
    EXPECT_TRUE(showsGlass(picture, left, glass, behind));
    EXPECT_FALSE(showsGlass(picture, right, {Vec3::Zero(), -Vec3::UnitX(), 5}, before));
}

TEST(MirrorView, APlaceBehindSomethingIsNotSeenInTheMirror) {
    const test::Pinhole picture({0, 0});
    const MirrorDisc glass{Vec3(-10, 0, 0), Vec3(1, 1, 0).normalized(), 10};  // shows what is at +y of it
    const Surface wall = boxSurface(Vec3(-12, 8, -3), Vec3(-8, 9, 3));
    const auto seen = [&](const Vec3& place) {
        return isSeenInMirror(picture, picture.pixelOf(mirrorImage(glass, place)), glass, place, wall);
    };
    EXPECT_TRUE(seen(Vec3(-10, 8, 0))) << "on the wall";
    EXPECT_TRUE(seen(Vec3(-10, 5, 0)));
    EXPECT_FALSE(seen(Vec3(-10, 12, 0)));
}

}  // namespace
}  // namespace tactooth
