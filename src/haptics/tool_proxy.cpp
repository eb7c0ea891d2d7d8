// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/tool_proxy.h"

#include <utility>

#include "collision/bvh/closest_point.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

// How far a tool is moved out of a new surface, mm.
constexpr double kFirstStep = 1e-4;  // the error of the extraction
constexpr double kSmallStep = 5e-3;  // a distance that a hand does not feel
constexpr double kLongStep = 0.02;   // a distance that a hand hardly feels; used once waiting has not helped
constexpr double kLastStep = 0.5;    // farther than one update of a cut

constexpr double kRetryInterval = 0.008;  // s between two tries of a surface that caught the tool
constexpr int kMaxTries = 2;              // failed tries: the obstacle will not go away

}  // namespace

ToolProxy::ToolProxy(std::shared_ptr<const ToolShape> tool, std::shared_ptr<const Surface> surface, ContactMode mode,
                     Freedom freedom)
    : tool_((TACTOOTH_ASSERT(tool != nullptr), std::move(tool))),
      surface_((TACTOOTH_ASSERT(surface != nullptr), surface)),
      mode_(mode),
      freedom_(freedom),
      solver_(tool_, freedom),
      query_(tool_, surface),
      other_{nullptr, NeighbourList(*tool_)} {
    solver_.setSurface(std::move(surface));
    for (const Vec3f& vertex : tool_->mesh().vertices) {
        if (vertex.z() > farEnd_.z()) farEnd_ = vertex.cast<double>();
    }
}

std::shared_ptr<const Surface> ToolProxy::setSurface(std::shared_ptr<const Surface> surface) {
    TACTOOTH_ASSERT(surface != nullptr);
    surface_ = surface;
    newSurface_ = true;
    isAtOldPose_ = false;
    waitTime_.reset();
    query_.setSurface(surface);
    return solver_.setSurface(std::move(surface));
}

bool ToolProxy::setSurface(HapticSurface& hapticSurface) {
    TACTOOTH_ASSERT(hapticSurface.surface != nullptr);
    TACTOOTH_ASSERT(!hapticSurface.place || isRigid(*hapticSurface.place));
    const std::optional<Pose> place = std::exchange(hapticSurface.place, std::nullopt);
    if (!placed_) waitTime_.reset();
    const bool isNew = takeSurface(hapticSurface);
    if (!placed_ && place) {
        solver_.shiftTo(*place);
        placed_ = true;
    }
    return isNew;
}

bool ToolProxy::takeSurface(HapticSurface& hapticSurface) {
    if (waitTime_ && hapticSurface.surface == other_.surface) {
        std::swap(other_.near, hapticSurface.near);
        return false;
    }
    const bool isNew = surface_ != hapticSurface.surface;
    const bool wasRendered = !newSurface_;
    surface_ = hapticSurface.surface;
    hapticSurface.surface = solver_.setSurface(std::move(hapticSurface.surface), hapticSurface.near);
    if (!isNew) return false;
    newSurface_ = true;
    query_.setSurface(surface_);
    waitTime_.reset();
    if (!wasRendered && isAtOldPose_) return true;  // the tool still stands where it stood in the surface before
    std::swap(other_, hapticSurface);               // the caller frees the older surface
    isAtOldPose_ = placed_ && wasRendered;
    return true;
}

void ToolProxy::fillContactPoint(ContactPoint& held, std::uint32_t part, std::uint32_t triangle) const {
    const SurfacePart& surface = partOf(*surface_, part);
    TACTOOTH_ASSERT(surface.tag(triangle) < kMaxMaterials);
    held.material = static_cast<MaterialId>(surface.tag(triangle));
    held.isAdjacent = surface.isAdjacent(triangle);
}

/// The first pose: the device pose itself, or the nearest free pose if the device starts inside the tooth and no other
/// thread searches for it.
void ToolProxy::placeNear(const Pose& deviceInTooth) {
    isAtOldPose_ = false;
    if (query_.isFree(deviceInTooth)) {
        solver_.placeAt(deviceInTooth);
        placed_ = true;
        return;
    }
    if (!placesItself_) return;
    const Contact contact = query_.at(deviceInTooth);
    if (!(contact.depth > 0)) return;  // no free pose was found, so there is no force
    solver_.placeAt(query_.freePose());
    placed_ = true;
}

/// The solver's neighbour list answers at once; a new search takes a millisecond in a cavity.
bool ToolProxy::isFree(const Pose& toolInTooth) {
    const std::optional<bool> isClear = solver_.isClearAt(toolInTooth);
    return isClear ? *isClear && !isEnclosed(toolInTooth) : query_.isFree(toolInTooth);
}

/// A new surface may be a micrometre closer than the one before. Moves the tool back along the last contact or along
/// the shaft, by the smallest of a few distances that is free.
bool ToolProxy::retractFromSurface(double farthest) {
    TACTOOTH_ASSERT(farthest > 0);
    TACTOOTH_ASSERT(isUnit(exitDirection_));
    const Pose stuck = solver_.pose();
    for (double step = kFirstStep; step < farthest; step *= 2) {
        for (const Vec3& direction : {exitDirection_, Vec3(stuck.rotation * Vec3::UnitZ())}) {
            const Pose pose{stuck.position + step * direction, stuck.rotation};
            if (!isFree(pose)) continue;
            solver_.shiftTo(pose);
            return true;
        }
    }
    return false;
}

void ToolProxy::swapSurfaces() {
    TACTOOTH_ASSERT(other_.surface != nullptr);
    surface_ = other_.surface;
    query_.setSurface(surface_);
    other_.surface = solver_.setSurface(std::move(other_.surface), other_.near);
}

/// A new surface may catch a bur in its cavity on all sides, a micrometre deep, so that the nearest free pose is far
/// away. The bur stays in the surface before, where it is free, until it is free in the new one as well.
bool ToolProxy::revertSurface() {
    if (!std::exchange(isAtOldPose_, false)) return false;
    TACTOOTH_ASSERT(!waitTime_);
    swapSurfaces();
    waitTime_ = 0;
    ++failedTries_;
    return true;
}

void ToolProxy::retryNewestSurface(double dt) {
    if (!waitTime_) return;
    TACTOOTH_ASSERT(*waitTime_ >= 0 && !isAtOldPose_);
    *waitTime_ += dt;
    if (*waitTime_ + dt / 2 < kRetryInterval) return;
    swapSurfaces();
    waitTime_.reset();
    isAtOldPose_ = newSurface_ = true;
}

/// Moves the proxy, and frees it first where a new surface has caught it.
MoveResult ToolProxy::moveToward(const Pose& goal) {
    const Pose before = solver_.pose();
    MoveResult move = solver_.moveToward(goal);
    const double shortStep = failedTries_ < kMaxTries ? kSmallStep : kLongStep;
    if (move.status == MoveStatus::Overlapping &&
        (retractFromSurface(shortStep) || revertSurface() || retractFromSurface(kLastStep)))
        move = solver_.moveToward(goal);
    TACTOOTH_ASSERT(move.contactCount >= 0 && move.contactCount <= kMaxHeld);
    TACTOOTH_ASSERT(failedTries_ >= 0);
    if (!waitTime_ && move.status != MoveStatus::Overlapping) failedTries_ = 0;
    isAtOldPose_ &=
        solver_.pose().position == before.position && solver_.pose().rotation.coeffs() == before.rotation.coeffs();
    return move;
}

/// Whether the tool is wholly inside the tooth, where it meets no triangle. This happens when a cut tooth becomes whole
/// again. The far end of the tool decides: it is the last part to touch anything.
bool ToolProxy::isEnclosed(const Pose& toolInTooth) const {
    return surface_->closed && contains(*surface_, toolInTooth * farEnd_);
}

/// See ProxyState::deviceTip. A tool rotates about its centre.
Vec3 ToolProxy::deviceTip(const Pose& deviceInTooth) const {
    if (freedom_ == Freedom::Translation) return deviceInTooth.position;
    const Vec3 centre = tool_->centre();
    return deviceInTooth * centre - solver_.pose().rotation * centre;
}

ProxyState ToolProxy::follow(const Pose& deviceInTooth, const Pose& goal, double dt) {
    TACTOOTH_ASSERT(isRigid(deviceInTooth));
    TACTOOTH_ASSERT(isRigid(goal));
    TACTOOTH_ASSERT(!(dt < 0));
    if (mode_ == ContactMode::Penalty) return followByPenalty(deviceInTooth);
    ProxyState state;
    if (!placed_) placeNear(deviceInTooth);
    if (!placed_) return state;
    const Vec3 before = solver_.pose().position;
    retryNewestSurface(dt);
    if (std::exchange(newSurface_, false) && isEnclosed(solver_.pose())) {
        placed_ = false;
        return state;
    }
    const MoveResult move = moveToward(goal);
    if (move.status == MoveStatus::Overlapping) {
        placed_ = false;
        return state;
    }
    TACTOOTH_ASSERT(isRigid(solver_.pose()));
    state.placed = true;
    state.proxy = solver_.pose();
    state.deviceTip = deviceTip(deviceInTooth);
    state.offset = solver_.pose().position - state.deviceTip;
    state.travel = (solver_.pose().position - before).norm();
    if (move.status == MoveStatus::OutOfBudget) state.late = (goal.position - state.proxy.position).norm();
    const bool isOverBudget = move.status == MoveStatus::OutOfIterations || move.status == MoveStatus::OutOfBudget;
    const bool isShort = move.status == MoveStatus::Reached && goal.position != deviceInTooth.position;
    // A tool that is late must not pull back a hand that leaves.
    const bool isLeaving = isOverBudget && state.offset.dot(exitDirection_) <= 0;
    const int held = isLeaving ? 0 : move.contactCount;
    state.contacts = state.contactPointCount = held;
    const bool isStuck = isOverBudget && held == 0 && !isLeaving;
    if (isShort || (isStuck && (touching_ || state.travel == 0))) holdWithoutContact(state);
    for (int i = 0; i < held; ++i) {
        const ProxyContact& contact = move.contacts[i];
        state.held[i] = {contact.point, contact.normal, contact.multiplier};
        fillContactPoint(state.held[i], contact.part, contact.tooth);
    }
    if (held > 0) {
        exitDirection_ = state.offset.norm() > 0 ? Vec3(state.offset.normalized()) : move.contacts[0].normal;
        lastContact_ = state.held[0];
    }
    TACTOOTH_ASSERT(state.contactPointCount <= kMaxHeld);
    TACTOOTH_ASSERT(isUnit(exitDirection_));
    touching_ = state.contacts > 0;
    return state;
}

/// The work budget ran out between two contacts, or before the first, or the goal is short of the device. The surface
/// between device and proxy still holds the proxy, or the force would drop out while the hand presses.
void ToolProxy::holdWithoutContact(ProxyState& state) {
    TACTOOTH_ASSERT(state.placed && state.contactPointCount == 0);
    const double depth = state.offset.norm();
    if (!(depth > 0)) return;
    state.contacts = state.contactPointCount = 1;
    state.held[0] = {state.proxy.position, state.offset / depth, depth, lastContact_.material, lastContact_.isAdjacent};
}

ProxyState ToolProxy::followByPenalty(const Pose& deviceInTooth) {
    ProxyState state;
    const Contact contact = query_.deepestPairAt(deviceInTooth);
    TACTOOTH_ASSERT(contact.depth >= 0);
    state.placed = true;
    state.deviceTip = deviceInTooth.position;
    state.offset = contact.depth * contact.normal;
    state.proxy = {deviceInTooth.position + state.offset, deviceInTooth.rotation};
    state.contacts = contact.contacts;
    if (contact.depth > 0) {
        state.contactPointCount = 1;
        state.held[0] = {contact.point + state.offset, contact.normal, contact.depth};
        fillContactPoint(state.held[0], contact.part, contact.tooth);
    }
    return state;
}

}  // namespace tactooth
