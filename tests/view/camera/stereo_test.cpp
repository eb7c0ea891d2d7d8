// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/camera/stereo.h"

#include <gtest/gtest.h>

namespace tactooth {
namespace {

constexpr ImageSize kSize{640, 400};

TEST(Stereo, WhatLiesAtTheFocusStandsAtTheSamePixelForBothEyes) {
    const Stereo stereo{Stereo::Mode::SideBySide, 50, 2};
    const auto [left, right] = stereoCameras(Camera(), stereo);
    for (const Vec3& point : {Vec3(0, 0, -50), Vec3(3, -2, -50)}) {
        const auto inLeft = project(left, kSize, point);
        const auto inRight = project(right, kSize, point);
        ASSERT_TRUE(inLeft && inRight);
        EXPECT_NEAR((*inLeft - *inRight).norm(), 0, 1e-9);
        EXPECT_NEAR((*inLeft - *project(Camera(), kSize, point)).norm(), 0, 1e-9);
    }
}

TEST(Stereo, WhatIsNearerStandsFartherRightForTheLeftEyeAndNothingMovesUpOrDown) {
    const auto [left, right] = stereoCameras(Camera(), {Stereo::Mode::SideBySide, 50, 2});
    const Vec3 near(1, 1, -40);
    const Vec2 inLeft = *project(left, kSize, near);
    const Vec2 inRight = *project(right, kSize, near);
    EXPECT_GT(inLeft.x(), inRight.x() + 1);
    EXPECT_NEAR(inLeft.y(), inRight.y(), 1e-9);
}

TEST(Stereo, RayAndMatrixAgreeWithTheProjectionOfAShiftedLens) {
    Camera camera;
    camera.lensShift = 0.3;
    const Vec3 point(2, -1, -30);
    const Vec2 pixel = *project(camera, kSize, point);
    const Ray ray = rayThrough(camera, kSize, pixel);
    EXPECT_NEAR((ray.direction - point.normalized()).norm(), 0, 1e-12);
    const Eigen::Vector4d clip = projectionMatrix(camera, kSize.aspect()) * point.homogeneous();
    EXPECT_NEAR((clip.x() / clip.w() + 1) * kSize.width / 2, pixel.x(), 1e-9);
    EXPECT_NEAR((1 - clip.y() / clip.w()) * kSize.height / 2, pixel.y(), 1e-9);
}

}  // namespace
}  // namespace tactooth
