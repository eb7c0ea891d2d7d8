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

constexpr double kPatience = 0.008;  // s from one try of a surface that caught the tool to the next
constexpr int kManyTries = 2;        // in vain: what catches the tool will not go away

}  // namespace

ToolProxy::ToolProxy(std::shared_ptr<const ToolShape> tool, std::shared_ptr<const Surface> surface, ContactMode mode,
                     Freedom freedom)
    : tool_(std::move(tool)),
      surface_(surface),
      mode_(mode),
      freedom_(freedom),
      body_(tool_, freedom),
      query_(tool_, surface),
      other_{nullptr, PairList(*tool_)} {
    body_.setSurface(std::move(surface));
    for (const Vec3f& vertex : tool_->mesh().vertices) {
        if (vertex.z() > farEnd_.z()) farEnd_ = vertex.cast<double>();
    }
}

std::shared_ptr<const Surface> ToolProxy::setSurface(std::shared_ptr<const Surface> surface) {
    surface_ = surface;
    newSurface_ = true;
    isWhereBefore_ = false;
    waited_.reset();
    query_.setSurface(surface);
    return body_.setSurface(std::move(surface));
}

bool ToolProxy::setSurface(FeltSurface& felt) {
    const std::optional<Pose> place = std::exchange(felt.place, std::nullopt);
    if (!placed_) waited_.reset();
    const bool isNew = takeSurface(felt);
    if (!placed_ && place) {
        body_.shiftTo(*place);
        placed_ = true;
    }
    return isNew;
}

bool ToolProxy::takeSurface(FeltSurface& felt) {
    if (waited_ && felt.surface == other_.surface) {
        std::swap(other_.near, felt.near);
        return false;
    }
    const bool isNew = surface_ != felt.surface;
    const bool hasBeenFelt = !newSurface_;
    surface_ = felt.surface;
    felt.surface = body_.setSurface(std::move(felt.surface), felt.near);
    if (!isNew) return false;
    newSurface_ = true;
    query_.setSurface(surface_);
    waited_.reset();
    if (!hasBeenFelt && isWhereBefore_) return true;  // the tool still stands in the one before that
    std::swap(other_, felt);                          // the caller frees the one before that
    isWhereBefore_ = placed_ && hasBeenFelt;
    return true;
}

void ToolProxy::tellWhatHolds(HeldAt& held, std::uint32_t part, std::uint32_t triangle) const {
    const SurfacePart& surface = partOf(*surface_, part);
    held.material = static_cast<MaterialId>(surface.tag(triangle));
    held.isAround = surface.isAround(triangle);
}

/// The first pose: the hand's own, or the nearest free one if the hand starts inside the tooth and nobody else looks
/// for it.
void ToolProxy::placeNear(const Pose& handInTooth) {
    isWhereBefore_ = false;
    if (query_.isFree(handInTooth)) {
        body_.placeAt(handInTooth);
        placed_ = true;
        return;
    }
    if (!placesItself_) return;
    const Contact contact = query_.at(handInTooth);
    if (!(contact.depth > 0)) return;  // no way out was found: there is no force to make up
    body_.placeAt(query_.freePose());
    placed_ = true;
}

/// What the body knows of its surroundings answers at once; to look for what is near takes a millisecond in a cavity.
bool ToolProxy::isFree(const Pose& toolInTooth) {
    const std::optional<bool> isClear = body_.isClearAt(toolInTooth);
    return isClear ? *isClear && !isSwallowed(toolInTooth) : query_.isFree(toolInTooth);
}

/// A new surface may stand a micron nearer than the one before. Steps back along the last contact, or along the shaft,
/// by the least of a few distances that is free.
bool ToolProxy::stepOutOfSurface(double farthest) {
    const Pose stuck = body_.pose();
    for (double step = kFirstStep; step < farthest; step *= 2) {
        for (const Vec3& direction : {wayOut_, Vec3(stuck.rotation * Vec3::UnitZ())}) {
            const Pose pose{stuck.position + step * direction, stuck.rotation};
            if (!isFree(pose)) continue;
            body_.shiftTo(pose);
            return true;
        }
    }
    return false;
}

void ToolProxy::exchangeSurfaces() {
    surface_ = other_.surface;
    query_.setSurface(surface_);
    other_.surface = body_.setSurface(std::move(other_.surface), other_.near);
}

/// A bur in the cavity that it has just cut may be caught by a new surface on all sides, a micron deep: there is no way
/// out but far away. It stays in the surface before, where it is free, until it is free in the new one as well.
bool ToolProxy::goBackToSurfaceBefore() {
    if (!std::exchange(isWhereBefore_, false)) return false;
    exchangeSurfaces();
    waited_ = 0;
    ++triesInVain_;
    return true;
}

void ToolProxy::tryNewestSurface(double dt) {
    if (!waited_) return;
    *waited_ += dt;
    if (*waited_ + dt / 2 < kPatience) return;
    exchangeSurfaces();
    waited_.reset();
    isWhereBefore_ = newSurface_ = true;
}

/// Moves the body, and frees it first where a new surface has caught it.
MoveResult ToolProxy::moveToward(const Pose& goal) {
    const Pose before = body_.pose();
    MoveResult move = body_.moveToward(goal);
    const double shortStep = triesInVain_ < kManyTries ? kSmallStep : kLongStep;
    if (move.status == MoveStatus::Overlapping &&
        (stepOutOfSurface(shortStep) || goBackToSurfaceBefore() || stepOutOfSurface(kLastStep)))
        move = body_.moveToward(goal);
    if (!waited_ && move.status != MoveStatus::Overlapping) triesInVain_ = 0;
    isWhereBefore_ &=
        body_.pose().position == before.position && body_.pose().rotation.coeffs() == before.rotation.coeffs();
    return move;
}

/// Whether the tool stands wholly inside the tooth, where it meets no triangle: when a cut tooth becomes whole again.
/// Its far end tells: it is the last to touch anything.
bool ToolProxy::isSwallowed(const Pose& toolInTooth) const {
    return surface_->closed && contains(*surface_, toolInTooth * farEnd_);
}

/// See ProxyState::handTip. A tool turns under its contacts about its centre.
Vec3 ToolProxy::handTip(const Pose& handInTooth) const {
    if (freedom_ == Freedom::Shift) return handInTooth.position;
    const Vec3 centre = tool_->centre();
    return handInTooth * centre - body_.pose().rotation * centre;
}

ProxyState ToolProxy::follow(const Pose& handInTooth, const Pose& goal, double dt) {
    if (mode_ == ContactMode::Penalty) return followAsPenalty(handInTooth);
    ProxyState state;
    if (!placed_) placeNear(handInTooth);
    if (!placed_) return state;
    const Vec3 before = body_.pose().position;
    tryNewestSurface(dt);
    if (std::exchange(newSurface_, false) && isSwallowed(body_.pose())) {
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
    state.handTip = handTip(handInTooth);
    state.offset = body_.pose().position - state.handTip;
    state.travel = (body_.pose().position - before).norm();
    if (move.status == MoveStatus::OutOfWork) state.late = (goal.position - state.proxy.position).norm();
    // A tool that is late shall not pull back a hand that leaves.
    const bool isLeaving = move.status == MoveStatus::OutOfWork && state.offset.dot(wayOut_) <= 0;
    const int held = isLeaving ? 0 : move.contactCount;
    state.contacts = state.heldCount = held;
    const bool isLate = move.status == MoveStatus::OutOfRounds || move.status == MoveStatus::OutOfWork;
    const bool stuck = isLate && held == 0 && !isLeaving;
    const bool paused = move.status == MoveStatus::Reached && goal.position != handInTooth.position;
    if (paused || (stuck && (touching_ || state.travel == 0))) holdWithoutContact(state);
    for (int i = 0; i < held; ++i) {
        const BodyContact& contact = move.contacts[i];
        state.held[i] = {contact.point, contact.normal, contact.share};
        tellWhatHolds(state.held[i], contact.part, contact.tooth);
    }
    if (held > 0) {
        wayOut_ = state.offset.norm() > 0 ? Vec3(state.offset.normalized()) : move.contacts[0].normal;
        lastHeld_ = state.held[0];
    }
    touching_ = state.contacts > 0;
    return state;
}

/// The fixed budget ran out between two contacts, or before the first, or the tool shall not go all the way to the
/// hand: what stands between hand and proxy goes on holding, or the force would drop out while the hand presses.
void ToolProxy::holdWithoutContact(ProxyState& state) {
    const double depth = state.offset.norm();
    if (!(depth > 0)) return;
    state.contacts = state.heldCount = 1;
    state.held[0] = {state.proxy.position, state.offset / depth, depth, lastHeld_.material, lastHeld_.isAround};
}

ProxyState ToolProxy::followAsPenalty(const Pose& handInTooth) {
    ProxyState state;
    const Contact contact = query_.deepestPairAt(handInTooth);
    state.placed = true;
    state.handTip = handInTooth.position;
    state.offset = contact.depth * contact.normal;
    state.proxy = {handInTooth.position + state.offset, handInTooth.rotation};
    state.contacts = contact.contacts;
    if (contact.depth > 0) {
        state.heldCount = 1;
        state.held[0] = {contact.point + state.offset, contact.normal, contact.depth};
        tellWhatHolds(state.held[0], contact.part, contact.tooth);
    }
    return state;
}

}  // namespace tactooth
