// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/rotation_constraints.h"

#include <algorithm>
#include <cmath>

#include "collision/proxy/feature_gap.h"

// Six degrees of freedom: M. Ortega, S. Redon, S. Coquillart, "A Six Degree-of-Freedom God-Object Method for Haptic
// Display of Rigid Bodies with Surface Properties", IEEE TVCG 13(3), 2007, section 4 (Gauss' principle: of all motions
// that the contacts allow, the nearest to the free one in the metric of the kinetic energy). Differs from the paper: a
// contact bounds the position of a corner of the tool along a plane, not its acceleration. It is made linear anew where
// the rotation of the step has bent the corner's path.

namespace tactooth {
namespace {

constexpr int kMaxTries = 3;  // to make two features linear; then the whole triangle is kept in front of its plane

Quat rotationBy(const Vec3& turn) {
    const double angle = turn.norm();
    return angle > 0 ? Quat(Eigen::AngleAxisd(angle, turn / angle)) : Quat::Identity();
}

/// The rotation vector of the shorter rotation.
Vec3 rotationBetween(const Quat& from, const Quat& to) {
    const Quat between = to * from.conjugate();
    const double sine = between.vec().norm();
    if (!(sine > 0)) return Vec3::Zero();
    const double half = std::atan2(sine, std::abs(between.w()));
    return (between.w() < 0 ? -2 : 2) * half / sine * between.vec();
}

Vec6 asVec6(const Vec3& shift, const Vec3& turn) {
    Vec6 both;
    both.head<3>() = shift;
    both.tail<3>() = turn;
    return both;
}

}  // namespace

/// Sets the end of the step: the tool's centre shifted, and the tool rotated about it.
void RotationConstraints::moveTo(const ProxyScene& scene, const Vec3& shift, const Vec3& turn, CandidateStep& step) {
    TACTOOTH_ASSERT(shift.allFinite() && turn.allFinite());
    shift_ = shift;
    turn_ = turn;
    step.rotation = (rotationBy(turn) * scene.pose.rotation).normalized();
    step.matrix = step.rotation.toRotationMatrix();
    step.shift = shift + (step.startMatrix - step.matrix) * scene.tool->centre();
}

/// The number of the constraint that keeps two features apart; the number of constraints if there is none.
int RotationConstraints::find(const WatchedPair& watched, const FeaturePair& features) const {
    int number = 0;
    while (number < set_.count() &&
           !(set_.watched(number).pair == watched.pair && features_[number].features == features)) {
        ++number;
    }
    return number;
}

/// The features of a pair to keep apart, so that the step does not bring the pair together.
FeaturePair RotationConstraints::featuresToConstrain(const ProxyScene& scene, const CandidateStep& step,
                                                     const WatchedPair& watched) const {
    if (const auto blocking = blockingFeatures(scene, step, watched)) {
        const int number = find(watched, *blocking);
        if (number == set_.count() || features_[number].tries < kMaxTries) return *blocking;
    }
    return lowestCorner(scene, step, watched);
}

void RotationConstraints::add(const ProxyContext& context, CandidateStep& step, const WatchedPair& watched) {
    const ProxyScene& scene = context.scene;
    const FeaturePair features = featuresToConstrain(scene, step, watched);
    const double straight = std::sqrt(scene.margin / scene.tool->radius());
    if (features.kind == FeaturePair::Kind::CornerOverPlane && turn_.norm() > straight) {
        step.limits.rotationBound = straight;
    } else {
        addFeatures(scene, step, watched, features);
    }
}

/// Adds the half-space of two features, linear in shift and rotation. A rotation bends the path. Where the path bends
/// away, the slope at the start of the step keeps the features apart, else the slope at its end.
void RotationConstraints::addFeatures(const ProxyScene& scene, const CandidateStep& step, const WatchedPair& watched,
                                      const FeaturePair& features) {
    const int number = find(watched, features);
    const bool isNew = number == set_.count();
    const double length = scene.characteristicLength();
    const Vec3 centre = scene.pose * scene.tool->centre();
    const auto slopeOf = [&](const FeatureGap& gap, const Vec3& about) {
        return asVec6(gap.normal, (gap.point - about).cross(gap.normal) / length);
    };
    const FeatureGap here = gapOf(scene, watched, features, scene.pose);
    const FeatureGap there = gapOf(scene, watched, features, step.end(scene.pose));
    HalfSpace6 space;
    space.normal = slopeOf(there, centre + shift_);
    space.offset = scene.margin - there.gap + space.normal.dot(asVec6(shift_, turn_ * length));
    if (space.offset > scene.margin - here.gap) space = {slopeOf(here, centre), scene.margin - here.gap};
    // To stay is always allowed: a gap that rounding has left below the margin may stay so.
    space.offset = std::min(0.0, space.offset);
    set_.set(number, watched, space);
    features_[number] = {features, isNew ? 1 : features_[number].tries + 1, there.normal, there.point};
}

/// The shift and the rotation nearest to those of the goal under the constraints so far.
Qp6Result RotationConstraints::nearest(const ProxyScene& scene, const Pose& goal) const {
    const Vec3 centre = scene.tool->centre();
    const Vec6 wanted = asVec6(goal * centre - scene.pose * centre,
                               rotationBetween(scene.pose.rotation, goal.rotation) * scene.characteristicLength());
    return set_.nearest(wanted, scene.margin * kSolveTolerance);
}

Vec3 RotationConstraints::predictShift(ProxyContext& context, CandidateStep& step, double& turn) {
    const ProxyScene& scene = context.scene;
    step.startMatrix = scene.pose.rotation.toRotationMatrix();
    restart(context, step);
    const Qp6Result answer = nearest(scene, step.goal);
    if (!answer.feasible) return Vec3::Zero();
    moveTo(scene, answer.point.head<3>(), answer.point.tail<3>() / scene.characteristicLength(), step);
    turn = chordBetween(step.rotation, scene.pose.rotation);
    return step.shift;
}

void RotationConstraints::restart(ProxyContext& context, CandidateStep& step) {
    set_.clear();
    moveTo(context.scene, Vec3::Zero(), Vec3::Zero(), step);
    for (int i = 0; i < context.contacts.count; ++i) {
        WatchedPair& watched = context.contacts.pairs[i];
        if (!context.ensurePlane(watched)) continue;
        if (stillTouch(context.scene, watched, context.contacts.features[i]))
            addFeatures(context.scene, step, watched, context.contacts.features[i]);
    }
}

bool RotationConstraints::solve(const ProxyContext& context, CandidateStep& step) {
    const ProxyScene& scene = context.scene;
    const Qp6Result answer = nearest(scene, step.goal);
    if (!answer.feasible) return false;
    set_.setActive(answer);
    const Vec3 shift = answer.point.head<3>();
    const Vec3 turn = answer.point.tail<3>() / scene.characteristicLength();
    const double share = shareAllowed(context, shift, turn, step);
    TACTOOTH_ASSERT(share >= 0 && share <= 1);
    step.clipping.isClipped = share < 1;
    moveTo(scene, share * shift, share * turn, step);
    return true;
}

/// The share of a step that the limits and the neighbour list leave. With a step, each share of it is allowed too.
double RotationConstraints::shareAllowed(const ProxyContext& context, const Vec3& shift, const Vec3& turn,
                                         CandidateStep& step) {
    const ProxyScene& scene = context.scene;
    const StepLimits& limits = step.limits;
    const double length = shift.norm() + turn.norm() * scene.tool->radius();
    double limited = length > limits.allowance ? limits.allowance / length : 1;
    if (limited * turn.norm() > limits.rotationBound) limited = limits.rotationBound / turn.norm();
    const auto isCovered = [&](double share) {
        moveTo(scene, share * shift, share * turn, step);
        return context.horizon.coversPosition(scene.pose.position + step.shift, scene.margin) &&
               chordBetween(step.rotation, scene.pose.rotation) <= limits.rotationLeft;
    };
    step.clipping.isByList = !isCovered(limited);
    if (!step.clipping.isByList) return limited;
    double inside = 0;
    double outside = limited;
    for (int i = 0; i < 10; ++i) {
        const double middle = (inside + outside) / 2;
        (isCovered(middle) ? inside : outside) = middle;
    }
    return inside;
}

void RotationConstraints::storeContacts(ProxyContext& context, MoveResult& result) const {
    ActiveContacts& contacts = context.contacts;
    contacts.count = result.contactCount = set_.activeCount();
    for (int i = 0; i < contacts.count; ++i) {
        const int number = set_.active()[i];
        const FeatureContact& touch = features_[number];
        const NearPair& pair = set_.watched(number).pair;
        contacts.pairs[i] = set_.watched(number);
        contacts.features[i] = touch.features;
        result.contacts[i] = {touch.normal, touch.point, set_.multiplier(i), pair.part, pair.tooth};
    }
}

}  // namespace tactooth
