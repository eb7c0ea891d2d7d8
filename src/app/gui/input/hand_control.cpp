// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/input/hand_control.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/common/scene_builder.h"
#include "app/gui/input/surface_ray.h"

namespace tactooth {
namespace {

constexpr double kHover = 1.5;           // mm over the tooth while aiming: near enough to see what will be touched
constexpr double kApproach = 15;         // mm/s toward the tooth: a careful hand
constexpr double kMostPull = 2;          // mm sideways between hand and tool: beyond, the hand slips along
constexpr double kCaught = 0.3;          // mm that a tool stays behind a hand that does not press: more than it slides
constexpr double kDrawOut = 60;          // mm/s along the shaft: quick, as a hand lifts off
constexpr double kAlongShaft = 0.4;      // cosine between view and shaft from which pressing goes along the shaft
constexpr double kMostLean = 1.6;        // rad from upright: lying down, as at the neck of a tooth
constexpr double kLeanPerPixel = 0.006;  // rad
constexpr double kHandleTurn = 0.45;     // rad toward lingual: away from the usual view, hiding nothing of the crown

}  // namespace

HandControl::HandControl(const Box3& tooth, double mesialX)
    : tooth_(tooth),
      mesialX_(mesialX),
      tip_(tooth.center().x(), tooth.center().y(), tooth.max().z() + 2 * kHover),
      handle_(uprightGrip(mesialX, kHandleTurn)),
      aimedAt_(tip_) {}

/// Along the shaft where one looks down on the tooth, else away from the eye: a wall is pressed from the side.
void HandControl::chooseDown(const PointedPicture& picture) {
    const Vec3 shaft = handle_ * -Vec3::UnitZ();
    const Vec3 view = picture.camera.cameraInWorld.rotation * -Vec3::UnitZ();
    down_ = shaft.dot(view) > kAlongShaft ? shaft : view;
}

Vec3 HandControl::onPlane(const PointedPicture& picture, const Vec2& pixel) const {
    const Ray ray = rayThrough(picture.camera, picture.size, pixel);
    const double slope = ray.direction.dot(down_);
    constexpr double kFlattest = 0.1;  // a ray nearly along the plane would throw the hand far away
    return ray.origin + (tip_ - ray.origin).dot(down_) / std::max(slope, kFlattest) * ray.direction;
}

void HandControl::aim(const PointedPicture& picture, const Vec2& pixel, const Surface& surface) {
    chooseDown(picture);
    const Ray ray = rayThrough(picture.camera, picture.size, pixel);
    const auto hit = firstHit(surface, ray);
    const Vec3 wanted = hit ? Vec3(ray.origin + *hit * ray.direction - kHover * down_) : onPlane(picture, pixel);
    aimedAt_ = inReach(wanted);
    mayDrawOut_ = !drawingOut_;
    if (!drawingOut_) tip_ = aimedAt_;
}

void HandControl::press(const PointedPicture& picture, const Vec2& pixel) {
    chooseDown(picture);
    pressing_ = true;
    drawingOut_ = false;
    grabbed_ = pixel;
}

void HandControl::drag(const PointedPicture& picture, const Vec2& pixel) {
    tip_ += onPlane(picture, pixel) - onPlane(picture, grabbed_);
    grabbed_ = pixel;
}

void HandControl::release() {
    if (!pressing_) return;
    pressing_ = false;
    tip_ -= (pressDepth_ + kHover) * down_;
    aimedAt_ = tip_;
    mayDrawOut_ = true;
}

void HandControl::advance(double dt, const Vec3& toolTip, double depth) {
    if (pressing_) return sink(dt, toolTip);
    if (depth > kCaught && mayDrawOut_) drawingOut_ = true;
    if (drawingOut_) drawOut(dt, toolTip);
}

void HandControl::sink(double dt, const Vec3& toolTip) {
    const Vec3 offset = tip_ - toolTip;
    const double sunk = offset.dot(down_);
    Vec3 pull = offset - sunk * down_;
    if (pull.norm() > kMostPull) pull *= kMostPull / pull.norm();
    const double deeper = std::min(pressDepth_, sunk + kApproach * dt);
    tip_ = inReach(toolTip + pull + deeper * down_);
}

void HandControl::drawOut(double dt, const Vec3& toolTip) {
    mayDrawOut_ = false;
    drawingOut_ = toolTip.z() < tooth_.max().z() + kHover;
    tip_ = drawingOut_ ? Vec3(toolTip + kDrawOut * dt * (handle_ * Vec3::UnitZ())) : aimedAt_;
}

Vec3 HandControl::inReach(const Vec3& tip) const {
    const Vec3 margin = Vec3::Constant(kReach);
    return tip.cwiseMax(tooth_.min() - margin).cwiseMin(tooth_.max() + margin);
}

void HandControl::setPressDepth(double depth) { pressDepth_ = std::clamp(depth, 0.0, kMostPressDepth); }

void HandControl::lean(const PointedPicture& picture, const Vec2& pixels) {
    const Quat& eye = picture.camera.cameraInWorld.rotation;
    const Vec3 way = eye * Vec3(pixels.x(), -pixels.y(), 0);
    const Vec3 shaft = handle_ * Vec3::UnitZ();
    const Vec3 axis = shaft.cross(way);
    if (axis.norm() == 0) return;
    const Quat leaned = Quat(Eigen::AngleAxisd(kLeanPerPixel * axis.norm(), axis.normalized())) * handle_;
    if ((leaned * Vec3::UnitZ()).z() >= std::cos(kMostLean)) handle_ = leaned.normalized();
}

void HandControl::turnHandle(double angle) {
    handle_ = (Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())) * handle_).normalized();
}

void HandControl::standUpright() { handle_ = uprightGrip(mesialX_, kHandleTurn); }

}  // namespace tactooth
