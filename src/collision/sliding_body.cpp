// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/sliding_body.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "collision/gjk.h"

// God object: C. B. Zilles, J. K. Salisbury, "A Constraint-based God-object Method for Haptic Display", IROS 1995; for
// a body with a shape: M. Ortega, S. Redon, S. Coquillart, "A Six Degree-of-Freedom God-Object Method for Haptic
// Display of Rigid Bodies with Surface Properties", IEEE TVCG 13(3), 2007, sections 3-4.
//
// One round: the planes that separate the pairs of triangles at the present, free pose bound a convex region of moves
// that are all safe, the whole way. The move nearest to the goal inside that region is found lazily: solve with the
// planes met so far, look for the pair that the answer would bring together most, add its plane, solve again. Then the
// body moves and the planes are found anew. Differs from Ortega: contacts need not be touched one after the other, and
// a finely meshed surface costs no more rounds than a coarse one.

namespace tactooth {
namespace {

constexpr int kMaxRounds = 20;               // about 4 at 1 cm/s, 6-7 at 10 cm/s; a jump into contact takes some 15
constexpr int kMaxPlanesPerRound = 32;       // 3-6 are usual; more means that the step is long for its surroundings
constexpr int kOffendersToCompare = 2;       // before the worst of them becomes a plane: more costs more than it saves
constexpr double kMarginOfRadius = 1e-7;     // 0.3 nm for a 6 mm bur
constexpr double kMarginOfPosition = 1e-10;  // keeps the margin above rounding far from the origin
constexpr double kSettledMargins = 10;       // a round that moves less than this many margins ends the move
constexpr double kStride = 2;  // ways of the hand a list should last: more pairs to list against listing more often
constexpr std::uint64_t kGuessed = 1;    // stamp of a plane that GJK has not seen; poses are numbered from 2
constexpr double kLeastTurn = 1e-3;      // of the turn wanted: below it, the tool is held in its present orientation
constexpr double kStillNear = 0.995;     // of a gap below the margin: what staying put leaves of it, less rounding
constexpr double kTouchingMargins = 10;  // nearer than this, a triangle's own plane is looked at
constexpr double kAsWell = 0.9;          // of what GJK's plane leaves
constexpr double kTrusted = 0.95;        // of the listed reach: leaves room for rounding

Quat partOfTurn(const Quat& from, const Quat& to, double fraction) {
    return fraction >= 1 ? to : from.slerp(fraction, to).normalized();
}

}  // namespace

/// One round in the making.
struct SlidingBody::Attempt {
    Pose goal;
    double turnFraction = 1;  // of the turn still to make
    bool turnsFully = true;
    double allowance = 0;  // how far any point of the tool may travel, mm
    Quat rotation;         // at the end of the round
    Mat3 matrix;
    Mat3 startMatrix;
    Vec3 step = Vec3::Zero();
    bool clipped = false;  // the step was shortened to the allowance
    NearestInPolyhedron answer;
    int planeCount = 0;
    std::array<WatchedPair, kMaxPlanesPerRound> watched;
    std::array<HalfSpace, kMaxPlanesPerRound> halfSpaces;

    void turnBy(const Quat& from, double fraction) {
        turnFraction = fraction;
        rotation = fraction > 0 ? partOfTurn(from, goal.rotation, fraction) : from;
        matrix = rotation.toRotationMatrix();
        startMatrix = from.toRotationMatrix();
    }
};

SlidingBody::SlidingBody(std::shared_ptr<const ToolShape> tool) : tool_(std::move(tool)), list_(*tool_) {}

std::shared_ptr<const Surface> SlidingBody::setSurface(std::shared_ptr<const Surface> surface) {
    std::swap(surface_, surface);
    heldCount_ = 0;
    list_.clear();
    return surface;
}

void SlidingBody::placeAt(const Pose& toolInTooth) {
    pose_ = toolInTooth;
    ++poseStamp_;
    heldCount_ = 0;
    lastGoalCentre_ = toolInTooth * tool_->centre();
    list_.clear();
}

/// Sets up a round: makes sure of the pair list and bounds turn and step by what the list covers.
bool SlidingBody::plan(const Pose& goal, Attempt& attempt) {
    attempt.goal = goal;
    const double turn = sineOfHalfAngle(goal.rotation, pose_.rotation);
    const double remaining = (goal * tool_->centre() - pose_ * tool_->centre()).norm() + 2 * turn * tool_->radius();
    const double least = list_.leastReach();
    double used = list_.made() ? list_.travelTo(pose_.rotation, pose_.position) : 0;
    if (!list_.made() || list_.reach() * kTrusted - used < std::min(remaining, least / 2)) {
        // Open space is crossed in growing strides; near the tooth the skin follows the speed of the hand.
        const bool openSpace = list_.made() && list_.size() == 0;
        const double stride = openSpace ? 4 * list_.reach() : kStride * handTravel_;
        list_.make(*surface_, *tool_, pose_, std::min(1.1 * remaining, stride) + least);
        used = 0;
    }
    attempt.allowance = list_.reach() * kTrusted - used - margin_;
    if (attempt.allowance <= 0) return false;
    const double turnTravel =
        2 * turn * tool_->radius() + (goal.rotation * tool_->centre() - pose_.rotation * tool_->centre()).norm();
    const double fraction = turnTravel > attempt.allowance / 2 ? attempt.allowance / 2 / turnTravel : 1;
    attempt.turnsFully = fraction >= 1;
    attempt.turnBy(pose_.rotation, turnTravel > 0 ? fraction : 0);
    return true;
}

/// A listed pair with the plane remembered for it, or with its certificate's direction for GJK to begin with.
WatchedPair SlidingBody::watch(std::size_t place) const {
    const NearPair& pair = list_[place];
    const SeparatingPlane* known = planes_.find(partOf(*surface_, pair.part).id(), pair);
    return {pair, known != nullptr ? *known : SeparatingPlane{list_.direction(place), 0, kGuessed}};
}

/// Takes the plane of one of the triangles themselves, if it parts them as well. Where the tool slides toward a concave
/// edge of the tooth, GJK's plane stands across the way, a margin in front of it; that of the triangle behind the edge
/// lets the tool slide on.
void SlidingBody::preferFace(const Triangle3& tooth, const Triangle3& tool, SeparatingPlane& plane) const {
    const double needed = kAsWell * std::min(margin_, lowestAlong(tool, plane.normal) - plane.offset);
    for (const Triangle3* face : {&tooth, &tool}) {
        const Vec3 area = ((*face)[1] - (*face)[0]).cross((*face)[2] - (*face)[0]);
        const double length = area.norm();
        if (!(length > 0)) continue;
        for (const Vec3& normal : {Vec3(area / length), Vec3(area / -length)}) {
            const double back = highestAlong(tooth, normal);
            if (lowestAlong(tool, normal) - back < needed) continue;
            plane.normal = normal;
            plane.offset = back;
            return;
        }
    }
}

/// Finds the plane that separates the pair best at the present pose. False if nothing separates it.
bool SlidingBody::refreshPlane(WatchedPair& watched) {
    const SurfacePart& part = partOf(*surface_, watched.pair.part);
    const Triangle3 tooth = cornersOf(part.mesh(), watched.pair.tooth);
    Triangle3 tool = tool_->corners(watched.pair.tool);
    for (Vec3& corner : tool) corner = pose_ * corner;
    SeparatingPlane& plane = watched.plane;
    const GjkResult result =
        distanceBetween(tooth, tool, plane.normal.isZero() ? Vec3(tool[0] - tooth[0]) : plane.normal);
    ++distances_;
    if (!result.separated) return false;
    plane = {result.normal, highestAlong(tooth, result.normal), poseStamp_};
    if (result.distance < kTouchingMargins * margin_) preferFace(tooth, tool, plane);
    planes_.store(part.id(), watched.pair, plane);
    return true;
}

/// Width of the slab between the pair along its plane, with the tool at the pose given, mm.
double SlidingBody::gapAt(const WatchedPair& watched, const Mat3& rotation, const Vec3& position) const {
    const Vec3& normal = watched.plane.normal;
    const Vec3 inTool = rotation.transpose() * normal;
    return lowestAlong(tool_->corners(watched.pair.tool), inTool) + normal.dot(position) - watched.plane.offset;
}

/// A tooth triangle, and a tool triangle at the start (three corners) and the end of an attempted step.
struct SlidingBody::SweptPair {
    Triangle3 tooth;
    std::array<Vec3, 6> swept;

    /// Whether the plane of this normal keeps the two apart the whole way.
    [[nodiscard]] bool partedBy(const Vec3& normal, double back, double margin) const {
        const std::span<const Vec3> corners(swept);
        return lowestAlong(corners.first(3), normal) > back && lowestAlong(corners.last(3), normal) - back >= margin;
    }
};

SlidingBody::SweptPair SlidingBody::sweep(const NearPair& pair, const Attempt& attempt) const {
    SweptPair result;
    result.tooth = cornersOf(partOf(*surface_, pair.part).mesh(), pair.tooth);
    const Triangle3 tool = tool_->corners(pair.tool);
    const Vec3 position = pose_.position + attempt.step;
    for (int corner = 0; corner < 3; ++corner) {
        result.swept[corner] = attempt.startMatrix * tool[corner] + pose_.position;
        result.swept[corner + 3] = attempt.matrix * tool[corner] + position;
    }
    return result;
}

/// Whether a plane is found that keeps the pair apart during the whole attempted step. Tried are the pair's own
/// direction, the plane remembered, those that hold the tool already (what touches separates its neighbourhood too),
/// then GJK on the swept tool triangle. What is found becomes the pair's certificate.
bool SlidingBody::provenSafe(std::size_t place, const Attempt& attempt) {
    const NearPair& pair = list_[place];
    const SweptPair swept = sweep(pair, attempt);
    const auto holds = [&](const Vec3& normal, double back) {
        if (!swept.partedBy(normal, back, margin_ / 2)) return false;
        list_.certify(place, tool_->corners(pair.tool), normal, back);
        return true;
    };
    const Vec3 direction = list_.direction(place);
    if (swept.partedBy(direction, highestAlong(swept.tooth, direction), margin_ / 2)) return true;
    const std::uint64_t partId = partOf(*surface_, pair.part).id();
    const SeparatingPlane* known = planes_.find(partId, pair);
    if (known != nullptr && holds(known->normal, known->offset)) return true;
    for (int i = 0; i < attempt.answer.activeCount; ++i) {
        const Vec3& normal = attempt.halfSpaces[attempt.answer.active[i]].normal;
        if (holds(normal, highestAlong(swept.tooth, normal))) return true;
    }
    const Vec3 guess = known != nullptr ? known->normal : direction;
    const GjkResult result = distanceBetween(swept.tooth, swept.swept, guess);
    ++distances_;
    if (result.gap < margin_ / 2) return false;
    const SeparatingPlane plane{result.normal, highestAlong(swept.tooth, result.normal), kGuessed};
    planes_.store(partId, pair, plane);
    list_.certify(place, tool_->corners(pair.tool), plane.normal, plane.offset);
    return true;
}

/// A pair that the attempted step would bring together (the worst of the first few met).
SlidingBody::Offence SlidingBody::violation(const Attempt& attempt, WatchedPair& worst) {
    const Pose end{pose_.position + attempt.step, attempt.rotation};
    const Excursion excursion = list_.excursion(pose_, end, margin_);
    const std::size_t count = list_.withinReachOf(excursion);
    double worstGap = margin_ / 2;
    int offenders = 0;
    for (std::size_t first = 0; first < count; first += 8) {
        for (std::uint32_t doubt = list_.inDoubt(first, excursion); doubt != 0; doubt &= doubt - 1) {
            const std::size_t place = first + static_cast<std::size_t>(std::countr_zero(doubt));
            if (provenSafe(place, attempt)) continue;
            WatchedPair watched = watch(place);
            if (watched.plane.stamp != poseStamp_ && !refreshPlane(watched)) return Offence::Overlapping;
            // A tool that stands nearer than the margin (a new surface under it, another margin) may stay as near.
            const double start = gapAt(watched, attempt.startMatrix, pose_.position);
            const double gap = gapAt(watched, attempt.matrix, end.position);
            if (gap >= std::min(margin_ / 2, kStillNear * start)) continue;
            if (gap < worstGap) worstGap = gap, worst = watched;
            if (++offenders == kOffendersToCompare) return Offence::Found;
        }
    }
    return offenders > 0 ? Offence::Found : Offence::None;
}

void SlidingBody::addConstraint(Attempt& attempt, const WatchedPair& watched) const {
    const double gap = gapAt(watched, attempt.matrix, pose_.position);
    // Without a turn, staying put is always allowed: a gap that rounding has left below the margin may stay so.
    const double offset = attempt.turnFraction == 0 ? std::min(0.0, margin_ - gap) : margin_ - gap;
    attempt.watched[attempt.planeCount] = watched;
    attempt.halfSpaces[attempt.planeCount++] = {watched.plane.normal, offset};
}

/// Begins with the contacts of the round before: nearly always they are still the ones.
void SlidingBody::restart(Attempt& attempt) {
    attempt.planeCount = 0;
    for (int i = 0; i < heldCount_; ++i) {
        if (held_[i].plane.stamp == poseStamp_ || refreshPlane(held_[i])) addConstraint(attempt, held_[i]);
    }
}

/// The step nearest to the goal under the planes met so far, shortened to the allowance.
bool SlidingBody::solve(Attempt& attempt) {
    const std::span<const HalfSpace> halfSpaces(attempt.halfSpaces.data(),
                                                static_cast<std::size_t>(attempt.planeCount));
    const double tolerance = margin_ * 1e-3;
    attempt.answer = nearestInPolyhedron(halfSpaces, attempt.goal.position - pose_.position, tolerance);
    if (!attempt.answer.feasible) return false;
    attempt.step = attempt.answer.point;
    attempt.clipped = false;
    const double travel = list_.travelTo(attempt.rotation, pose_.position + attempt.step);
    const double spent = list_.travelTo(attempt.rotation, pose_.position);
    const double room = std::min(list_.reach() * kTrusted - margin_ - spent, attempt.allowance);
    if (travel <= list_.reach() * kTrusted - margin_ && attempt.step.norm() <= attempt.allowance) return true;
    attempt.clipped = true;
    if (room <= 0) return false;
    const double length = attempt.step.norm();
    const NearestInPolyhedron shorter =
        nearestInPolyhedron(halfSpaces, attempt.step * std::min(1.0, 0.9 * room / length), tolerance);
    if (!shorter.feasible || shorter.point.norm() > room) return false;
    attempt.step = shorter.point;
    return true;
}

/// Collects planes until the step that they leave is safe. False if there is none within the fixed budget.
bool SlidingBody::findSafeStep(Attempt& attempt, bool& overlapping) {
    restart(attempt);
    while (true) {
        if (!solve(attempt)) {
            if (attempt.turnFraction == 0) return false;
            attempt.turnsFully = false;
            attempt.turnBy(pose_.rotation, attempt.turnFraction > kLeastTurn ? attempt.turnFraction / 4 : 0);
            restart(attempt);
            continue;
        }
        WatchedPair offender;
        const Offence offence = violation(attempt, offender);
        overlapping = offence == Offence::Overlapping;
        if (overlapping) return false;
        if (offence == Offence::None) return true;
        if (attempt.planeCount < kMaxPlanesPerRound) {
            addConstraint(attempt, offender);
        } else if (attempt.allowance > kSettledMargins * margin_) {
            attempt.allowance /= 8;
            restart(attempt);
        } else {
            return false;
        }
    }
}

void SlidingBody::accept(const Attempt& attempt, MoveResult& result) {
    pose_.rotation = attempt.rotation;
    pose_.position += attempt.step;
    ++poseStamp_;
    heldCount_ = attempt.answer.activeCount;
    result.contactCount = heldCount_;
    for (int i = 0; i < heldCount_; ++i) {
        const int plane = attempt.answer.active[i];
        held_[i] = attempt.watched[plane];
        const Vec3& normal = held_[i].plane.normal;
        const Triangle3 tool = tool_->corners(held_[i].pair.tool);
        Vec3 deepest = pose_ * tool[0];
        for (const Vec3& corner : tool) {
            if (const Vec3 point = pose_ * corner; normal.dot(point) < normal.dot(deepest)) deepest = point;
        }
        result.contacts[i] = {normal, deepest, attempt.answer.multiplier[i], held_[i].pair.part, held_[i].pair.tooth};
    }
}

MoveResult SlidingBody::moveToward(const Pose& goal) {
    MoveResult result;
    if (!(tool_->radius() > 0)) {  // nothing that could touch
        placeAt(goal);
        return result;
    }
    distances_ = 0;
    const double position = std::max(goal.position.cwiseAbs().maxCoeff(), pose_.position.cwiseAbs().maxCoeff());
    margin_ = kMarginOfRadius * tool_->radius() + kMarginOfPosition * position;
    const Vec3 goalCentre = goal * tool_->centre();
    handTravel_ =
        (goalCentre - lastGoalCentre_).norm() + 2 * sineOfHalfAngle(goal.rotation, pose_.rotation) * tool_->radius();
    lastGoalCentre_ = goalCentre;
    result.status = MoveStatus::OutOfRounds;
    Attempt attempt;
    bool isFresh = false;  // whether the round began without planes of the round before
    while (result.status == MoveStatus::OutOfRounds && result.rounds < kMaxRounds) {
        ++result.rounds;
        bool overlapping = false;
        if (!plan(goal, attempt) || !findSafeStep(attempt, overlapping)) {
            if (overlapping) result.status = MoveStatus::Overlapping;
            break;
        }
        const double turned = 2 * sineOfHalfAngle(attempt.rotation, pose_.rotation) * tool_->radius();
        const bool settled = attempt.step.norm() + turned <= kSettledMargins * margin_;
        accept(attempt, result);
        if (settled && !attempt.clipped && heldCount_ > 0 && !isFresh) {
            // Planes carried over may add up to a stop where fresh ones would let the tool go on: look again without.
            heldCount_ = 0;
            isFresh = true;
            continue;
        }
        isFresh = false;
        if (attempt.clipped) continue;
        if (attempt.turnsFully && heldCount_ == 0) {
            result.status = MoveStatus::Reached;
        } else if (settled) {
            result.status = MoveStatus::Held;
        }
    }
    result.distances = distances_;
    return result;
}

}  // namespace tactooth
