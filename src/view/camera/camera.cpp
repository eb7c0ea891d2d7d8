// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/camera/camera.h"

#include <cmath>

#include "geometry/util/assert.h"

namespace tactooth {

Mat4 viewMatrix(const Camera& camera) {
    const Pose worldInCamera = camera.cameraInWorld.inverse();
    Mat4 matrix = Mat4::Identity();
    matrix.topLeftCorner<3, 3>() = worldInCamera.rotation.toRotationMatrix();
    matrix.topRightCorner<3, 1>() = worldInCamera.position;
    return matrix;
}

Mat4 projectionMatrix(const Camera& camera, double aspect) {
    TACTOOTH_ASSERT(camera.nearDistance > 0 && camera.farDistance > camera.nearDistance && aspect > 0);
    const double scale = 1 / std::tan(camera.fieldOfView / 2);
    const double depth = camera.farDistance - camera.nearDistance;
    Mat4 matrix = Mat4::Zero();
    matrix(0, 0) = scale / aspect;
    matrix(1, 1) = scale;
    matrix(0, 2) = camera.lensShift / aspect;
    matrix(2, 2) = -(camera.farDistance + camera.nearDistance) / depth;
    matrix(2, 3) = -2 * camera.farDistance * camera.nearDistance / depth;
    matrix(3, 2) = -1;
    return matrix;
}

Mat4 reflectionMatrix(const Plane& plane) {
    Mat4 matrix = Mat4::Identity();
    matrix.topLeftCorner<3, 3>() -= 2 * plane.normal * plane.normal.transpose();
    matrix.topRightCorner<3, 1>() = 2 * plane.offset * plane.normal;
    return matrix;
}

Ray rayThrough(const Camera& camera, ImageSize size, const Vec2& pixel) {
    const double halfHeight = std::tan(camera.fieldOfView / 2);
    const Vec3 inCamera(((2 * pixel.x() / size.width - 1) * size.aspect() + camera.lensShift) * halfHeight,
                        (1 - 2 * pixel.y() / size.height) * halfHeight, -1);
    const Vec3 perDepth = camera.cameraInWorld.rotation * inCamera;
    return {camera.cameraInWorld.position + camera.nearDistance * perDepth, perDepth.normalized()};
}

std::optional<Vec2> project(const Camera& camera, ImageSize size, const Vec3& point) {
    const Vec3 inCamera = camera.cameraInWorld.inverse() * point;
    if (inCamera.z() >= 0) return std::nullopt;
    const double scale = size.height / (2 * std::tan(camera.fieldOfView / 2) * -inCamera.z());
    const double middle = size.width / 2.0 - camera.lensShift * size.height / 2.0;
    return Vec2(middle + inCamera.x() * scale, size.height / 2.0 - inCamera.y() * scale);
}

}  // namespace tactooth
