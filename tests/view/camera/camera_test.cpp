// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/camera/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tactooth {
namespace {

constexpr ImageSize kSize{640, 400};

Camera tiltedCamera() {
    return {.cameraInWorld = {Vec3(3, -40, 12), Quat(Eigen::AngleAxisd(1.3, Vec3(1, 0.2, -0.1).normalized()))}};
}

Vec3 clipPosition(const Camera& camera, const Vec3& point) {
    const Eigen::Vector4d clip =
        projectionMatrix(camera, kSize.aspect()) * viewMatrix(camera) * Eigen::Vector4d(point.homogeneous());
    return clip.hnormalized();
}

TEST(Camera, CentreOfPictureLooksAlongMinusZ) {
    const Camera camera = tiltedCamera();
    const Ray ray = rayThrough(camera, kSize, Vec2(320, 200));
    EXPECT_LT((ray.direction - camera.cameraInWorld.rotation * Vec3(0, 0, -1)).norm(), 1e-12);
    EXPECT_LT((ray.origin - camera.cameraInWorld.position - camera.nearDistance * ray.direction).norm(), 1e-12);
}

TEST(Camera, ARayBeginsAtTheNearPlaneWhereThePictureBegins) {
    Camera camera = tiltedCamera();
    camera.nearDistance = 2.5;
    for (const Vec2& pixel : {Vec2(0, 0), Vec2(620, 30), Vec2(320, 399)}) {
        const Ray ray = rayThrough(camera, kSize, pixel);
        EXPECT_NEAR(clipPosition(camera, ray.origin).z(), -1, 1e-9);
        EXPECT_LT((*project(camera, kSize, ray.origin) - pixel).norm(), 1e-9);
    }
}

TEST(Camera, RightOfPictureIsPlusXAndTopIsPlusY) {
    const Camera camera;
    EXPECT_GT(rayThrough(camera, kSize, Vec2(600, 200)).direction.x(), 0);
    EXPECT_GT(rayThrough(camera, kSize, Vec2(320, 10)).direction.y(), 0);
}

TEST(Camera, ProjectUndoesRayThrough) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    const Camera camera = tiltedCamera();
    for (int i = 0; i < 1000; ++i) {
        const Vec2 pixel(640 * unit(random), 400 * unit(random));
        const Ray ray = rayThrough(camera, kSize, pixel);
        const auto back = project(camera, kSize, ray.origin + (1 + 50 * unit(random)) * ray.direction);
        ASSERT_TRUE(back);
        EXPECT_LT((*back - pixel).norm(), 1e-9);
    }
}

TEST(Camera, ProjectRefusesPointsBehindTheEye) {
    EXPECT_FALSE(project(Camera{}, kSize, Vec3(0, 0, 1)));
    EXPECT_FALSE(project(Camera{}, kSize, Vec3(0, 0, 0)));
}

TEST(Camera, MatricesAgreeWithProject) {
    const Camera camera = tiltedCamera();
    const Vec3 point = rayThrough(camera, kSize, Vec2(100, 300)).direction * 30 + camera.cameraInWorld.position;
    const Vec3 clip = clipPosition(camera, point);
    EXPECT_NEAR((clip.x() + 1) / 2 * kSize.width, 100, 1e-9);
    EXPECT_NEAR((1 - clip.y()) / 2 * kSize.height, 300, 1e-9);
}

TEST(Camera, NearAndFarMapToTheEndsOfTheDepthRange) {
    Camera camera;
    camera.nearDistance = 2;
    camera.farDistance = 300;
    EXPECT_NEAR(clipPosition(camera, Vec3(0, 0, -2)).z(), -1, 1e-12);
    EXPECT_NEAR(clipPosition(camera, Vec3(0, 0, -300)).z(), 1, 1e-12);
}

TEST(Camera, ReflectionKeepsThePlaneAndIsItsOwnInverse) {
    const Plane plane{Vec3(1, 2, -2).normalized(), 4.5};
    const Mat4 reflection = reflectionMatrix(plane);
    EXPECT_LT((reflection * reflection - Mat4::Identity()).norm(), 1e-12);
    const Vec3 onPlane = 4.5 * plane.normal + plane.normal.unitOrthogonal() * 7;
    EXPECT_LT(((reflection * onPlane.homogeneous()).head<3>() - onPlane).norm(), 1e-12);
    const Vec3 point(3, 4, 5);
    const Vec3 image = (reflection * point.homogeneous()).head<3>();
    EXPECT_NEAR(plane.signedDistance(image), -plane.signedDistance(point), 1e-12);
}

}  // namespace
}  // namespace tactooth
