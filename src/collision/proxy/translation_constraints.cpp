// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/translation_constraints.h"

#include <algorithm>

#include "collision/proxy/plane_switch.h"

// God object: C. B. Zilles, J. K. Salisbury, "A Constraint-based God-object Method for Haptic Display", IROS 1995,
// section 4. Differs from the paper: the proxy has a shape, so each pair of triangles near it may add a constraint.

namespace tactooth {
namespace {

constexpr double kStaysMargins = 0.1;  // a shorter step is none, and needs no check

/// The corner of a pair's tool triangle that stands lowest over the plane, at the present pose, tooth's frame, mm.
Vec3 deepestPoint(const ProxyScene& state, const WatchedPair& watched) {
    const Triangle3 tool = state.tool->corners(watched.pair.tool);
    Vec3 deepest = state.pose * tool[0];
    for (const Vec3& corner : tool) {
        if (const Vec3 point = state.pose * corner; watched.plane.normal.dot(point) < watched.plane.normal.dot(deepest))
            deepest = point;
    }
    return deepest;
}

}  // namespace

Vec3 TranslationConstraints::predictShift(ProxyContext& context, const CandidateStep& step, double&) const {
    const ProxyScene& state = context.state;
    std::array<HalfSpace, kMaxHeld> halfSpaces;
    const Mat3 rotation = state.pose.rotation.toRotationMatrix();
    int count = 0;
    for (int i = 0; i < context.contacts.count; ++i) {
        WatchedPair& held = context.contacts.pairs[i];
        if (context.ensurePlane(held))
            halfSpaces[count++] = {held.plane.normal,
                                   std::min(0.0, -gapAt(*state.tool, held, rotation, state.pose.position))};
    }
    const auto answer = solveQp3(std::span(halfSpaces).first(static_cast<std::size_t>(count)),
                                 step.goal.position - state.pose.position, state.margin * kSolveTolerance);
    return answer.feasible ? answer.point : Vec3(Vec3::Zero());
}

void TranslationConstraints::add(const ProxyContext& context, const CandidateStep& step, const WatchedPair& watched) {
    const ProxyScene& state = context.state;
    const double gap = gapAt(*state.tool, watched, step.matrix, state.pose.position);
    // Without rotation, to stay is always allowed: a gap that rounding has left below the margin may stay so.
    const double offset = step.rotationFraction == 0 ? std::min(0.0, state.margin - gap) : state.margin - gap;
    set_.add(watched, {watched.plane.normal, offset});
}

void TranslationConstraints::restart(ProxyContext& context, const CandidateStep& step) {
    set_.clear();
    for (int i = 0; i < context.contacts.count; ++i) {
        if (context.ensurePlane(context.contacts.pairs[i])) add(context, step, context.contacts.pairs[i]);
    }
    for (const WatchedPair& watched : warmStart()) add(context, step, watched);
}

bool TranslationConstraints::solve(const ProxyContext& context, CandidateStep& step) {
    const ProxyScene& state = context.state;
    const double tolerance = state.margin * kSolveTolerance;
    const Qp3Result answer = set_.nearest(step.goal.position - state.pose.position, tolerance);
    if (!answer.feasible) {
        step.clipping.isRotationByList = false;  // a contact ends the rotation before the list does
        return false;
    }
    set_.setActive(answer);
    step.shift = answer.point;
    step.clipping.isClipped = false;
    step.clipping.isByList = step.clipping.isRotationByList;
    const double length = step.shift.norm();
    const double listed = context.horizon.coveredShare(state, step.shift);
    const double share = std::min(listed, length > 0 ? step.limits.allowance / length : 1);
    if (share >= 1) return true;
    step.clipping.isClipped = true;
    step.clipping.isByList |= listed <= share;
    const Qp3Result shorter = set_.nearest(0.9 * share * step.shift, tolerance);
    if (!shorter.feasible || !context.horizon.coversPosition(state.pose.position + shorter.point, state.margin)) {
        step.clipping.isRotationByList = shorter.feasible;  // the rotation pushes the tool beyond the list
        return false;
    }
    step.shift = shorter.point;
    return true;
}

bool TranslationConstraints::isStationary(const ProxyContext& context, const CandidateStep& step) const {
    return step.rotationFraction == 0 && !step.clipping.isClipped && set_.activeCount() > 0 &&
           step.shift.norm() <= kStaysMargins * context.state.margin;
}

void TranslationConstraints::storeContacts(ProxyContext& context, MoveResult& result) const {
    ActiveContacts& contacts = context.contacts;
    contacts.count = result.contactCount = set_.activeCount();
    for (int i = 0; i < contacts.count; ++i) {
        const WatchedPair& watched = contacts.pairs[i] = set_.watched(set_.active()[i]);
        result.contacts[i] = {watched.plane.normal, deepestPoint(context.state, watched), set_.multiplier(i),
                              watched.pair.part, watched.pair.tooth};
    }
}

/// Stores the inactive pairs of an iteration that has left the tool where it stood.
void TranslationConstraints::storeWarmStart(const ProxyScene& state) {
    warmStartCount_ = 0;
    for (int i = 0; i < set_.count() && warmStartCount_ < kMaxWarmStart; ++i) {
        if (!set_.isActive(i) && set_.watched(i).plane.stamp == state.poseStamp)
            warmStart_[warmStartCount_++] = set_.watched(i);
    }
}

bool TranslationConstraints::switchPlanes(ProxyContext& context, const Pose& goal) {
    storeWarmStart(context.state);
    PlaneSwitch planes(context, goal);
    for (int i = 0; i < context.contacts.count; ++i) {
        if (!context.ensurePlane(context.contacts.pairs[i])) return false;
        planes.addContact(context.contacts.pairs[i]);
    }
    for (WatchedPair& watched : warmStart()) planes.addPair(watched);
    return planes.run();
}

}  // namespace tactooth
