// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/mirror_placement.h"

#include <cmath>

namespace tactooth {
namespace {

constexpr double kTiltPerPixel = 0.004;  // rad: half of what the eye sees turn in a mirror

Vec3 towardEye(const PointerView& picture) { return picture.eyeAxes() * Vec3::UnitZ(); }

/// Where the line of sight through `pixel` meets the plane through `place` that faces the eye.
Vec3 onFacingPlane(const PointerView& picture, const Vec2& pixel, const Vec3& place) {
    const Ray ray = picture.rayThrough(pixel);
    const Vec3 normal = towardEye(picture);
    return ray.origin + (place - ray.origin).dot(normal) / ray.direction.dot(normal) * ray.direction;
}

}  // namespace

void MirrorPlacement::moveTo(const Vec3& centre) {
    if (!centre.allFinite()) return;
    Vec3 away = centre - parked_.position;
    if (away.norm() > kReach) away *= kReach / away.norm();
    held_ = Pose{parked_.position + away, pose().rotation};
}

void MirrorPlacement::drag(const PointerView& picture, const Vec2& from, const Vec2& to) {
    const Vec3 centre = pose().position;
    moveTo(centre + onFacingPlane(picture, to, centre) - onFacingPlane(picture, from, centre));
}

void MirrorPlacement::tilt(const PointerView& picture, const Vec2& pixels) {
    const Vec3 displacement = picture.eyeAxes() * Vec3(pixels.x(), -pixels.y(), 0);
    const double angle = kTiltPerPixel * displacement.norm();
    const Vec3 axis = towardEye(picture).cross(displacement);
    if (!(axis.norm() > 0) || !std::isfinite(angle)) return;
    const Quat turn(Eigen::AngleAxisd(angle, axis.normalized()));
    held_ = Pose{pose().position, (turn * pose().rotation).normalized()};
}

void MirrorPlacement::approach(const PointerView& picture, double distance) {
    moveTo(pose().position + distance * towardEye(picture));
}

}  // namespace tactooth
