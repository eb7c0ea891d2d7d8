// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/hands/mouse_manipulator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "session/control/surface_ray.h"
#include "session/hands/instrument_poses.h"

namespace tactooth {
namespace {

constexpr double kHover = 1.5;    // mm above the tooth while aiming: the user still sees what will be touched
constexpr double kApproach = 15;  // mm/s toward the tooth: a careful hand
// mm beyond the floor until the tool is there: else the force would fade with the distance. No more can be cut too
// deep, whatever the window does meanwhile.
constexpr double kFinish = 0.08;
constexpr double kAtFloor = 0.015;           // mm: there
constexpr double kMaxPull = 2;               // mm sideways between hand and tool; beyond it the hand slips
constexpr double kCaught = 0.3;              // mm between the tool and a hand that does not press: the tool is caught
constexpr double kRetract = 60;              // mm/s along the shaft: as fast as a hand lifts off
constexpr double kTrailStep = 0.05;          // mm between two places of a trail
constexpr double kRetraceAhead = 0.25;       // mm from the tool to a hand that retraces: less than kCaught
constexpr std::size_t kLongestTrail = 4000;  // places: 0.2 m without a loop, more than any cavity
constexpr double kAlongShaft = 0.4;          // cosine between view and shaft; above it pressing goes along the shaft
constexpr double kMaxTilt = 1.6;             // rad from upright: lying, as at the neck of a tooth
constexpr double kTiltPerPixel = 0.006;      // rad
constexpr double kHandleRotation = 0.45;     // rad toward lingual: the handle hides nothing of the crown from buccal

}  // namespace

MouseManipulator::MouseManipulator(const Box3& tooth, double mesialX)
    : tooth_(tooth),
      mesialX_(mesialX),
      tip_(tooth.center().x(), tooth.center().y(), tooth.max().z() + 2 * kHover),
      handle_(uprightGrip(mesialX, kHandleRotation)),
      grip_(handle_),
      aimedAt_(tip_) {}

void MouseManipulator::setSurroundings(const Surroundings& surroundings) {
    surroundings_ = surroundings;
    depthControl_.setSurface(surroundings.uncut);
    travel_.setTool(surroundings.tool);
    travel_.setSurface(surroundings.touchable);
}

/// Along the shaft if the user looks down on the tooth; else along the line of sight, so that walls are pressed from
/// the side.
void MouseManipulator::choosePressDirection(const PointerView& picture) {
    const Vec3 shaft = handle_ * -Vec3::UnitZ();
    const Vec3 view = picture.eyeAxes() * -Vec3::UnitZ();
    pressDirection_ = shaft.dot(view) > kAlongShaft ? shaft : view;
}

Vec3 MouseManipulator::onPlane(const PointerView& picture, const Vec2& pixel) const {
    const Ray ray = picture.rayThrough(pixel);
    const double slope = ray.direction.dot(pressDirection_);
    constexpr double kFlattest = 0.1;  // a ray nearly along the plane would throw the hand far away
    return ray.origin + (tip_ - ray.origin).dot(pressDirection_) / std::max(slope, kFlattest) * ray.direction;
}

/// A cavity does not move the landing place: the tip goes down at the place of its rim that the user points at.
void MouseManipulator::noteLanding(const PointerView& picture, const Vec2& pixel, const Surface& surface) {
    const Ray ray = picture.rayThrough(pixel);
    std::optional<SurfaceHit> hit = firstSeen(surface, ray);
    if (pressesToDepth()) {
        const std::optional<SurfaceHit> before = firstSeen(*depthControl_.surface(), ray);
        if (before && (!hit || before->distance < hit->distance)) hit = before;
    }
    landing_.reset();
    if (hit) landing_ = ray.origin + hit->distance * ray.direction;
}

void MouseManipulator::aim(const PointerView& picture, const Vec2& pixel, const Surface& surface) {
    choosePressDirection(picture);
    noteLanding(picture, pixel, surface);
    aimedAt_ = clampedToWorkspace(landing_ ? Vec3(*landing_ - kHover * pressDirection_) : onPlane(picture, pixel));
    mayRetract_ = !retracting_;
    if (!retracting_ && !knowsScene()) tip_ = aimedAt_;
}

void MouseManipulator::press(const PointerView& picture, const Vec2& pixel) {
    choosePressDirection(picture);
    pressing_ = true;
    retracting_ = false;
    arrived_ = !knowsScene();
    if (!withdraws_) trail_.clear();
    floorAlong_.reset();
    grabbed_ = pixel;
    if (!pressesToDepth()) return;
    noteLanding(picture, pixel, surroundings_.touchable ? *surroundings_.touchable : *depthControl_.surface());
    if (landing_) aimedAt_ = clampedToWorkspace(*landing_ - kHover * pressDirection_);
}

void MouseManipulator::drag(const PointerView& picture, const Vec2& pixel) {
    if (pressesToDepth()) {
        const Ray ray = picture.rayThrough(pixel);
        if (const auto hit = firstSeen(*depthControl_.surface(), ray)) {
            landing_ = ray.origin + hit->distance * ray.direction;
            grabbed_ = pixel;
            return;
        }
    }
    const Vec3 displacement = onPlane(picture, pixel) - onPlane(picture, grabbed_);
    if (pressesToDepth() && landing_) {
        *landing_ += displacement;
    } else {
        tip_ += displacement;
    }
    grabbed_ = pixel;
}

void MouseManipulator::release() {
    if (!pressing_) return;
    pressing_ = false;
    mayRetract_ = true;
    withdraws_ = true;
    catches_ = 0;
    if (knowsScene()) {
        leaving_ = true;
        aimedAt_ = clampedToWorkspace((landing_ ? *landing_ : Vec3(tip_ - pressDepth_ * pressDirection_)) -
                                      kHover * pressDirection_);
        return;
    }
    tip_ -= (pressDepth_ + kHover) * pressDirection_;
    aimedAt_ = tip_;
}

void MouseManipulator::advance(double dt, const Vec3& toolTip, double depth) {
    if (pressing_ && !arrived_) {
        travel(dt, toolTip, depth);
        arrived_ = isOverLanding(toolTip);
        if (withdraws_ && caught_) {  // pressed again where it could not leave
            arrived_ = true;
            landing_ = toolTip;
        }
        if (arrived_) travel_.stop();
        if (arrived_) depthControl_.beginAt(landing_.value_or(toolTip), pressDirection_);
        return;
    }
    if (pressing_) {
        grip_ = handle_;
        noteTrail(toolTip);
        return pressesToDepth() ? advanceToDepth(dt, toolTip) : advanceContact(dt, toolTip);
    }
    if (knowsScene()) return travel(dt, toolTip, depth);
    caught_ = depth > kCaught;
    if (caught_ && mayRetract_) retracting_ = true;
    if (retracting_) retract(dt, toolTip);
    withdraws_ = withdraws_ && (retracting_ || depth > 0);
}

/// Whether the tool may go down: it is above the landing place, or as near to it as it can be.
bool MouseManipulator::isOverLanding(const Vec3& toolTip) const {
    constexpr double kNear = 0.2;  // mm
    if (travel_.hasArrived()) return (toolTip - tip_).norm() < kNear;
    if (!landing_) return false;
    const Vec3 offset = *landing_ - toolTip;
    const double above = offset.dot(pressDirection_);
    return above > 0 && (offset - above * pressDirection_).norm() < kNear;
}

/// Where the tool was before it is free for it later: cutting only takes away.
void MouseManipulator::noteTrail(const Vec3& toolTip) {
    const Pose now{toolTip, grip_};
    const auto isHere = [&](const Pose& before) {
        return (before.position - toolTip).norm() < kTrailStep && before.rotation.isApprox(grip_);
    };
    const auto loop = std::ranges::find_if(trail_, isHere);
    if (loop != trail_.end()) {
        trail_.erase(loop + 1, trail_.end());
    } else if (trail_.size() < kLongestTrail) {
        trail_.push_back(now);
    }
}

/// Goes back as it came, to the place where the press began. False: it need not, or has arrived.
bool MouseManipulator::retrace(double dt, const Vec3& toolTip, double depth) {
    constexpr double kCaughtFor = 0.12;   // s: the hand has left the floor that it pressed on
    constexpr int kSecondCatch = 2;       // on its way along the shaft: the end of a press looks like the first one
    constexpr double kLongestWait = 0.5;  // s: something else holds it, an undone cut for example
    if (!withdraws_) trail_.clear();
    waits_ = retraces_ || depth > kCaught ? waits_ + dt : 0;
    catches_ += depth > kCaught && !caught_ ? 1 : 0;
    if (!retraces_) {
        if ((waits_ < kCaughtFor && catches_ < kSecondCatch) || trail_.empty()) return false;
        waits_ = 0;
        caught_ = false;
    }
    while (!trail_.empty() && (trail_.back().position - toolTip).norm() < kRetraceAhead) {
        trail_.pop_back();
        waits_ = 0;
    }
    const bool isOut = depth == 0 && travel_.isClear({toolTip, grip_});
    if (isOut || waits_ > kLongestWait) trail_.clear();
    retraces_ = !trail_.empty();
    if (!retraces_) return false;
    const Vec3 left = trail_.back().position - toolTip;
    tip_ = toolTip + std::min(1.0, kRetraceAhead / left.norm()) * left;
    grip_ = trail_.back().rotation;
    return true;
}

/// Toward the place that the user aims at, clear of everything.
void MouseManipulator::travel(double dt, const Vec3& toolTip, double depth) {
    if (retrace(dt, toolTip, depth)) return travel_.stop();
    const bool isCaught = depth > kCaught;
    const bool leaves = std::exchange(leaving_, false);
    if (leaves || (isCaught && !caught_)) travel_.stop();  // another path is needed
    caught_ = isCaught;
    withdraws_ = withdraws_ && (depth > 0 || !travel_.isClear({toolTip, grip_}));
    const ClearTravel::Place from{{tip_, grip_}, {toolTip, grip_}, leaves || isCaught};
    travel_.goTo(from, {aimedAt_, handle_});
    const Pose next = travel_.advance(from, dt);
    tip_ = next.position;
    grip_ = next.rotation;
}

void MouseManipulator::advanceContact(double dt, const Vec3& toolTip) {
    const Vec3 offset = tip_ - toolTip;
    const double sunk = offset.dot(pressDirection_);
    Vec3 pull = offset - sunk * pressDirection_;
    if (pull.norm() > kMaxPull) pull *= kMaxPull / pull.norm();
    const double deeper = std::min(pressDepth_, sunk + kApproach * dt);
    tip_ = clampedToWorkspace(toolTip + pull + deeper * pressDirection_);
}

/// Distance along the press direction from the tool to its floor, here and at the place to which it is pulled. Where
/// the axis of the tool misses the tooth, the floor is as deep as at the last place.
double MouseManipulator::toFloor(const Vec3& toolTip, const Vec3& aside) {
    const auto here = depthControl_.toFloor(toolTip, pressDirection_);
    const auto there = depthControl_.toFloor(toolTip + aside, pressDirection_);
    if (here) floorAlong_ = toolTip.dot(pressDirection_) + *here;
    if (here || there) return std::min(here.value_or(*there), there.value_or(*here));
    return floorAlong_ ? *floorAlong_ - toolTip.dot(pressDirection_) : 0;
}

/// The hand is the press depth beyond the tool, but not beyond the floor: the tool cannot be pressed deeper.
void MouseManipulator::advanceToDepth(double dt, const Vec3& toolTip) {
    const double sunk = (tip_ - toolTip).dot(pressDirection_);
    Vec3 aside = (landing_ ? *landing_ : tip_) - toolTip;
    aside -= aside.dot(pressDirection_) * pressDirection_;
    if (aside.norm() > kMaxPull) aside *= kMaxPull / aside.norm();
    const double left = toFloor(toolTip, aside);
    const double deeper = std::min({pressDepth_, sunk + kApproach * dt, left > kAtFloor ? left + kFinish : left});
    tip_ = clampedToWorkspace(toolTip + aside + deeper * pressDirection_);
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
    const Mat3 eye = picture.eyeAxes();
    const Vec3 displacement = eye * Vec3(pixels.x(), -pixels.y(), 0);
    const Vec3 shaft = handle_ * Vec3::UnitZ();
    const Vec3 axis = shaft.cross(displacement);
    if (axis.norm() == 0) return;
    const Quat tilted = Quat(Eigen::AngleAxisd(kTiltPerPixel * axis.norm(), axis.normalized())) * handle_;
    if ((tilted * Vec3::UnitZ()).z() >= std::cos(kMaxTilt)) hold(tilted.normalized());
}

void MouseManipulator::rotateHandle(double angle) {
    hold((Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())) * handle_).normalized());
}

void MouseManipulator::resetOrientation() { hold(uprightGrip(mesialX_, kHandleRotation)); }

void MouseManipulator::alignShaft(const Vec3& outward) {
    hold((shortestRotation(Vec3::UnitZ(), outward) * uprightGrip(mesialX_, kHandleRotation)).normalized());
}

/// A tool that stands still in known surroundings turns on its path, where it is clear.
void MouseManipulator::hold(const Quat& handle) {
    handle_ = handle;
    if (!knowsScene()) grip_ = handle_;
}

}  // namespace tactooth
