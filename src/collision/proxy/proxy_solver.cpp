// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/proxy_solver_iteration.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "collision/narrow/gjk.h"

// God object: C. B. Zilles, J. K. Salisbury, "A Constraint-based God-object Method for Haptic Display", IROS 1995; for
// a body with a shape: M. Ortega, S. Redon, S. Coquillart, "A Six Degree-of-Freedom God-Object Method for Haptic
// Display of Rigid Bodies with Surface Properties", IEEE TVCG 13(3), 2007, sections 3-4.
//
// One round: the planes that separate the pairs of triangles at the present, free pose bound a convex region of moves
// that are all safe, the whole way. The move nearest to the goal inside that region is found lazily: solve with the
// planes met so far, look for a pair that the answer would bring together, add its plane, solve again. Then the
// body moves and the planes are found anew. Differs from Ortega: contacts need not be touched one after the other, and
// a finely meshed surface costs no more rounds than a coarse one. The planes are in sliding_body_planes.cpp.

namespace tactooth {
namespace {

constexpr int kMaxIterations = 60;  // 3 at 1 cm/s, 5 at 10 cm/s; at 1 m/s on meshes of 20 um up to 56 were seen
constexpr int kManySolutions = kMaxPlanesPerIteration + 1;  // of a round: more come of a turn that does not settle
constexpr int kMaxSolutions = 8 * kManySolutions;
constexpr int kMaxPlanesChanged = 8;         // in a move, where it had settled: a corner of the tool has six triangles
constexpr int kFewestToRequery = 2;          // planes: together they may stop what other ones would let go on
constexpr int kUnchangedMoves = 8;           // moves: a body that the same pairs hold is looked at afresh so often
constexpr double kMarginOfRadius = 1e-7;     // 0.3 nm for a 6 mm bur
constexpr double kMarginOfPosition = 1e-10;  // keeps the margin above rounding far from the origin
constexpr double kSettledMargins = 10;       // a round that moves less than this many margins ends the move
constexpr double kStaysMargins = 0.1;    // a way on that is shorter is none, and no look for what is in it is needed
constexpr double kLeastRotation = 1e-3;  // of the turn wanted: below it, the tool is held in its present orientation

// The list of what is near: a longer one lasts longer and costs more in every round.
constexpr double kStride = 1.2;         // ways of the hand that a list should last, and so much more:
constexpr double kAhead = 6;            // of the least skin
constexpr double kMaxDeviation = 0.25;  // of both: how far the tool may leave the way expected
constexpr double kTrusted = 0.95;       // of the skin: leaves room for rounding

constexpr int kMaxWaits = 8;  // moves: a list for a bur of 2.3 mm in its own cavity comes within eight ticks

// Lists of a move: the rest of the way waits for a tick. A hand that was lost for a while leaps, and did not lead the
// tool around the tooth.
constexpr int kMaxLists = 40;
constexpr int kMaxListsOfJump = 28;
constexpr double kJump = 0.5;       // of the tool's radius: 5 mm for a bur with its shank, which no hand goes in a tick
constexpr int kUnchangedLists = 8;  // as long as the first; each of those to come is twice as long

// The longest step of a round. It need not be right: a step that was cut short is followed by a longer one.
constexpr double kGoalPrediction = 2;       // ways of the hand
constexpr double kTrustGrowth = 8;          // steps of the round before
constexpr double kLeastTrustMargins = 200;  // 0.2 um for a bur of 20 mm

/// The share of a turn that ends within a shorter one; both as chords, of which a share of an arc has more than its
/// own. A hair less: a body that rounding has put beyond the end of its list would have to make another.
double shareWithin(double limit, double turn) {
    constexpr double kTinyGap = 1e-6;
    return (1 - kTinyGap) * std::asin(limit / 2) / std::asin(std::min(turn / 2, 1.0));
}

}  // namespace

ProxySolver::ProxySolver(std::shared_ptr<const ToolShape> tool, Freedom freedom)
    : tool_(std::move(tool)), freedom_(freedom), list_(*tool_) {}

std::shared_ptr<const Surface> ProxySolver::setSurface(std::shared_ptr<const Surface> surface) {
    enter(surface);
    list_.clear();
    return surface;
}

std::shared_ptr<const Surface> ProxySolver::setSurface(std::shared_ptr<const Surface> surface, NeighbourList& near) {
    if (surface != surface_) enter(surface);  // else all that is known of it still holds
    std::swap(list_, near);
    isListExternal_ = hasListProvider_ = true;
    listWaits_ = listRests_ = 0;
    return surface;
}

void ProxySolver::enter(std::shared_ptr<const Surface>& surface) {
    std::swap(surface_, surface);
    heldCount_ = lastHeldCount_ = 0;
    isSettled_ = false;
    recent_.clear();
}

void ProxySolver::placeAt(const Pose& toolInTooth) {
    shiftTo(toolInTooth);
    list_.clear();
}

void ProxySolver::shiftTo(const Pose& toolInTooth) {
    pose_ = toolInTooth;
    ++poseStamp_;
    heldCount_ = lastHeldCount_ = 0;
    lastGoal_ = toolInTooth;
    isLagging_ = isBudgetSpent_ = isSettled_ = false;
    listRests_ = 0;
    stepScale_ = 1;
    recent_.clear();
}

std::optional<bool> ProxySolver::isClearAt(const Pose& toolInTooth) {
    const bool rotationIsListed = list_.chordTo(toolInTooth.rotation) <= list_.contactMargin().turn * kTrusted;
    if (!list_.made() || !isListed(toolInTooth.position) || !rotationIsListed) return std::nullopt;
    const ToolMotion still = list_.motion(toolInTooth, toolInTooth, 0, {});
    const std::span<const std::uint32_t> packets = list_.within(still);
    if (list_.isFull()) return std::nullopt;
    for (const std::uint32_t first : packets) {
        for (std::uint32_t near = list_.uncertainClusters(first, still); near != 0; near &= near - 1) {
            const std::size_t cluster = first + static_cast<std::size_t>(std::countr_zero(near));
            for (std::uint32_t uncertain = list_.uncertainPairs(cluster, still); uncertain != 0;
                 uncertain &= uncertain - 1) {
                const NearPair pair = list_[NeighbourList::placeOf(cluster, std::countr_zero(uncertain))];
                const Triangle3 tooth = cornersOf(partOf(*surface_, pair.part).mesh(), pair.tooth);
                const Triangle3 tool = tool_->cornersAt(toolInTooth, pair.tool);
                if (!distanceBetween(tooth, tool, tool[0] - tooth[0]).separated) return false;
            }
        }
    }
    return true;
}

void ProxySolver::forget() {
    planes_.clear();
    lastViolation_ = 0;
    isSettled_ = false;
    list_.forget();
}

/// Sets up a round: makes sure of the pair list and bounds turn and step by what the list covers.
bool ProxySolver::plan(const Pose& goal, bool isFirst, double trust, Attempt& attempt) {
    attempt.goal = goal;
    double turn = chordBetween(goal.rotation, pose_.rotation);
    if (isFirst || !list_.made() || attempt.clippedToList) {
        const Vec3 displacement =
            freedom_ == Freedom::Translation ? predictedShift(goal) : predictedShift(attempt, turn);
        const bool ends = !list_.made() || attempt.clippedToList || isListExhausted(displacement, turn);
        if (ends && !(isFirst && isWithinList() && (isBudgetSpent_ || mayWaitForNextList()))) {
            if (lists_ >= maxLists()) return false;
            rebuildList(displacement, turn);
        }
    }
    const double rotationLeft = list_.contactMargin().turn * kTrusted - list_.chordTo(pose_.rotation);
    if (!isListed(pose_.position) || rotationLeft < 0) return false;
    const double fraction = turn > rotationLeft ? shareWithin(rotationLeft, turn) : 1;
    const bool isSolvedFor = freedom_ == Freedom::TranslationAndRotation;
    attempt.rotationLeft = rotationLeft;
    attempt.rotatesFully = isSolvedFor || fraction >= 1;
    attempt.rotationClipped = !attempt.rotatesFully;
    attempt.rotateBy(pose_.rotation, turn > 0 && !isSolvedFor ? fraction : 0);
    attempt.rotationBound = std::numeric_limits<double>::infinity();
    attempt.allowance = std::max(trust, kLeastTrustMargins * margin_);
    return true;
}

/// Where the tool will go in this tick, more or less: to the goal as far as the contacts of the last tick let it.
Vec3 ProxySolver::predictedShift(const Pose& goal) {
    std::array<HalfSpace, kMaxHeld> halfSpaces;
    const Mat3 rotation = pose_.rotation.toRotationMatrix();
    int count = 0;
    for (int i = 0; i < heldCount_; ++i) {
        if (hasPlane(held_[i]))
            halfSpaces[count++] = {held_[i].plane.normal, std::min(0.0, -gapAt(held_[i], rotation, pose_.position))};
    }
    const auto answer = solveQp3(std::span(halfSpaces).first(static_cast<std::size_t>(count)),
                                 goal.position - pose_.position, margin_ * kSolved);
    return answer.feasible ? answer.point : Vec3(Vec3::Zero());
}

/// Whether a position is one that the list was made for.
bool ProxySolver::isListed(const Vec3& position) const {
    return list_.deviation(position) <= list_.contactMargin().around * kTrusted - margin_;
}

int ProxySolver::maxLists() const { return goalShift_ < kJump * tool_->radius() ? kMaxLists : kMaxListsOfJump; }

/// Whether a body can go on with the list at hand, if only for a little way.
bool ProxySolver::isWithinList() const {
    return list_.made() && isListed(pose_.position) &&
           list_.chordTo(pose_.rotation) <= list_.contactMargin().turn * kTrusted;
}

/// Whether a body with a budget, at the end of a long list that it was given, can wait for a move or a few: whoever
/// makes lists ahead brings the next one, and to make one here takes longer than all else in a move. Well within
/// the list it waits however long: what keeps it there is what it touches, and no list of its own would let it on.
bool ProxySolver::mayWaitForNextList() const {
    return budget_ < kUnlimitedWork && isListExternal_ && list_.isLong() && (listWaits_ < kMaxWaits || isListFresh());
}

/// Whether a long list is good for some way yet.
bool ProxySolver::isListFresh() const {
    constexpr double kListUsedUp = 0.85;  // of the skin
    return list_.made() && list_.isLong() &&
           list_.chordTo(pose_.rotation) <= kListUsedUp * list_.contactMargin().turn &&
           list_.deviation(pose_.position) <= kListUsedUp * list_.contactMargin().around;
}

/// Whether the list would end on the way expected in this tick.
bool ProxySolver::isListExhausted(const Vec3& displacement, double turn) const {
    constexpr double kLittle = 0.125;  // of the least skin: the way is not known to the last micrometre
    if (budget_ < kUnlimitedWork && isListFresh()) return false;  // a new one would bring less than what is left
    const double rotationLeft = list_.contactMargin().turn * kTrusted - list_.chordTo(pose_.rotation);
    if (rotationLeft < std::min(turn, goalRotation_)) return true;
    const double length = displacement.norm();
    const Vec3 end =
        pose_.position + (length > 2 * goalShift_ ? Vec3(displacement * (2 * goalShift_ / length)) : displacement);
    return list_.deviation(end) + kLittle * list_.leastAround() > list_.contactMargin().around * kTrusted;
}

/// Covers the way expected in this tick and some more. Many lists in one move mean that it goes far.
void ProxySolver::rebuildList(const Vec3& displacement, double turn) {
    const double length = displacement.norm();
    const double growth = std::ldexp(1.0, std::max(0, ++lists_ - kUnchangedLists));
    const double little = growth * list_.leastAround();
    const double stride = kStride * std::min(length, growth * goalShift_) + kAhead * little;
    const double spin = kStride * std::min(turn, growth * goalRotation_) + kAhead * NeighbourList::leastRotation();
    const Vec3 along = length > 0 ? Vec3(displacement * (stride / length)) : Vec3(Vec3::Zero());
    list_.make(*surface_, pose_, {along, little + kMaxDeviation * stride, spin});
    ++ownListRebuilds_;
    isListExternal_ = false;
}

/// How much of a step stays where the list was made for.
double ProxySolver::shareWithinMargin(const Vec3& step) const {
    if (isListed(pose_.position + step)) return 1;
    const double farthest = list_.contactMargin().along.norm() + 2 * list_.contactMargin().around;
    double inside = 0;
    double outside = std::min(1.0, farthest / step.norm());
    for (int i = 0; i < 10; ++i) {
        const double middle = (inside + outside) / 2;
        (isListed(pose_.position + middle * step) ? inside : outside) = middle;
    }
    return inside;
}

void ProxySolver::addConstraint(Attempt& attempt, const WatchedPair& watched) const {
    if (freedom_ == Freedom::TranslationAndRotation) return addRotatingConstraint(attempt, watched);
    const double gap = gapAt(watched, attempt.matrix, pose_.position);
    // Without a turn, staying put is always allowed: a gap that rounding has left below the margin may stay so.
    const double offset = attempt.rotationFraction == 0 ? std::min(0.0, margin_ - gap) : margin_ - gap;
    attempt.watched[attempt.planeCount] = watched;
    attempt.halfSpaces[attempt.planeCount++] = {watched.plane.normal, offset};
}

/// Begins with the contacts of the round before: nearly always they are still the ones.
void ProxySolver::restart(Attempt& attempt) {
    attempt.planeCount = 0;
    if (freedom_ == Freedom::TranslationAndRotation) moveTo(Vec3::Zero(), Vec3::Zero(), attempt);
    for (int i = 0; i < heldCount_; ++i) {
        if (!hasPlane(held_[i])) continue;
        if (freedom_ == Freedom::Translation) {
            addConstraint(attempt, held_[i]);
        } else if (stillTouch(held_[i], heldFeatures_[i])) {
            addFeatureConstraint(attempt, held_[i], heldFeatures_[i]);
        }
    }
    for (int i = 0; i < attempt.warmStartCount; ++i) addConstraint(attempt, attempt.warmStart[i]);
}

/// The step nearest to the goal under the planes met so far, shortened to the allowance.
bool ProxySolver::solve(Attempt& attempt) {
    if (freedom_ == Freedom::TranslationAndRotation) return solveRotating(attempt);
    const std::span<const HalfSpace> halfSpaces(attempt.halfSpaces.data(),
                                                static_cast<std::size_t>(attempt.planeCount));
    const double tolerance = margin_ * kSolved;
    const Qp3Result answer = solveQp3(halfSpaces, attempt.goal.position - pose_.position, tolerance);
    if (!answer.feasible) {
        attempt.rotationClipped = false;  // what the tool touches ends the turn, before the list does
        return false;
    }
    attempt.setActive(answer);
    attempt.step = answer.point;
    attempt.clipped = false;
    attempt.clippedToList = attempt.rotationClipped;
    const double length = attempt.step.norm();
    const double listed = shareWithinMargin(attempt.step);
    const double share = std::min(listed, length > 0 ? attempt.allowance / length : 1);
    if (share >= 1) return true;
    attempt.clipped = true;
    attempt.clippedToList |= listed <= share;
    const Qp3Result shorter = solveQp3(halfSpaces, 0.9 * share * attempt.step, tolerance);
    if (!shorter.feasible || !isListed(pose_.position + shorter.point)) {
        attempt.rotationClipped = shorter.feasible;  // the turn pushes the tool farther than the list reaches
        return false;
    }
    attempt.step = shorter.point;
    return true;
}

/// Whether the planes that have held the tool so far leave it no way on. To stay where it stands brings nothing
/// together, so it is there already, whatever else is near.
bool ProxySolver::isStationary(const Attempt& attempt) const {
    return freedom_ == Freedom::Translation && attempt.rotationFraction == 0 && !attempt.clipped &&
           attempt.activeCount > 0 && attempt.step.norm() <= kStaysMargins * margin_;
}

/// Collects planes until the step that they leave is safe. False if there is none within the fixed budget.
bool ProxySolver::findSafeStep(Attempt& attempt, bool& overlapping) {
    restart(attempt);
    for (int i = 0; i < kMaxSolutions; ++i) {
        if (!solve(attempt)) {
            if (attempt.rotationFraction == 0) return false;
            attempt.rotatesFully = false;
            attempt.rotateBy(pose_.rotation,
                             attempt.rotationFraction > kLeastRotation ? attempt.rotationFraction / 4 : 0);
            restart(attempt);
            continue;
        }
        work_ += cost::kSolution;
        if (i == 0 && isStationary(attempt)) {
            attempt.step.setZero();
            return true;
        }
        WatchedPair violator;
        SweepQuery look(attempt);
        Violation violationFound = recentViolation(attempt, look, violator);
        if (violationFound == Violation::None) violationFound = violation(attempt, look, violator);
        overlapping = violationFound == Violation::Overlapping;
        if (overlapping || violationFound == Violation::OutOfBudget) return false;
        if (violationFound == Violation::None) {
            if (isStationary(attempt)) attempt.step.setZero();
            return true;
        }
        recent_.add(violator.pair);
        const bool isLong = attempt.planeCount == kMaxPlanesPerIteration || i % kManySolutions == kManySolutions - 1;
        if (!isLong) {
            addConstraint(attempt, violator);
        } else if (attempt.allowance > kSettledMargins * margin_) {
            attempt.allowance /= 8;
            restart(attempt);
        } else {
            return false;
        }
    }
    return false;
}

/// The corner of a held triangle that stands lowest over its plane, in the tooth's frame.
Vec3 ProxySolver::deepestPoint(const WatchedPair& held) const {
    const Triangle3 tool = tool_->corners(held.pair.tool);
    Vec3 deepest = pose_ * tool[0];
    for (const Vec3& corner : tool) {
        if (const Vec3 point = pose_ * corner; held.plane.normal.dot(point) < held.plane.normal.dot(deepest))
            deepest = point;
    }
    return deepest;
}

void ProxySolver::accept(const Attempt& attempt, MoveResult& result) {
    const bool stays = freedom_ == Freedom::Translation && attempt.rotationFraction == 0 && attempt.step.isZero(0);
    pose_.rotation = attempt.rotation;
    pose_.position += attempt.step;
    if (!stays) ++poseStamp_;
    heldCount_ = attempt.activeCount;
    result.contactCount = heldCount_;
    for (int i = 0; i < heldCount_; ++i) {
        const int plane = attempt.active[i];
        held_[i] = attempt.watched[plane];
        const bool turns = freedom_ == Freedom::TranslationAndRotation;
        if (turns) heldFeatures_[i] = attempt.touches[plane].features;
        const Vec3 normal = turns ? attempt.touches[plane].normal : held_[i].plane.normal;
        const Vec3 point = turns ? attempt.touches[plane].point : deepestPoint(held_[i]);
        result.contacts[i] = {normal, point, attempt.multiplier[i], held_[i].pair.part, held_[i].pair.tooth};
    }
}

/// Whether the pairs that hold the body are those that held it at the end of the last move.
bool ProxySolver::isUnchanged() const {
    if (heldCount_ != lastHeldCount_) return false;
    const auto before = std::span(lastHeld_).first(static_cast<std::size_t>(lastHeldCount_));
    return std::all_of(held_.begin(), held_.begin() + heldCount_,
                       [&](const WatchedPair& held) { return std::ranges::find(before, held.pair) != before.end(); });
}

void ProxySolver::remember(const MoveResult& result) {
    unchangedMoves_ = isUnchanged() ? unchangedMoves_ + 1 : 0;
    // A move that was cut short has not looked afresh at what holds the body.
    lastHeldCount_ = result.status == MoveStatus::InContact ? heldCount_ : 0;
    for (int i = 0; i < heldCount_; ++i) lastHeld_[i] = held_[i].pair;
    isSettled_ = result.status == MoveStatus::InContact || result.status == MoveStatus::Reached;
    settled_ = result;
    settled_.iterations = settled_.distances = 0;
    settled_.work = 0;
}

MoveResult ProxySolver::moveToward(const Pose& goal) {
    if (isSettled_ && goal.position == lastGoal_.position && goal.rotation.coeffs() == lastGoal_.rotation.coeffs())
        return settled_;
    MoveResult result;
    if (!(tool_->radius() > 0)) {  // nothing that could touch
        placeAt(goal);
        return result;
    }
    distances_ = 0;
    work_ = firstList_ = 0;
    const double position = std::max(goal.position.cwiseAbs().maxCoeff(), pose_.position.cwiseAbs().maxCoeff());
    margin_ = kMarginOfRadius * tool_->radius() + kMarginOfPosition * position;
    // A tool that lags behind has its own way to go as well as that of the hand.
    const Pose& from = isLagging_ ? pose_ : lastGoal_;
    goalShift_ = (goal.position - from.position).norm();
    goalRotation_ = chordBetween(goal.rotation, from.rotation);
    lastGoal_ = goal;
    lists_ = 0;
    result.status = MoveStatus::OutOfIterations;
    Attempt attempt;
    double trust = kGoalPrediction * goalShift_ * stepScale_;
    int planesChanged = 0;
    bool requeried = false;  // whether a settled tool has been tried without the planes that hold it
    bool hasStepped = false;
    const bool mayWait = mayWaitForNextList() && isWithinList();
    // A list takes longer than all else in a move: one with a budget makes one at most.
    const bool isBounded = budget_ < kUnlimitedWork;
    const auto isEnough = [&] {
        return isOutOfBudget() || (attempt.clippedToList && (mayWait || (isBounded && lists_ > 0)));
    };
    if (isBounded && listRests_ > 0) {
        --listRests_;
        result.status = MoveStatus::OutOfBudget;
    }
    // While that list was made the body has gone on and left what it covers.
    const bool isAhead = mayWaitForNextList() && !isWithinList();
    if (isAhead) result.status = MoveStatus::OutOfBudget;
    while (result.status == MoveStatus::OutOfIterations && result.iterations < kMaxIterations) {
        if (hasStepped && isEnough()) break;
        const bool isFirst = ++result.iterations == 1;
        bool overlapping = false;
        if (!plan(goal, isFirst, trust, attempt) || !findSafeStep(attempt, overlapping)) {
            if (list_.isFull() && list_.shorten()) {
                if (isBounded) {  // the shorter one is made in a later move, if none has been given until then
                    listRests_ = hasListProvider_ ? kMaxWaits : 0;
                    result.status = MoveStatus::OutOfBudget;
                    break;
                }
                lists_ = std::max(0, lists_ - 1);  // the shorter one takes its place
                continue;
            }
            if (overlapping) result.status = MoveStatus::Overlapping;
            break;
        }
        const double turned = chordBetween(attempt.rotation, pose_.rotation) * tool_->radius();
        const double moved = attempt.step.norm();
        accept(attempt, result);
        attempt.warmStartCount = 0;
        hasStepped = true;
        trust = kTrustGrowth * (attempt.clipped ? attempt.allowance : moved);
        if (attempt.clipped || attempt.clippedToList) continue;
        if (attempt.rotatesFully && heldCount_ == 0) {
            result.status = MoveStatus::Reached;
        } else if (moved + turned <= kSettledMargins * margin_) {
            trust = kGoalPrediction * goalShift_;
            if (freedom_ == Freedom::Translation && planesChanged++ < kMaxPlanesChanged &&
                switchContactPlanes(goal, attempt))
                continue;
            const int fewest = freedom_ == Freedom::Translation ? kFewestToRequery : 1;
            const bool isKnown = isUnchanged() && unchangedMoves_ % kUnchangedMoves != kUnchangedMoves - 1;
            if (requeried || heldCount_ < fewest || isKnown) {
                result.status = MoveStatus::InContact;
            } else {
                requeried = true;
                trust = 0;  // a little way on is enough to tell
                heldCount_ = 0;
                recent_.clear();
            }
        }
    }
    if (result.status == MoveStatus::OutOfIterations && isEnough()) result.status = MoveStatus::OutOfBudget;
    listWaits_ = isAhead || (mayWait && attempt.clippedToList) ? listWaits_ + 1 : 0;
    settleBudget(hasStepped, result);
    remember(result);
    isLagging_ = result.status == MoveStatus::OutOfIterations;
    return result;
}

void ProxySolver::setBudget(Work budget) {
    if (budget != budget_) budget_ = allowed_ = budget;
}

/// What this move has cost, and what the next one may.
void ProxySolver::settleBudget(bool hasStepped, MoveResult& result) {
    const bool isOut = result.status == MoveStatus::OutOfBudget && isOutOfBudget();
    isBudgetSpent_ = isOut && !hasStepped;
    stepScale_ = isBudgetSpent_ ? std::max(stepScale_ / 4, kMinStepScale) : std::min(2 * stepScale_, 1.0);
    allowed_ = isOut ? std::min(2 * allowed_, kMaxAllowance * budget_) : budget_;
    result.distances = distances_;
    result.work = work_;
}

}  // namespace tactooth
