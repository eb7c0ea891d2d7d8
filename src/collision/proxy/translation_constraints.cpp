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
Vec3 deepestPoint(const ProxyScene& scene, const WatchedPair& watched) {
    const Triangle3 tool = scene.tool->corners(watched.pair.tool);
    Vec3 deepest = scene.pose * tool[0];
    for (const Vec3& corner : tool) {
        if (const Vec3 point = scene.pose * corner; watched.plane.normal.dot(point) < watched.plane.normal.dot(deepest))
            deepest = point;
    }
    return deepest;
}

}  // namespace

Vec3 TranslationConstraints::predictShift(ProxyContext& context, const CandidateStep& step, double&) const {
    const ProxyScene& scene = context.scene;
    std::array<HalfSpace, kMaxHeld> halfSpaces;
    const Mat3 rotation = scene.pose.rotation.toRotationMatrix();
    int count = 0;
    for (int i = 0; i < context.contacts.count; ++i) {
        WatchedPair& held = context.contacts.pairs[i];
        if (context.ensurePlane(held))
            halfSpaces[count++] = {held.plane.normal,
                                   std::min(0.0, -gapAt(*scene.tool, held, rotation, scene.pose.position))};
    }
    const auto answer = solveQp3(std::span(halfSpaces).first(static_cast<std::size_t>(count)),
                                 step.goal.position - scene.pose.position, scene.margin * kSolveTolerance);
    return answer.feasible ? answer.point : Vec3(Vec3::Zero());
}

void TranslationConstraints::add(const ProxyContext& context, const CandidateStep& step, const WatchedPair& watched) {
    const ProxyScene& scene = context.scene;
    const double gap = gapAt(*scene.tool, watched, step.matrix, scene.pose.position);
    // Without rotation, to stay is always allowed: a gap that rounding has left below the margin may stay so.
    const double offset = step.rotationFraction == 0 ? std::min(0.0, scene.margin - gap) : scene.margin - gap;
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
    const ProxyScene& scene = context.scene;
    const double tolerance = scene.margin * kSolveTolerance;
    const Qp3Result answer = set_.nearest(step.goal.position - scene.pose.position, tolerance);
    if (!answer.feasible) {
        step.clipping.isRotationByList = false;  // a contact ends the rotation before the list does
        return false;
    }
    set_.setActive(answer);
    step.shift = answer.point;
    step.clipping.isClipped = false;
    step.clipping.isByList = step.clipping.isRotationByList;
    const double length = step.shift.norm();
    const double listed = context.horizon.coveredShare(scene, step.shift);
    const double share = std::min(listed, length > 0 ? step.limits.allowance / length : 1);
    if (share >= 1) return true;
    step.clipping.isClipped = true;
    step.clipping.isByList |= listed <= share;
    const Qp3Result shorter = set_.nearest(0.9 * share * step.shift, tolerance);
    if (!shorter.feasible || !context.horizon.coversPosition(scene.pose.position + shorter.point, scene.margin)) {
        step.clipping.isRotationByList = shorter.feasible;  // the rotation pushes the tool beyond the list
        return false;
    }
    step.shift = shorter.point;
    return true;
}

bool TranslationConstraints::isStationary(const ProxyContext& context, const CandidateStep& step) const {
    return step.rotationFraction == 0 && !step.clipping.isClipped && set_.activeCount() > 0 &&
           step.shift.norm() <= kStaysMargins * context.scene.margin;
}

void TranslationConstraints::storeContacts(ProxyContext& context, MoveResult& result) const {
    ActiveContacts& contacts = context.contacts;
    contacts.count = result.contactCount = set_.activeCount();
    for (int i = 0; i < contacts.count; ++i) {
        const WatchedPair& watched = contacts.pairs[i] = set_.watched(set_.active()[i]);
        result.contacts[i] = {watched.plane.normal, deepestPoint(context.scene, watched), set_.multiplier(i),
                              watched.pair.part, watched.pair.tooth};
    }
}

/// Stores the inactive pairs of an iteration that has left the tool where it stood.
void TranslationConstraints::storeWarmStart(const ProxyScene& scene) {
    warmStartCount_ = 0;
    for (int i = 0; i < set_.count() && warmStartCount_ < kMaxWarmStart; ++i) {
        if (!set_.isActive(i) && set_.watched(i).plane.stamp == scene.poseStamp)
            warmStart_[warmStartCount_++] = set_.watched(i);
    }
}

bool TranslationConstraints::switchPlanes(ProxyContext& context, const Pose& goal) {
    storeWarmStart(context.scene);
    PlaneSwitch planes(context, goal);
    for (int i = 0; i < context.contacts.count; ++i) {
        if (!context.ensurePlane(context.contacts.pairs[i])) return false;
        planes.addContact(context.contacts.pairs[i]);
    }
    for (WatchedPair& watched : warmStart()) planes.addPair(watched);
    return planes.run();
}

}  // namespace tactooth
