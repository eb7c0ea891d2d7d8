// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/sliding_body_round.h"

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

constexpr int kMaxRounds = 60;  // 3 at 1 cm/s, 5 at 10 cm/s; at 1 m/s on meshes of 20 um up to 56 were seen
constexpr int kManySolutions = kMaxPlanesPerRound + 1;  // of a round: more come of a turn that does not settle
constexpr int kMaxSolutions = 8 * kManySolutions;
constexpr int kMaxPlanesChanged = 8;         // in a move, where it had settled: a corner of the tool has six triangles
constexpr int kFewestToLookAfresh = 2;       // planes: together they may stop what other ones would let go on
constexpr int kAlike = 8;                    // moves: a body that the same pairs hold is looked at afresh so often
constexpr double kMarginOfRadius = 1e-7;     // 0.3 nm for a 6 mm bur
constexpr double kMarginOfPosition = 1e-10;  // keeps the margin above rounding far from the origin
constexpr double kSettledMargins = 10;       // a round that moves less than this many margins ends the move
constexpr double kStaysMargins = 0.1;  // a way on that is shorter is none, and no look for what is in it is needed
constexpr double kLeastTurn = 1e-3;    // of the turn wanted: below it, the tool is held in its present orientation

// The list of what is near: a longer one lasts longer and costs more in every round.
constexpr double kStride = 1.2;    // ways of the hand that a list should last, and so much more:
constexpr double kAhead = 6;       // of the least skin
constexpr double kStray = 0.25;    // of both: how far the tool may leave the way expected
constexpr double kTrusted = 0.95;  // of the skin: leaves room for rounding

constexpr int kMostWaits = 8;  // moves: a list for a bur of 2.3 mm in its own cavity comes within eight ticks

// Lists of a move: the rest of the way waits for a tick. A hand that was lost for a while leaps, and did not lead the
// tool around the tooth.
constexpr int kMostLists = 40;
constexpr int kMostListsOfLeap = 28;
constexpr double kLeap = 0.5;   // of the tool's radius: 5 mm for a bur with its shank, which no hand goes in a tick
constexpr int kAlikeLists = 8;  // as long as the first; each of those to come is twice as long

// The longest step of a round. It need not be right: a step that was cut short is followed by a longer one.
constexpr double kTrustInHand = 2;          // ways of the hand
constexpr double kTrustGrowth = 8;          // steps of the round before
constexpr double kLeastTrustMargins = 200;  // 0.2 um for a bur of 20 mm

/// The share of a turn that ends within a shorter one; both as chords, of which a share of an arc has more than its
/// own. A hair less: a body that rounding has put beyond the end of its list would have to make another.
double shareWithin(double limit, double turn) {
    constexpr double kHair = 1e-6;
    return (1 - kHair) * std::asin(limit / 2) / std::asin(std::min(turn / 2, 1.0));
}

}  // namespace

SlidingBody::SlidingBody(std::shared_ptr<const ToolShape> tool, Freedom freedom)
    : tool_(std::move(tool)), freedom_(freedom), list_(*tool_) {}

std::shared_ptr<const Surface> SlidingBody::setSurface(std::shared_ptr<const Surface> surface) {
    enter(surface);
    list_.clear();
    return surface;
}

std::shared_ptr<const Surface> SlidingBody::setSurface(std::shared_ptr<const Surface> surface, PairList& near) {
    if (surface != surface_) enter(surface);  // else all that is known of it still holds
    std::swap(list_, near);
    isListGiven_ = isGivenLists_ = true;
    waits_ = rests_ = 0;
    return surface;
}

void SlidingBody::enter(std::shared_ptr<const Surface>& surface) {
    std::swap(surface_, surface);
    heldCount_ = lastHeldCount_ = 0;
    isSettled_ = false;
    recent_.clear();
}

void SlidingBody::placeAt(const Pose& toolInTooth) {
    shiftTo(toolInTooth);
    list_.clear();
}

void SlidingBody::shiftTo(const Pose& toolInTooth) {
    pose_ = toolInTooth;
    ++poseStamp_;
    heldCount_ = lastHeldCount_ = 0;
    lastGoal_ = toolInTooth;
    isBehind_ = isStarved_ = isSettled_ = false;
    rests_ = 0;
    boldness_ = 1;
    recent_.clear();
}

std::optional<bool> SlidingBody::isClearAt(const Pose& toolInTooth) {
    const bool turnIsListed = list_.turnTo(toolInTooth.rotation) <= list_.skin().turn * kTrusted;
    if (!list_.made() || !isListed(toolInTooth.position) || !turnIsListed) return std::nullopt;
    const Excursion still = list_.excursion(toolInTooth, toolInTooth, 0, {});
    const std::span<const std::uint32_t> eights = list_.within(still);
    if (list_.isFull()) return std::nullopt;
    for (const std::uint32_t first : eights) {
        for (std::uint32_t near = list_.clustersInDoubt(first, still); near != 0; near &= near - 1) {
            const std::size_t cluster = first + static_cast<std::size_t>(std::countr_zero(near));
            for (std::uint32_t doubt = list_.pairsInDoubt(cluster, still); doubt != 0; doubt &= doubt - 1) {
                const NearPair pair = list_[PairList::placeOf(cluster, std::countr_zero(doubt))];
                const Triangle3 tooth = cornersOf(partOf(*surface_, pair.part).mesh(), pair.tooth);
                const Triangle3 tool = tool_->cornersAt(toolInTooth, pair.tool);
                if (!distanceBetween(tooth, tool, tool[0] - tooth[0]).separated) return false;
            }
        }
    }
    return true;
}

void SlidingBody::forget() {
    planes_.clear();
    lastOffence_ = 0;
    isSettled_ = false;
    list_.forget();
}

/// Sets up a round: makes sure of the pair list and bounds turn and step by what the list covers.
bool SlidingBody::plan(const Pose& goal, bool isFirst, double trust, Attempt& attempt) {
    attempt.goal = goal;
    double turn = chordBetween(goal.rotation, pose_.rotation);
    if (isFirst || !list_.made() || attempt.outgrown) {
        const Vec3 way = freedom_ == Freedom::Shift ? expectedWay(goal) : expectedWay(attempt, turn);
        const bool ends = !list_.made() || attempt.outgrown || runsShort(way, turn);
        if (ends && !(isFirst && isWithinList() && (isStarved_ || mayWaitForNextList()))) {
            if (lists_ >= mostLists()) return false;
            renewList(way, turn);
        }
    }
    const double turnLeft = list_.skin().turn * kTrusted - list_.turnTo(pose_.rotation);
    if (!isListed(pose_.position) || turnLeft < 0) return false;
    const double fraction = turn > turnLeft ? shareWithin(turnLeft, turn) : 1;
    const bool isSolvedFor = freedom_ == Freedom::ShiftAndTurn;
    attempt.turnLeft = turnLeft;
    attempt.turnsFully = isSolvedFor || fraction >= 1;
    attempt.turnOutgrown = !attempt.turnsFully;
    attempt.turnBy(pose_.rotation, turn > 0 && !isSolvedFor ? fraction : 0);
    attempt.turnBound = std::numeric_limits<double>::infinity();
    attempt.allowance = std::max(trust, kLeastTrustMargins * margin_);
    return true;
}

/// Where the tool will go in this tick, more or less: to the goal as far as the contacts of the last tick let it.
Vec3 SlidingBody::expectedWay(const Pose& goal) {
    std::array<HalfSpace, kMaxHeld> halfSpaces;
    const Mat3 rotation = pose_.rotation.toRotationMatrix();
    int count = 0;
    for (int i = 0; i < heldCount_; ++i) {
        if (hasPlane(held_[i]))
            halfSpaces[count++] = {held_[i].plane.normal, std::min(0.0, -gapAt(held_[i], rotation, pose_.position))};
    }
    const auto answer = nearestInPolyhedron(std::span(halfSpaces).first(static_cast<std::size_t>(count)),
                                            goal.position - pose_.position, margin_ * kSolved);
    return answer.feasible ? answer.point : Vec3(Vec3::Zero());
}

/// Whether a position is one that the list was made for.
bool SlidingBody::isListed(const Vec3& position) const {
    return list_.stray(position) <= list_.skin().around * kTrusted - margin_;
}

int SlidingBody::mostLists() const { return handWay_ < kLeap * tool_->radius() ? kMostLists : kMostListsOfLeap; }

/// Whether a body can go on with the list at hand, if only for a little way.
bool SlidingBody::isWithinList() const {
    return list_.made() && isListed(pose_.position) && list_.turnTo(pose_.rotation) <= list_.skin().turn * kTrusted;
}

/// Whether a body with a budget, at the end of a long list that it was given, can wait for a move or a few: whoever
/// makes lists ahead brings the next one, and to make one here takes longer than all else in a move. Well within
/// the list it waits however long: what keeps it there is what it touches, and no list of its own would let it on.
bool SlidingBody::mayWaitForNextList() const {
    return budget_ < kUnlimitedWork && isListGiven_ && list_.isLong() && (waits_ < kMostWaits || isListFresh());
}

/// Whether a long list is good for some way yet.
bool SlidingBody::isListFresh() const {
    constexpr double kWorn = 0.85;  // of the skin
    return list_.made() && list_.isLong() && list_.turnTo(pose_.rotation) <= kWorn * list_.skin().turn &&
           list_.stray(pose_.position) <= kWorn * list_.skin().around;
}

/// Whether the list would end on the way expected in this tick.
bool SlidingBody::runsShort(const Vec3& way, double turn) const {
    constexpr double kLittle = 0.125;  // of the least skin: the way is not known to the last micrometre
    if (budget_ < kUnlimitedWork && isListFresh()) return false;  // a new one would bring less than what is left
    const double turnLeft = list_.skin().turn * kTrusted - list_.turnTo(pose_.rotation);
    if (turnLeft < std::min(turn, handTurn_)) return true;
    const double length = way.norm();
    const Vec3 end = pose_.position + (length > 2 * handWay_ ? Vec3(way * (2 * handWay_ / length)) : way);
    return list_.stray(end) + kLittle * list_.leastAround() > list_.skin().around * kTrusted;
}

/// Covers the way expected in this tick and some more. Many lists in one move mean that it goes far.
void SlidingBody::renewList(const Vec3& way, double turn) {
    const double length = way.norm();
    const double growth = std::ldexp(1.0, std::max(0, ++lists_ - kAlikeLists));
    const double little = growth * list_.leastAround();
    const double stride = kStride * std::min(length, growth * handWay_) + kAhead * little;
    const double spin = kStride * std::min(turn, growth * handTurn_) + kAhead * PairList::leastTurn();
    const Vec3 along = length > 0 ? Vec3(way * (stride / length)) : Vec3(Vec3::Zero());
    list_.make(*surface_, pose_, {along, little + kStray * stride, spin});
    ++ownLists_;
    isListGiven_ = false;
}

/// How much of a step stays where the list was made for.
double SlidingBody::shareWithinSkin(const Vec3& step) const {
    if (isListed(pose_.position + step)) return 1;
    const double farthest = list_.skin().along.norm() + 2 * list_.skin().around;
    double inside = 0;
    double outside = std::min(1.0, farthest / step.norm());
    for (int i = 0; i < 10; ++i) {
        const double middle = (inside + outside) / 2;
        (isListed(pose_.position + middle * step) ? inside : outside) = middle;
    }
    return inside;
}

void SlidingBody::addConstraint(Attempt& attempt, const WatchedPair& watched) const {
    if (freedom_ == Freedom::ShiftAndTurn) return addTurningConstraint(attempt, watched);
    const double gap = gapAt(watched, attempt.matrix, pose_.position);
    // Without a turn, staying put is always allowed: a gap that rounding has left below the margin may stay so.
    const double offset = attempt.turnFraction == 0 ? std::min(0.0, margin_ - gap) : margin_ - gap;
    attempt.watched[attempt.planeCount] = watched;
    attempt.halfSpaces[attempt.planeCount++] = {watched.plane.normal, offset};
}

/// Begins with the contacts of the round before: nearly always they are still the ones.
void SlidingBody::restart(Attempt& attempt) {
    attempt.planeCount = 0;
    if (freedom_ == Freedom::ShiftAndTurn) moveTo(Vec3::Zero(), Vec3::Zero(), attempt);
    for (int i = 0; i < heldCount_; ++i) {
        if (!hasPlane(held_[i])) continue;
        if (freedom_ == Freedom::Shift) {
            addConstraint(attempt, held_[i]);
        } else if (stillTouch(held_[i], heldFeatures_[i])) {
            keepApart(attempt, held_[i], heldFeatures_[i]);
        }
    }
    for (int i = 0; i < attempt.standingCount; ++i) addConstraint(attempt, attempt.standing[i]);
}

/// The step nearest to the goal under the planes met so far, shortened to the allowance.
bool SlidingBody::solve(Attempt& attempt) {
    if (freedom_ == Freedom::ShiftAndTurn) return solveTurning(attempt);
    const std::span<const HalfSpace> halfSpaces(attempt.halfSpaces.data(),
                                                static_cast<std::size_t>(attempt.planeCount));
    const double tolerance = margin_ * kSolved;
    const NearestInPolyhedron answer =
        nearestInPolyhedron(halfSpaces, attempt.goal.position - pose_.position, tolerance);
    if (!answer.feasible) {
        attempt.turnOutgrown = false;  // what the tool touches ends the turn, before the list does
        return false;
    }
    attempt.setActive(answer);
    attempt.step = answer.point;
    attempt.clipped = false;
    attempt.outgrown = attempt.turnOutgrown;
    const double length = attempt.step.norm();
    const double listed = shareWithinSkin(attempt.step);
    const double share = std::min(listed, length > 0 ? attempt.allowance / length : 1);
    if (share >= 1) return true;
    attempt.clipped = true;
    attempt.outgrown |= listed <= share;
    const NearestInPolyhedron shorter = nearestInPolyhedron(halfSpaces, 0.9 * share * attempt.step, tolerance);
    if (!shorter.feasible || !isListed(pose_.position + shorter.point)) {
        attempt.turnOutgrown = shorter.feasible;  // the turn pushes the tool farther than the list reaches
        return false;
    }
    attempt.step = shorter.point;
    return true;
}

/// Whether the planes that have held the tool so far leave it no way on. To stay where it stands brings nothing
/// together, so it is there already, whatever else is near.
bool SlidingBody::staysPut(const Attempt& attempt) const {
    return freedom_ == Freedom::Shift && attempt.turnFraction == 0 && !attempt.clipped && attempt.activeCount > 0 &&
           attempt.step.norm() <= kStaysMargins * margin_;
}

/// Collects planes until the step that they leave is safe. False if there is none within the fixed budget.
bool SlidingBody::findSafeStep(Attempt& attempt, bool& overlapping) {
    restart(attempt);
    for (int i = 0; i < kMaxSolutions; ++i) {
        if (!solve(attempt)) {
            if (attempt.turnFraction == 0) return false;
            attempt.turnsFully = false;
            attempt.turnBy(pose_.rotation, attempt.turnFraction > kLeastTurn ? attempt.turnFraction / 4 : 0);
            restart(attempt);
            continue;
        }
        work_ += cost::kSolution;
        if (i == 0 && staysPut(attempt)) {
            attempt.step.setZero();
            return true;
        }
        WatchedPair offender;
        Look look(attempt);
        Offence offence = recentViolation(attempt, look, offender);
        if (offence == Offence::None) offence = violation(attempt, look, offender);
        overlapping = offence == Offence::Overlapping;
        if (overlapping || offence == Offence::OutOfWork) return false;
        if (offence == Offence::None) {
            if (staysPut(attempt)) attempt.step.setZero();
            return true;
        }
        recent_.add(offender.pair);
        const bool isLong = attempt.planeCount == kMaxPlanesPerRound || i % kManySolutions == kManySolutions - 1;
        if (!isLong) {
            addConstraint(attempt, offender);
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
Vec3 SlidingBody::deepestPoint(const WatchedPair& held) const {
    const Triangle3 tool = tool_->corners(held.pair.tool);
    Vec3 deepest = pose_ * tool[0];
    for (const Vec3& corner : tool) {
        if (const Vec3 point = pose_ * corner; held.plane.normal.dot(point) < held.plane.normal.dot(deepest))
            deepest = point;
    }
    return deepest;
}

void SlidingBody::accept(const Attempt& attempt, MoveResult& result) {
    const bool stays = freedom_ == Freedom::Shift && attempt.turnFraction == 0 && attempt.step.isZero(0);
    pose_.rotation = attempt.rotation;
    pose_.position += attempt.step;
    if (!stays) ++poseStamp_;
    heldCount_ = attempt.activeCount;
    result.contactCount = heldCount_;
    for (int i = 0; i < heldCount_; ++i) {
        const int plane = attempt.active[i];
        held_[i] = attempt.watched[plane];
        const bool turns = freedom_ == Freedom::ShiftAndTurn;
        if (turns) heldFeatures_[i] = attempt.touches[plane].features;
        const Vec3 normal = turns ? attempt.touches[plane].normal : held_[i].plane.normal;
        const Vec3 point = turns ? attempt.touches[plane].point : deepestPoint(held_[i]);
        result.contacts[i] = {normal, point, attempt.multiplier[i], held_[i].pair.part, held_[i].pair.tooth};
    }
}

/// Whether the pairs that hold the body are those that held it at the end of the last move.
bool SlidingBody::standsAsBefore() const {
    if (heldCount_ != lastHeldCount_) return false;
    const auto before = std::span(lastHeld_).first(static_cast<std::size_t>(lastHeldCount_));
    return std::all_of(held_.begin(), held_.begin() + heldCount_,
                       [&](const WatchedPair& held) { return std::ranges::find(before, held.pair) != before.end(); });
}

void SlidingBody::remember(const MoveResult& result) {
    alike_ = standsAsBefore() ? alike_ + 1 : 0;
    // A move that was cut short has not looked afresh at what holds the body.
    lastHeldCount_ = result.status == MoveStatus::Held ? heldCount_ : 0;
    for (int i = 0; i < heldCount_; ++i) lastHeld_[i] = held_[i].pair;
    isSettled_ = result.status == MoveStatus::Held || result.status == MoveStatus::Reached;
    settled_ = result;
    settled_.rounds = settled_.distances = 0;
    settled_.work = 0;
}

MoveResult SlidingBody::moveToward(const Pose& goal) {
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
    const Pose& from = isBehind_ ? pose_ : lastGoal_;
    handWay_ = (goal.position - from.position).norm();
    handTurn_ = chordBetween(goal.rotation, from.rotation);
    lastGoal_ = goal;
    lists_ = 0;
    result.status = MoveStatus::OutOfRounds;
    Attempt attempt;
    double trust = kTrustInHand * handWay_ * boldness_;
    int planesChanged = 0;
    bool lookedAfresh = false;  // whether a settled tool has been tried without the planes that hold it
    bool hasStepped = false;
    const bool mayWait = mayWaitForNextList() && isWithinList();
    // A list takes longer than all else in a move: one with a budget makes one at most.
    const bool isBounded = budget_ < kUnlimitedWork;
    const auto isEnough = [&] { return isOutOfWork() || (attempt.outgrown && (mayWait || (isBounded && lists_ > 0))); };
    if (isBounded && rests_ > 0) {
        --rests_;
        result.status = MoveStatus::OutOfWork;
    }
    // While that list was made the body has gone on and left what it covers.
    const bool isAhead = mayWaitForNextList() && !isWithinList();
    if (isAhead) result.status = MoveStatus::OutOfWork;
    while (result.status == MoveStatus::OutOfRounds && result.rounds < kMaxRounds) {
        if (hasStepped && isEnough()) break;
        const bool isFirst = ++result.rounds == 1;
        bool overlapping = false;
        if (!plan(goal, isFirst, trust, attempt) || !findSafeStep(attempt, overlapping)) {
            if (list_.isFull() && list_.shorten()) {
                if (isBounded) {  // the shorter one is made in a later move, if none has been given until then
                    rests_ = isGivenLists_ ? kMostWaits : 0;
                    result.status = MoveStatus::OutOfWork;
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
        attempt.standingCount = 0;
        hasStepped = true;
        trust = kTrustGrowth * (attempt.clipped ? attempt.allowance : moved);
        if (attempt.clipped || attempt.outgrown) continue;
        if (attempt.turnsFully && heldCount_ == 0) {
            result.status = MoveStatus::Reached;
        } else if (moved + turned <= kSettledMargins * margin_) {
            trust = kTrustInHand * handWay_;
            if (freedom_ == Freedom::Shift && planesChanged++ < kMaxPlanesChanged && findWayOn(goal, attempt)) continue;
            const int fewest = freedom_ == Freedom::Shift ? kFewestToLookAfresh : 1;
            const bool isKnown = standsAsBefore() && alike_ % kAlike != kAlike - 1;
            if (lookedAfresh || heldCount_ < fewest || isKnown) {
                result.status = MoveStatus::Held;
            } else {
                lookedAfresh = true;
                trust = 0;  // a little way on is enough to tell
                heldCount_ = 0;
                recent_.clear();
            }
        }
    }
    if (result.status == MoveStatus::OutOfRounds && isEnough()) result.status = MoveStatus::OutOfWork;
    waits_ = isAhead || (mayWait && attempt.outgrown) ? waits_ + 1 : 0;
    settleBudget(hasStepped, result);
    remember(result);
    isBehind_ = result.status == MoveStatus::OutOfRounds;
    return result;
}

void SlidingBody::setBudget(Work budget) {
    if (budget != budget_) budget_ = allowed_ = budget;
}

/// What this move has cost, and what the next one may.
void SlidingBody::settleBudget(bool hasStepped, MoveResult& result) {
    const bool isOut = result.status == MoveStatus::OutOfWork && isOutOfWork();
    isStarved_ = isOut && !hasStepped;
    boldness_ = isStarved_ ? std::max(boldness_ / 4, kLeastBoldness) : std::min(2 * boldness_, 1.0);
    allowed_ = isOut ? std::min(2 * allowed_, kGreatestAllowance * budget_) : budget_;
    result.distances = distances_;
    result.work = work_;
}

}  // namespace tactooth
