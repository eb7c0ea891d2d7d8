// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/mouse_manipulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "session/model/instrument_poses.h"
#include "session/model/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kHover = 1.5;            // mm above the tooth while aiming: the user still sees what will be touched
constexpr double kApproach = 15;          // mm/s toward the tooth: a careful hand
constexpr double kMaxPull = 2;            // mm sideways between hand and tool; beyond it the hand slips
constexpr double kCaught = 0.3;           // mm between the tool and a hand that does not press: the tool is caught
constexpr double kRetract = 60;           // mm/s along the shaft: as fast as a hand lifts off
constexpr double kAlongShaft = 0.4;       // cosine between view and shaft; above it pressing goes along the shaft
constexpr double kMaxTilt = 1.6;          // rad from upright: lying, as at the neck of a tooth
constexpr double kTiltPerPixel = 0.006;   // rad
constexpr double kHandleRotation = 0.45;  // rad toward lingual: the handle hides nothing of the crown from buccal

}  // namespace

MouseManipulator::MouseManipulator(const Box3& tooth, double mesialX)
    : tooth_(tooth),
      mesialX_(mesialX),
      tip_(tooth.center().x(), tooth.center().y(), tooth.max().z() + 2 * kHover),
      handle_(uprightGrip(mesialX, kHandleRotation)),
      aimedAt_(tip_) {}

/// Along the shaft if the user looks down on the tooth; else along the line of sight, so that walls are pressed from
/// the side.
void MouseManipulator::choosePressDirection(const PointerView& picture) {
    const Vec3 shaft = handle_ * -Vec3::UnitZ();
    const Vec3 view = picture.cameraRotation() * -Vec3::UnitZ();
    pressDirection_ = shaft.dot(view) > kAlongShaft ? shaft : view;
}

Vec3 MouseManipulator::onPlane(const PointerView& picture, const Vec2& pixel) const {
    const Ray ray = picture.rayThrough(pixel);
    const double slope = ray.direction.dot(pressDirection_);
    constexpr double kFlattest = 0.1;  // a ray nearly along the plane would throw the hand far away
    return ray.origin + (tip_ - ray.origin).dot(pressDirection_) / std::max(slope, kFlattest) * ray.direction;
}

void MouseManipulator::aim(const PointerView& picture, const Vec2& pixel, const Surface& surface) {
    choosePressDirection(picture);
    const Ray ray = picture.rayThrough(pixel);
    const auto hit = firstHit(surface, ray);
    const Vec3 wanted =
        hit ? Vec3(ray.origin + *hit * ray.direction - kHover * pressDirection_) : onPlane(picture, pixel);
    aimedAt_ = clampedToWorkspace(wanted);
    mayRetract_ = !retracting_;
    if (!retracting_) tip_ = aimedAt_;
}

void MouseManipulator::press(const PointerView& picture, const Vec2& pixel) {
    choosePressDirection(picture);
    pressing_ = true;
    retracting_ = false;
    grabbed_ = pixel;
}

void MouseManipulator::drag(const PointerView& picture, const Vec2& pixel) {
    tip_ += onPlane(picture, pixel) - onPlane(picture, grabbed_);
    grabbed_ = pixel;
}

void MouseManipulator::release() {
    if (!pressing_) return;
    pressing_ = false;
    tip_ -= (pressDepth_ + kHover) * pressDirection_;
    aimedAt_ = tip_;
    mayRetract_ = true;
}

void MouseManipulator::advance(double dt, const Vec3& toolTip, double depth) {
    if (pressing_) return advanceContact(dt, toolTip);
    if (depth > kCaught && mayRetract_) retracting_ = true;
    if (retracting_) retract(dt, toolTip);
}

void MouseManipulator::advanceContact(double dt, const Vec3& toolTip) {
    const Vec3 offset = tip_ - toolTip;
    const double sunk = offset.dot(pressDirection_);
    Vec3 pull = offset - sunk * pressDirection_;
    if (pull.norm() > kMaxPull) pull *= kMaxPull / pull.norm();
    const double deeper = std::min(pressDepth_, sunk + kApproach * dt);
    tip_ = clampedToWorkspace(toolTip + pull + deeper * pressDirection_);
}

void MouseManipulator::retract(double dt, const Vec3& toolTip) {
    mayRetract_ = false;
    retracting_ = toolTip.z() < tooth_.max().z() + kHover;
    tip_ = retracting_ ? Vec3(toolTip + kRetract * dt * (handle_ * Vec3::UnitZ())) : aimedAt_;
}

Vec3 MouseManipulator::clampedToWorkspace(const Vec3& tip) const {
    const Vec3 margin = Vec3::Constant(kWorkspaceMargin);
    return tip.cwiseMax(tooth_.min() - margin).cwiseMin(tooth_.max() + margin);
}

void MouseManipulator::setPressDepth(double depth) { pressDepth_ = std::clamp(depth, 0.0, kMaxPressDepth); }

void MouseManipulator::tilt(const PointerView& picture, const Vec2& pixels) {
    const Quat eye = picture.cameraRotation();
    const Vec3 displacement = eye * Vec3(pixels.x(), -pixels.y(), 0);
    const Vec3 shaft = handle_ * Vec3::UnitZ();
    const Vec3 axis = shaft.cross(displacement);
    if (axis.norm() == 0) return;
    const Quat tilted = Quat(Eigen::AngleAxisd(kTiltPerPixel * axis.norm(), axis.normalized())) * handle_;
    if ((tilted * Vec3::UnitZ()).z() >= std::cos(kMaxTilt)) handle_ = tilted.normalized();
}

void MouseManipulator::rotateHandle(double angle) {
    handle_ = (Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())) * handle_).normalized();
}

void MouseManipulator::resetOrientation() { handle_ = uprightGrip(mesialX_, kHandleRotation); }

}  // namespace tactooth
