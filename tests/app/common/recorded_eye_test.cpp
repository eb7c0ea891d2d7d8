// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/recorded_eye.h"

#include <gtest/gtest.h>

#include <numbers>

namespace tactooth {
namespace {

TEST(RecordedEye, TheCameraLooksFromThereAtItsTarget) {
    OrbitCamera camera;
    camera.centreOn(Vec3(1, -2, 3));
    for (const Vec3& eye : {Vec3(40, 30, 50), Vec3(-70, 5, -10), Vec3(1, -90, 3)}) {
        const OrbitCamera moved = lookingFrom(camera, eye, {640, 480});
        EXPECT_LT((moved.camera().cameraInWorld.position - eye).norm(), 1e-9);
        EXPECT_EQ(moved.target(), camera.target());
    }
}

TEST(RecordedEye, StraightAboveThePictureIsNotTurned) {
    OrbitCamera camera;
    camera.setView({0.7, 0.2});
    const OrbitCamera moved = lookingFrom(camera, Vec3(1e-4, -1e-4, 80), {640, 480});
    EXPECT_EQ(moved.direction().azimuth, 0.7);
    EXPECT_NEAR(moved.direction().elevation, std::numbers::pi / 2, 1e-5);
    EXPECT_EQ(lookingFrom(camera, camera.target(), {640, 480}).direction().azimuth, 0.7) << "no eye is in the tooth";
}

}  // namespace
}  // namespace tactooth
