// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/sliding_body.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "collision/gjk.h"

// God object: C. B. Zilles, J. K. Salisbury, "A Constraint-based God-object Method for Haptic Display", IROS 1995; for
// a body with a shape: M. Ortega, S. Redon, S. Coquillart, "A Six Degree-of-Freedom God-Object Method for Haptic
// Display of Rigid Bodies with Surface Properties", IEEE TVCG 13(3), 2007, sections 3-4. Pair list with a skin: L.
// Verlet, "Computer Experiments on Classical Fluids", Phys. Rev. 159, 1967.
//
// One round: the planes that separate the pairs of triangles at the present, free pose bound a convex region of moves
// that are all safe, the whole way. The move nearest to the goal inside that region is found lazily: solve with the
// planes met so far, look for the pair that the answer would bring together most, add its plane, solve again. Then the
// body moves and the planes are found anew. Differs from Ortega: contacts need not be touched one after the other, and
// a finely meshed surface costs no more rounds than a coarse one.

namespace tactooth {
namespace {

constexpr std::size_t kMaxPairs = 1 << 15;  // a bur that fills its own slot in a 25 um mesh lists some 20,000
constexpr int kMaxRounds = 12;              // 2-3 are usual at 1 cm/s, 4-6 at 10 cm/s
constexpr int kMaxPlanesPerRound = 40;
constexpr int kBuckets = 32;
constexpr double kMarginOfRadius = 1e-7;      // 0.3 nm for a 6 mm bur
constexpr double kMarginOfPosition = 1e-10;   // keeps the margin above rounding far from the origin
constexpr double kSettledMargins = 10;        // a round that moves less than this many margins ends the move
constexpr double kLeastReach = 0.004;         // of the tool's radius: 12 um for a 6 mm bur
constexpr double kGreatestReach = 1.0;        // of the tool's radius
constexpr std::size_t kPlentyOfPairs = 4096;  // a longer list costs more to walk than listing twice
constexpr double kTrusted = 0.95;             // of the listed reach: leaves room for rounding

double sineOfHalfAngle(const Quat& a, const Quat& b) { return (a * b.conjugate()).vec().norm(); }

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
    Vec3 step = Vec3::Zero();
    bool clipped = false;  // the step was shortened to the allowance
    NearestInPolyhedron answer;
    int planeCount = 0;
    std::array<NearPair, kMaxPlanesPerRound> pairs;
    std::array<HalfSpace, kMaxPlanesPerRound> halfSpaces;

    void turnBy(const Quat& from, double fraction) {
        turnFraction = fraction;
        rotation = fraction > 0 ? partOfTurn(from, goal.rotation, fraction) : from;
        matrix = rotation.toRotationMatrix();
        planeCount = 0;
    }
};

SlidingBody::SlidingBody(std::shared_ptr<const ToolShape> tool)
    : tool_(std::move(tool)), pairs_(kMaxPairs), found_(kMaxPairs) {
    assert(tool_ != nullptr);
}

std::shared_ptr<const Surface> SlidingBody::setSurface(std::shared_ptr<const Surface> surface) {
    std::swap(surface_, surface);
    heldCount_ = 0;
    forgetList();
    return surface;
}

void SlidingBody::placeAt(const Pose& toolInTooth) {
    pose_ = toolInTooth;
    ++poseStamp_;
    heldCount_ = 0;
    recentTravel_ = 0;
    forgetList();
}

/// No point of the tool has moved further than this since the pairs were listed.
double SlidingBody::travelSinceListed(const Quat& rotation, const Vec3& position) const {
    const Vec3 centre = rotation * tool_->centre() + position;
    const Vec3 listedCentre = listedAt_ * tool_->centre();
    return (centre - listedCentre).norm() + 2 * sineOfHalfAngle(rotation, listedAt_.rotation) * tool_->radius();
}

/// Lists the pairs within `wantedReach`, or within less where they are too many.
void SlidingBody::listPairs(double wantedReach) {
    const double least = kLeastReach * tool_->radius();
    double reach = std::clamp(wantedReach, least, kGreatestReach * tool_->radius());
    NearPairsFound found = findNearPairs(*surface_, *tool_, pose_, reach, std::span(found_).first(kPlentyOfPairs));
    while (!found.complete && reach > least) {
        reach = std::max(least, reach / 4);
        found = findNearPairs(*surface_, *tool_, pose_, reach, found_);
    }
    std::array<std::uint32_t, kBuckets + 1> start{};
    const float scale = static_cast<float>(kBuckets / reach);
    const auto bucketOf = [scale](const NearPair& pair) {
        return std::min(kBuckets - 1, static_cast<int>(pair.distanceAtLeast * scale));
    };
    for (std::size_t i = 0; i < found.count; ++i) ++start[bucketOf(found_[i]) + 1];
    for (int i = 0; i < kBuckets; ++i) start[i + 1] += start[i];
    for (std::size_t i = 0; i < found.count; ++i) pairs_[start[bucketOf(found_[i])]++] = found_[i];
    pairCount_ = found.count;
    listedAt_ = pose_;
    listedReach_ = found.complete ? reach : 0;
    listed_ = true;
}

/// Sets up a round: makes sure of the pair list and bounds turn and step by what the list covers.
bool SlidingBody::plan(const Pose& goal, Attempt& attempt) {
    attempt.goal = goal;
    const double turn = sineOfHalfAngle(goal.rotation, pose_.rotation);
    const double remaining = (goal * tool_->centre() - pose_ * tool_->centre()).norm() + 2 * turn * tool_->radius();
    const double least = kLeastReach * tool_->radius();
    double used = listed_ ? travelSinceListed(pose_.rotation, pose_.position) : 0;
    if (!listed_ || listedReach_ * kTrusted - used < std::min(remaining, least / 2)) {
        listPairs(std::min(1.1 * remaining, 4 * recentTravel_) + least);
        used = 0;
    }
    attempt.allowance = listedReach_ * kTrusted - used - margin_;
    if (attempt.allowance <= 0) return false;
    const double turnTravel =
        2 * turn * tool_->radius() + (goal.rotation * tool_->centre() - pose_.rotation * tool_->centre()).norm();
    const double fraction = turnTravel > attempt.allowance / 2 ? attempt.allowance / 2 / turnTravel : 1;
    attempt.turnsFully = fraction >= 1;
    attempt.turnBy(pose_.rotation, turnTravel > 0 ? fraction : 0);
    return true;
}

/// Finds the plane that separates the pair best at the present pose. False if nothing separates it.
bool SlidingBody::refreshPlane(const NearPair& pair, SeparatingPlane& plane) {
    const Triangle3 tooth = cornersOf(partOf(*surface_, pair.part).mesh(), pair.tooth);
    Triangle3 tool = cornersOf(tool_->mesh(), pair.tool);
    const Mat3 matrix = pose_.rotation.toRotationMatrix();
    for (Vec3& corner : tool) corner = matrix * corner + pose_.position;
    const Vec3 guess = plane.normal.isZero() ? Vec3(tool[0] - tooth[0]) : plane.normal;
    const GjkResult result = distanceBetween(tooth, tool, guess);
    ++distances_;
    if (!result.separated) return false;
    plane.normal = result.normal;
    plane.offset = highestAlong(tooth, result.normal);
    plane.stamp = poseStamp_;
    return true;
}

/// Width of the slab between the pair along its plane, with the tool at the pose given, mm.
double SlidingBody::gapAt(const NearPair& pair, const SeparatingPlane& plane, const Mat3& rotation,
                          const Vec3& position) const {
    const Vec3 inTool = rotation.transpose() * plane.normal;
    return lowestAlong(cornersOf(tool_->mesh(), pair.tool), inTool) + plane.normal.dot(position) - plane.offset;
}

/// The listed pair that the attempted move would bring together most, or null if the move is safe.
const NearPair* SlidingBody::worstViolation(const Attempt& attempt, bool& overlapping) {
    const Vec3 position = pose_.position + attempt.step;
    const double travel = travelSinceListed(attempt.rotation, position) + margin_;
    const float bucketWidth = static_cast<float>(listedReach_ / kBuckets);
    const NearPair* worst = nullptr;
    double worstGap = margin_ / 2;
    for (std::size_t i = 0; i < pairCount_; ++i) {
        const NearPair& pair = pairs_[i];
        if (pair.distanceAtLeast > travel) {
            if (pair.distanceAtLeast > travel + bucketWidth) break;  // buckets are sorted, pairs inside one are not
            continue;
        }
        SeparatingPlane& plane = planes_.of(partOf(*surface_, pair.part).id(), pair);
        const bool known = !plane.normal.isZero();
        double gap = known ? gapAt(pair, plane, attempt.matrix, position) : -1;
        if (gap >= margin_ / 2) continue;
        if (!known || plane.stamp != poseStamp_) {
            if (!refreshPlane(pair, plane)) {
                overlapping = true;
                return nullptr;
            }
            gap = gapAt(pair, plane, attempt.matrix, position);
        }
        if (gap < worstGap) worstGap = gap, worst = &pair;
    }
    return worst;
}

void SlidingBody::addConstraint(Attempt& attempt, const NearPair& pair) {
    const SeparatingPlane& plane = planes_.of(partOf(*surface_, pair.part).id(), pair);
    const double gap = gapAt(pair, plane, attempt.matrix, pose_.position);
    // Without a turn, staying put is always allowed: a gap that rounding has left below the margin may stay so.
    const double offset = attempt.turnFraction == 0 ? std::min(0.0, margin_ - gap) : margin_ - gap;
    attempt.pairs[attempt.planeCount] = pair;
    attempt.halfSpaces[attempt.planeCount++] = {plane.normal, offset};
}

/// Begins with the contacts of the round before: nearly always they are still the ones.
void SlidingBody::warmStart(Attempt& attempt) {
    for (int i = 0; i < heldCount_; ++i) {
        SeparatingPlane& plane = planes_.of(partOf(*surface_, held_[i].part).id(), held_[i]);
        if (plane.stamp == poseStamp_ || refreshPlane(held_[i], plane)) addConstraint(attempt, held_[i]);
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
    const double travel = travelSinceListed(attempt.rotation, pose_.position + attempt.step);
    const double spent = travelSinceListed(attempt.rotation, pose_.position);
    const double room = listedReach_ * kTrusted - margin_ - spent;
    if (travel <= listedReach_ * kTrusted - margin_) return true;
    attempt.clipped = true;
    if (room <= 0) return false;
    const double length = attempt.step.norm();
    const NearestInPolyhedron shorter =
        nearestInPolyhedron(halfSpaces, attempt.step * std::min(1.0, 0.9 * room / length), tolerance);
    if (!shorter.feasible || shorter.point.norm() > room) return false;
    attempt.step = shorter.point;
    return true;
}

void SlidingBody::accept(const Attempt& attempt, MoveResult& result) {
    pose_.rotation = attempt.rotation;
    pose_.position += attempt.step;
    ++poseStamp_;
    heldCount_ = attempt.answer.activeCount;
    result.contactCount = heldCount_;
    for (int i = 0; i < heldCount_; ++i) {
        const int plane = attempt.answer.active[i];
        const NearPair& pair = attempt.pairs[plane];
        held_[i] = pair;
        const Vec3& normal = attempt.halfSpaces[plane].normal;
        Triangle3 tool = cornersOf(tool_->mesh(), pair.tool);
        Vec3 deepest = pose_ * tool[0];
        for (const Vec3& corner : tool) {
            if (const Vec3 point = pose_ * corner; normal.dot(point) < normal.dot(deepest)) deepest = point;
        }
        result.contacts[i] = {normal, deepest, attempt.answer.multiplier[i], pair.part, pair.tooth};
    }
}

MoveResult SlidingBody::moveToward(const Pose& goal) {
    MoveResult result;
    distances_ = 0;
    const double position = std::max(goal.position.cwiseAbs().maxCoeff(), pose_.position.cwiseAbs().maxCoeff());
    margin_ = kMarginOfRadius * tool_->radius() + kMarginOfPosition * position;
    const Vec3 startCentre = pose_ * tool_->centre();
    result.status = MoveStatus::OutOfRounds;
    Attempt attempt;
    for (result.rounds = 1; result.rounds <= kMaxRounds; ++result.rounds) {
        if (!plan(goal, attempt)) break;
        warmStart(attempt);
        bool safe = false;
        bool overlapping = false;
        while (!safe) {
            if (!solve(attempt)) {
                if (attempt.turnFraction == 0) break;
                attempt.turnsFully = false;
                attempt.turnBy(pose_.rotation, attempt.turnFraction > 1e-3 ? attempt.turnFraction / 4 : 0);
                warmStart(attempt);
                continue;
            }
            const NearPair* worst = worstViolation(attempt, overlapping);
            if (overlapping || (worst != nullptr && attempt.planeCount == kMaxPlanesPerRound)) break;
            if (worst == nullptr) {
                safe = true;
            } else {
                addConstraint(attempt, *worst);
            }
        }
        if (overlapping) {
            result.status = MoveStatus::Overlapping;
            break;
        }
        if (!safe) break;
        const double turned = 2 * sineOfHalfAngle(attempt.rotation, pose_.rotation) * tool_->radius();
        accept(attempt, result);
        const bool arrived = attempt.turnsFully && !attempt.clipped;
        const bool settled = attempt.step.norm() + turned <= kSettledMargins * margin_;
        if (arrived && heldCount_ == 0) {
            result.status = MoveStatus::Reached;
            break;
        }
        if (settled && !attempt.clipped) {
            result.status = MoveStatus::Held;
            break;
        }
    }
    result.rounds = std::min(result.rounds, kMaxRounds);
    result.distances = distances_;
    recentTravel_ = std::max((pose_ * tool_->centre() - startCentre).norm(), recentTravel_ / 2);
    return result;
}

}  // namespace tactooth
