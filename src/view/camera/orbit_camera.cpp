// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/camera/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactooth {

namespace {

constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kNearestEye = 1.5;   ///< mm: closer, a single enamel prism would fill the picture
constexpr double kFarthestEye = 2e3;  ///< mm: a mouth is 20 pixels high at that distance
constexpr double kMargin = 1.08;      ///< a fitted object leaves this margin around itself

}  // namespace

Quat OrbitCamera::rotation() const {
    // The unrotated camera has its viewing direction along -z and +y up: it is at the zenith. Tilt it down to the
    // horizon (its up is then +z and it is at -y), up again by the elevation, then rotate it by the azimuth.
    const Eigen::AngleAxisd tilt(kRightAngle - direction_.elevation, Vec3::UnitX());
    const Eigen::AngleAxisd walk(direction_.azimuth + kRightAngle, Vec3::UnitZ());
    return Quat(walk * tilt);
}

void OrbitCamera::fit(const Box3& box, double aspect) {
    if (box.isEmpty()) return;
    target_ = box.center();
    sceneRadius_ = std::max(0.5 * box.diagonal().norm(), kNearestEye / 4);
    const double narrowest = std::atan(std::tan(Camera{}.fieldOfView / 2) * std::min(1.0, aspect));
    distance_ = std::clamp(kMargin * sceneRadius_ / std::sin(narrowest), kNearestEye, kFarthestEye);
}

void OrbitCamera::fill(std::span<const Vec3> points, double share, double aspect) {
    if (points.empty()) return;
    const Quat toCamera = rotation().conjugate();
    Box3 seen;  // along the axes of the picture
    for (const Vec3& point : points) seen.extend(toCamera * point);
    target_ = rotation() * seen.center();
    sceneRadius_ = std::max(0.5 * seen.diagonal().norm(), kNearestEye / 4);
    const double up = share * std::tan(Camera{}.fieldOfView / 2);
    double distance = kNearestEye;
    for (const Vec3& point : points) {
        const Vec3 fromTarget = toCamera * point - seen.center();
        const double sideways = std::max(std::abs(fromTarget.y()), std::abs(fromTarget.x()) / aspect);
        distance = std::max(distance, fromTarget.z() + sideways / up);
    }
    distance_ = std::min(distance, kFarthestEye);
}

void OrbitCamera::setView(StandardView view, double mesialX) {
    switch (view) {
        case StandardView::Occlusal:
            return setView({kRightAngle, kRightAngle});
        case StandardView::Buccal:
            return setView({kRightAngle, 0});
        case StandardView::Lingual:
            return setView({-kRightAngle, 0});
        case StandardView::Mesial:
            return setView({mesialX > 0 ? 0 : 2 * kRightAngle, 0});
        case StandardView::Distal:
            return setView({mesialX > 0 ? 2 * kRightAngle : 0, 0});
    }
}

void OrbitCamera::setView(Direction direction) {
    direction_.azimuth = std::remainder(direction.azimuth, 4 * kRightAngle);
    direction_.elevation = std::clamp(direction.elevation, -kRightAngle, kRightAngle);
}

void OrbitCamera::orbit(const Vec2& pixels, ImageSize size) {
    const double perPixel = 2 * kRightAngle / size.height;
    setView({direction_.azimuth - pixels.x() * perPixel, direction_.elevation + pixels.y() * perPixel});
}

double OrbitCamera::pixelPitch(ImageSize size) const {
    return 2 * distance_ * std::tan(Camera{}.fieldOfView / 2) / size.height;
}

void OrbitCamera::pan(const Vec2& pixels, ImageSize size) {
    target_ += rotation() * Vec3(-pixels.x(), pixels.y(), 0) * pixelPitch(size);
}

void OrbitCamera::zoom(double factor, const Vec2& pixel, ImageSize size) {
    const double before = distance_;
    distance_ = std::clamp(distance_ * factor, kNearestEye, kFarthestEye);
    const Vec2 fromCentre = pixel - Vec2(size.width / 2.0, size.height / 2.0);
    pan(fromCentre * (1 - before / distance_), size);
}

void OrbitCamera::setPivot(const Vec3& point) {
    const Vec3 eye = camera().cameraInWorld.position;
    const Vec3 backward = rotation() * Vec3::UnitZ();
    const double depth = std::clamp((eye - point).dot(backward), kNearestEye, kFarthestEye);
    distance_ = depth;
    target_ = eye - depth * backward;
}

Camera OrbitCamera::camera() const {
    const Quat cameraRotation = rotation();
    // Near and far follow the distance so that the 24-bit depth buffer resolves a few micrometres at the target. The
    // range is wide because tools extend far to both sides of the tooth.
    return {.cameraInWorld = {target_ + cameraRotation * Vec3(0, 0, distance_), cameraRotation},
            .nearDistance = std::max(0.04 * distance_, 0.1),
            .farDistance = 4 * distance_ + 10 * sceneRadius_ + 200};
}

OrbitCamera::Direction mirroredInX(OrbitCamera::Direction direction) {
    return {2 * kRightAngle - direction.azimuth, direction.elevation};
}

}  // namespace tactooth
