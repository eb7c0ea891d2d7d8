// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/proxy_move.h"

#include <algorithm>
#include <cmath>
#include <limits>

// God object: C. B. Zilles, J. K. Salisbury, "A Constraint-based God-object Method for Haptic Display", IROS 1995; for
// a body with a shape: M. Ortega, S. Redon, S. Coquillart, "A Six Degree-of-Freedom God-Object Method for Haptic
// Display of Rigid Bodies with Surface Properties", IEEE TVCG 13(3), 2007, sections 3-4.
//
// One iteration: the planes that separate the pairs of triangles at the present, free pose bound a convex region of
// steps that are safe in the whole motion. The step nearest to the goal inside that region is found lazily: solve with
// the planes met so far, check the answer for a pair that it would bring together, add the plane of that pair, solve
// again. Then the proxy makes the step and the planes are found anew. Differs from Ortega: contacts need not be touched
// one after the other, and a finely meshed surface costs no more iterations than a coarse one.

namespace tactooth {
namespace {

constexpr int kMaxIterations = 60;        // 3 at 1 cm/s, 5 at 10 cm/s; at 1 m/s on meshes of 20 um up to 56 were seen
constexpr int kMaxPlaneSwitches = 8;      // of a move: a corner of the tool has six triangles
constexpr int kFewestToRecheck = 2;       // contacts: together they may stop what other planes would let move on
constexpr double kMarginOfRadius = 1e-7;  // 0.3 nm for a 6 mm bur
constexpr double kMarginOfPosition = 1e-10;  // keeps the margin above rounding far from the origin
constexpr double kSettledMargins = 10;       // an iteration that moves less than this many margins ends the move
constexpr double kLeastRotation = 1e-3;      // of the rotation to the goal: a smaller share becomes none

// The longest step of an iteration. It need not be right: a clipped step is followed by a longer one.
constexpr double kGoalPrediction = 2;       // displacements of the goal
constexpr double kTrustGrowth = 8;          // steps of the iteration before
constexpr double kLeastTrustMargins = 200;  // 0.2 um for a bur of 20 mm

/// The share of a rotation that ends within a smaller one, both as chords: the share of an arc has more than its share
/// of the chord. A little less, since a proxy that rounding has put beyond the end of its list would have to build one.
double shareWithin(double limit, double turn) {
    constexpr double kTinyGap = 1e-6;
    return (1 - kTinyGap) * std::asin(limit / 2) / std::asin(std::min(turn / 2, 1.0));
}

}  // namespace

template <class Constraints>
MoveResult ProxyMove<Constraints>::run() {
    begin();
    while (result_.status == MoveStatus::OutOfIterations && result_.iterations < kMaxIterations) {
        if (hasStepped_ && isCutShort()) break;
        ++result_.iterations;
        Violation found = Violation::None;
        if (prepareStep() && findSafeStep(found)) {
            acceptStep();
        } else if (!retriesWithShorterList()) {
            if (found == Violation::Overlapping && result_.status == MoveStatus::OutOfIterations)
                result_.status = MoveStatus::Overlapping;
            break;
        }
    }
    end();
    return result_;
}

/// Sets the margin, the displacement of the goal and the length of the first step. A proxy that waits or rests does
/// not move.
template <class Constraints>
void ProxyMove<Constraints>::begin() {
    ProxyScene& scene = context_.scene;
    NeighbourHorizon& horizon = context_.horizon;
    const Pose& goal = step_.goal;
    context_.budget.beginMove();
    const double position = std::max(goal.position.cwiseAbs().maxCoeff(), scene.pose.position.cwiseAbs().maxCoeff());
    scene.margin = kMarginOfRadius * scene.tool->radius() + kMarginOfPosition * position;
    const Pose& from = settled_.origin(scene.pose);
    horizon.beginMove((goal.position - from.position).norm(), chordBetween(goal.rotation, from.rotation));
    settled_.beginMove(goal);
    trust_ = kGoalPrediction * horizon.goalShift() * context_.budget.stepScale();
    const bool isLimited = context_.budget.isLimited();
    const bool isWithinList = horizon.covers(scene.pose, scene.margin);
    const bool mayWait = horizon.mayWait(scene.pose, isLimited);
    mayWait_ = mayWait && isWithinList;
    isAhead_ = mayWait && !isWithinList;
    const bool rests = isLimited && horizon.wait().takeRest();
    result_.status = rests || isAhead_ ? MoveStatus::OutOfBudget : MoveStatus::OutOfIterations;
}

/// Whether the move ends before the next step: the allowance is used up, or the list has ended. To build a list takes
/// longer than the rest of a move, so a move with a budget builds one at most.
template <class Constraints>
bool ProxyMove<Constraints>::isCutShort() const {
    if (context_.budget.isExhausted()) return true;
    const bool hasBuilt = context_.budget.isLimited() && context_.horizon.rebuilds() > 0;
    return step_.clipping.isByList && (mayWait_ || hasBuilt);
}

/// Makes sure that the neighbour list covers the motion expected in this move. `turn` is the chord of the rotation
/// expected. False if no more lists may be built.
template <class Constraints>
bool ProxyMove<Constraints>::ensureList(double& turn) {
    const ProxyScene& scene = context_.scene;
    NeighbourHorizon& horizon = context_.horizon;
    const bool isFirst = result_.iterations == 1;
    if (!isFirst && horizon.list().made() && !step_.clipping.isByList) return true;
    const bool isLimited = context_.budget.isLimited();
    const Vec3 displacement = constraints_.predictShift(context_, step_, turn);
    const bool ends = !horizon.list().made() || step_.clipping.isByList ||
                      horizon.isExhausted(scene.pose, displacement, turn, isLimited);
    if (!ends) return true;
    if (isFirst && horizon.covers(scene.pose, scene.margin) &&
        (context_.budget.isStarved() || horizon.mayWait(scene.pose, isLimited)))
        return true;
    if (!horizon.mayRebuild(scene.tool->radius())) return false;
    horizon.rebuild(scene, displacement, turn);
    return true;
}

/// Makes sure of the list, and limits the step to what the list covers. False if the list does not cover the pose.
template <class Constraints>
bool ProxyMove<Constraints>::prepareStep() {
    const ProxyScene& scene = context_.scene;
    double turn = chordBetween(step_.goal.rotation, scene.pose.rotation);
    if (!ensureList(turn)) return false;
    const double rotationLeft = context_.horizon.rotationLeft(scene.pose.rotation);
    if (!context_.horizon.coversPosition(scene.pose.position, scene.margin) || rotationLeft < 0) return false;
    const double fraction = turn > rotationLeft ? shareWithin(rotationLeft, turn) : 1;
    TACTOOTH_ASSERT(fraction >= 0 && fraction <= 1);
    step_.rotatesFully = Constraints::kRotates || fraction >= 1;
    step_.clipping.isRotationByList = !step_.rotatesFully;
    step_.rotateBy(scene.pose.rotation, turn > 0 && !Constraints::kRotates ? fraction : 0);
    step_.limits = {std::max(trust_, kLeastTrustMargins * scene.margin), rotationLeft,
                    std::numeric_limits<double>::infinity()};
    return true;
}

/// Adds constraints until the step that they allow is safe. False if there is none within the limit of solutions;
/// `found` is what the last check found.
template <class Constraints>
bool ProxyMove<Constraints>::findSafeStep(Violation& found) {
    constraints_.restart(context_, step_);
    for (int i = 0; i < kMaxSolutions; ++i) {
        if (!constraints_.solve(context_, step_)) {
            if (step_.rotationFraction == 0) return false;
            rotateLess();
            continue;
        }
        context_.budget.add(cost::kSolution);
        bool isSafe = i == 0 && constraints_.isStationary(context_, step_);
        WatchedPair violator;
        if (!isSafe) {
            SweepQuery query(constraints_.set());
            found = sweep_.check(context_, step_, query, violator);
            if (found == Violation::Overlapping || found == Violation::OutOfBudget) return false;
            isSafe = found == Violation::None;
        }
        if (isSafe) {
            if (constraints_.isStationary(context_, step_)) step_.shift.setZero();
            return true;
        }
        sweep_.addRecent(violator.pair);
        if (!constrain(violator, i)) return false;
    }
    return false;
}

/// Tries a quarter of the rotation, and in the end none.
template <class Constraints>
void ProxyMove<Constraints>::rotateLess() {
    step_.rotatesFully = false;
    step_.rotateBy(context_.scene.pose.rotation,
                   step_.rotationFraction > kLeastRotation ? step_.rotationFraction / 4 : 0);
    constraints_.restart(context_, step_);
}

/// Keeps a pair apart that the step would bring together. Too many pairs mean that the step is too long: then a shorter
/// one is tried. False if the step is as short as it may be. `solution`: number of the answer in this iteration.
template <class Constraints>
bool ProxyMove<Constraints>::constrain(const WatchedPair& violator, int solution) {
    if (!constraints_.set().isFull() && solution % kManySolutions != kManySolutions - 1) {
        constraints_.add(context_, step_, violator);
        return true;
    }
    if (!(step_.limits.allowance > kSettledMargins * context_.scene.margin)) return false;
    step_.limits.allowance /= 8;
    constraints_.restart(context_, step_);
    return true;
}

/// If there was no safe step because the list is full: clears it for a shorter one. With a budget that one is built in
/// a later move, unless somebody gives one before. Whether this move goes on.
template <class Constraints>
bool ProxyMove<Constraints>::retriesWithShorterList() {
    NeighbourHorizon& horizon = context_.horizon;
    if (!horizon.shortenFullList()) return false;
    if (context_.budget.isLimited()) {
        horizon.wait().beginRest();
        result_.status = MoveStatus::OutOfBudget;
        return false;
    }
    horizon.discountRebuild();
    return true;
}

/// Moves the proxy by the step, and decides whether it has arrived.
template <class Constraints>
void ProxyMove<Constraints>::acceptStep() {
    ProxyScene& scene = context_.scene;
    const double turned = chordBetween(step_.rotation, scene.pose.rotation) * scene.tool->radius();
    const double moved = step_.shift.norm();
    const bool stays = !Constraints::kRotates && step_.rotationFraction == 0 && step_.shift.isZero(0);
    TACTOOTH_ASSERT(step_.shift.allFinite());
    scene.pose.rotation = step_.rotation;
    scene.pose.position += step_.shift;
    if (!stays) ++scene.poseStamp;
    constraints_.storeContacts(context_, result_);
    constraints_.clearWarmStart();
    hasStepped_ = true;
    trust_ = kTrustGrowth * (step_.clipping.isClipped ? step_.limits.allowance : moved);
    if (step_.clipping.isClipped || step_.clipping.isByList) return;
    if (step_.rotatesFully && context_.contacts.count == 0) {
        result_.status = MoveStatus::Reached;
    } else if (moved + turned <= kSettledMargins * scene.margin) {
        trySettle();
    }
}

/// Ends the move in contact, unless other planes of the contacts let the tool move on, or the contacts are due for a
/// fresh check. Then the next iteration begins without them.
template <class Constraints>
void ProxyMove<Constraints>::trySettle() {
    trust_ = kGoalPrediction * context_.horizon.goalShift();
    if constexpr (!Constraints::kRotates) {
        if (planeSwitches_++ < kMaxPlaneSwitches && constraints_.switchPlanes(context_, step_.goal)) return;
    }
    constexpr int kFewest = Constraints::kRotates ? 1 : kFewestToRecheck;
    ActiveContacts& contacts = context_.contacts;
    if (hasRechecked_ || contacts.count < kFewest || settled_.isKnown(contacts)) {
        result_.status = MoveStatus::InContact;
    } else {
        hasRechecked_ = true;
        trust_ = 0;  // a short step is enough to tell
        contacts.count = 0;
        sweep_.clearRecent();
    }
}

/// Settles the waiting, the budget and the memory of the move.
template <class Constraints>
void ProxyMove<Constraints>::end() {
    if (result_.status == MoveStatus::OutOfIterations && isCutShort()) result_.status = MoveStatus::OutOfBudget;
    context_.horizon.wait().endMove(isAhead_ || (mayWait_ && step_.clipping.isByList));
    context_.budget.endMove(result_.status == MoveStatus::OutOfBudget, hasStepped_);
    result_.distances = context_.budget.distances();
    result_.work = context_.budget.work();
    settled_.endMove(result_, context_.contacts);
}

template class ProxyMove<TranslationConstraints>;
template class ProxyMove<RotationConstraints>;

}  // namespace tactooth
