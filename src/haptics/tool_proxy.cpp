// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "haptics/tool_proxy.h"

#include <utility>

#include "collision/bvh/closest_point.h"

namespace tactooth {
namespace {

// How far a tool is moved out of a new surface, mm.
constexpr double kFirstStep = 1e-4;  // the extraction's own error
constexpr double kSmallStep = 5e-3;  // as far as a hand does not feel it
constexpr double kLongStep = 0.02;   // what it hardly feels: once waiting has not helped
constexpr double kLastStep = 0.5;    // further than any cut of one update

constexpr double kRetryInterval = 0.008;  // s from one try of a surface that caught the tool to the next
constexpr int kMaxTries = 2;              // in vain: what catches the tool will not go away

}  // namespace

ToolProxy::ToolProxy(std::shared_ptr<const ToolShape> tool, std::shared_ptr<const Surface> surface, ContactMode mode,
                     Freedom freedom)
    : tool_(std::move(tool)),
      surface_(surface),
      mode_(mode),
      freedom_(freedom),
      body_(tool_, freedom),
      query_(tool_, surface),
      other_{nullptr, NeighbourList(*tool_)} {
    body_.setSurface(std::move(surface));
    for (const Vec3f& vertex : tool_->mesh().vertices) {
        if (vertex.z() > farEnd_.z()) farEnd_ = vertex.cast<double>();
    }
}

std::shared_ptr<const Surface> ToolProxy::setSurface(std::shared_ptr<const Surface> surface) {
    surface_ = surface;
    newSurface_ = true;
    isAtOldPose_ = false;
    waitTime_.reset();
    query_.setSurface(surface);
    return body_.setSurface(std::move(surface));
}

bool ToolProxy::setSurface(HapticSurface& felt) {
    const std::optional<Pose> place = std::exchange(felt.place, std::nullopt);
    if (!placed_) waitTime_.reset();
    const bool isNew = takeSurface(felt);
    if (!placed_ && place) {
        body_.shiftTo(*place);
        placed_ = true;
    }
    return isNew;
}

bool ToolProxy::takeSurface(HapticSurface& felt) {
    if (waitTime_ && felt.surface == other_.surface) {
        std::swap(other_.near, felt.near);
        return false;
    }
    const bool isNew = surface_ != felt.surface;
    const bool wasRendered = !newSurface_;
    surface_ = felt.surface;
    felt.surface = body_.setSurface(std::move(felt.surface), felt.near);
    if (!isNew) return false;
    newSurface_ = true;
    query_.setSurface(surface_);
    waitTime_.reset();
    if (!wasRendered && isAtOldPose_) return true;  // the tool still stands in the one before that
    std::swap(other_, felt);                        // the caller frees the one before that
    isAtOldPose_ = placed_ && wasRendered;
    return true;
}

void ToolProxy::fillContactPoint(ContactPoint& held, std::uint32_t part, std::uint32_t triangle) const {
    const SurfacePart& surface = partOf(*surface_, part);
    held.material = static_cast<MaterialId>(surface.tag(triangle));
    held.isAdjacent = surface.isAdjacent(triangle);
}

/// The first pose: the hand's own, or the nearest free one if the hand starts inside the tooth and nobody else looks
/// for it.
void ToolProxy::placeNear(const Pose& deviceInTooth) {
    isAtOldPose_ = false;
    if (query_.isFree(deviceInTooth)) {
        body_.placeAt(deviceInTooth);
        placed_ = true;
        return;
    }
    if (!placesItself_) return;
    const Contact contact = query_.at(deviceInTooth);
    if (!(contact.depth > 0)) return;  // no way out was found: there is no force to make up
    body_.placeAt(query_.freePose());
    placed_ = true;
}

/// What the body knows of its surroundings answers at once; to look for what is near takes a millisecond in a cavity.
bool ToolProxy::isFree(const Pose& toolInTooth) {
    const std::optional<bool> isClear = body_.isClearAt(toolInTooth);
    return isClear ? *isClear && !isEnclosed(toolInTooth) : query_.isFree(toolInTooth);
}

/// A new surface may stand a micron nearer than the one before. Steps back along the last contact, or along the shaft,
/// by the least of a few distances that is free.
bool ToolProxy::retractFromSurface(double farthest) {
    const Pose stuck = body_.pose();
    for (double step = kFirstStep; step < farthest; step *= 2) {
        for (const Vec3& direction : {exitDirection_, Vec3(stuck.rotation * Vec3::UnitZ())}) {
            const Pose pose{stuck.position + step * direction, stuck.rotation};
            if (!isFree(pose)) continue;
            body_.shiftTo(pose);
            return true;
        }
    }
    return false;
}

void ToolProxy::swapSurfaces() {
    surface_ = other_.surface;
    query_.setSurface(surface_);
    other_.surface = body_.setSurface(std::move(other_.surface), other_.near);
}

/// A bur in the cavity that it has just cut may be caught by a new surface on all sides, a micron deep: there is no way
/// out but far away. It stays in the surface before, where it is free, until it is free in the new one as well.
bool ToolProxy::revertSurface() {
    if (!std::exchange(isAtOldPose_, false)) return false;
    swapSurfaces();
    waitTime_ = 0;
    ++failedTries_;
    return true;
}

void ToolProxy::retryNewestSurface(double dt) {
    if (!waitTime_) return;
    *waitTime_ += dt;
    if (*waitTime_ + dt / 2 < kRetryInterval) return;
    swapSurfaces();
    waitTime_.reset();
    isAtOldPose_ = newSurface_ = true;
}

/// Moves the body, and frees it first where a new surface has caught it.
MoveResult ToolProxy::moveToward(const Pose& goal) {
    const Pose before = body_.pose();
    MoveResult move = body_.moveToward(goal);
    const double shortStep = failedTries_ < kMaxTries ? kSmallStep : kLongStep;
    if (move.status == MoveStatus::Overlapping &&
        (retractFromSurface(shortStep) || revertSurface() || retractFromSurface(kLastStep)))
        move = body_.moveToward(goal);
    if (!waitTime_ && move.status != MoveStatus::Overlapping) failedTries_ = 0;
    isAtOldPose_ &=
        body_.pose().position == before.position && body_.pose().rotation.coeffs() == before.rotation.coeffs();
    return move;
}

/// Whether the tool stands wholly inside the tooth, where it meets no triangle: when a cut tooth becomes whole again.
/// Its far end tells: it is the last to touch anything.
bool ToolProxy::isEnclosed(const Pose& toolInTooth) const {
    return surface_->closed && contains(*surface_, toolInTooth * farEnd_);
}

/// See ProxyState::deviceTip. A tool turns under its contacts about its centre.
Vec3 ToolProxy::deviceTip(const Pose& deviceInTooth) const {
    if (freedom_ == Freedom::Translation) return deviceInTooth.position;
    const Vec3 centre = tool_->centre();
    return deviceInTooth * centre - body_.pose().rotation * centre;
}

ProxyState ToolProxy::follow(const Pose& deviceInTooth, const Pose& goal, double dt) {
    if (mode_ == ContactMode::Penalty) return followByPenalty(deviceInTooth);
    ProxyState state;
    if (!placed_) placeNear(deviceInTooth);
    if (!placed_) return state;
    const Vec3 before = body_.pose().position;
    retryNewestSurface(dt);
    if (std::exchange(newSurface_, false) && isEnclosed(body_.pose())) {
        placed_ = false;
        return state;
    }
    const MoveResult move = moveToward(goal);
    if (move.status == MoveStatus::Overlapping) {
        placed_ = false;
        return state;
    }
    state.placed = true;
    state.proxy = body_.pose();
    state.deviceTip = deviceTip(deviceInTooth);
    state.offset = body_.pose().position - state.deviceTip;
    state.travel = (body_.pose().position - before).norm();
    if (move.status == MoveStatus::OutOfBudget) state.late = (goal.position - state.proxy.position).norm();
    // A tool that is late shall not pull back a hand that leaves.
    const bool isLeaving = move.status == MoveStatus::OutOfBudget && state.offset.dot(exitDirection_) <= 0;
    const int held = isLeaving ? 0 : move.contactCount;
    state.contacts = state.contactPointCount = held;
    const bool isOverBudget = move.status == MoveStatus::OutOfIterations || move.status == MoveStatus::OutOfBudget;
    const bool stuck = isOverBudget && held == 0 && !isLeaving;
    const bool paused = move.status == MoveStatus::Reached && goal.position != deviceInTooth.position;
    if (paused || (stuck && (touching_ || state.travel == 0))) holdWithoutContact(state);
    for (int i = 0; i < held; ++i) {
        const BodyContact& contact = move.contacts[i];
        state.held[i] = {contact.point, contact.normal, contact.share};
        fillContactPoint(state.held[i], contact.part, contact.tooth);
    }
    if (held > 0) {
        exitDirection_ = state.offset.norm() > 0 ? Vec3(state.offset.normalized()) : move.contacts[0].normal;
        lastContact_ = state.held[0];
    }
    touching_ = state.contacts > 0;
    return state;
}

/// The fixed budget ran out between two contacts, or before the first, or the tool shall not go all the way to the
/// hand: what stands between hand and proxy goes on holding, or the force would drop out while the hand presses.
void ToolProxy::holdWithoutContact(ProxyState& state) {
    const double depth = state.offset.norm();
    if (!(depth > 0)) return;
    state.contacts = state.contactPointCount = 1;
    state.held[0] = {state.proxy.position, state.offset / depth, depth, lastContact_.material, lastContact_.isAdjacent};
}

ProxyState ToolProxy::followByPenalty(const Pose& deviceInTooth) {
    ProxyState state;
    const Contact contact = query_.deepestPairAt(deviceInTooth);
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
