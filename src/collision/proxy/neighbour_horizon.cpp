// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/neighbour_horizon.h"

#include <algorithm>
#include <cmath>
#include <utility>

// Renewal of a Verlet list ahead of its end: L. Verlet, "Computer Experiments on Classical Fluids", Phys. Rev. 159,
// 1967. Differs from the paper: the list is built along the expected displacement instead of evenly around the tool.

namespace tactooth {
namespace {

// A longer list lasts longer and costs more in every iteration.
constexpr double kStride = 1.2;         // displacements of the goal that a list should last, and in addition:
constexpr double kAhead = 6;            // the least contact margin so many times
constexpr double kMaxDeviation = 0.25;  // share of both by which the tool may leave the expected displacement

// Lists of one move; the rest of the displacement waits for the next tick. A device whose tracking was lost for a while
// jumps, and did not lead the tool around the tooth.
constexpr int kMaxLists = 40;
constexpr int kMaxListsOfJump = 28;
constexpr double kJump = 0.5;  // of the tool's radius: 5 mm for a bur with its shank, more than a hand moves in a tick
constexpr int kUnchangedLists = 8;  // are as long as the first; each later one is twice as long

}  // namespace

bool NeighbourHorizon::covers(const Pose& pose, double margin) const {
    return list_.made() && coversPosition(pose.position, margin) &&
           list_.chordTo(pose.rotation) <= list_.contactMargin().turn * kTrusted;
}

bool NeighbourHorizon::isFresh(const Pose& pose) const {
    constexpr double kListUsedUp = 0.85;  // of the contact margin
    return list_.made() && list_.isLong() && list_.chordTo(pose.rotation) <= kListUsedUp * list_.contactMargin().turn &&
           list_.deviation(pose.position) <= kListUsedUp * list_.contactMargin().around;
}

double NeighbourHorizon::coveredShare(const ProxyScene& scene, const Vec3& step) const {
    TACTOOTH_ASSERT(step.allFinite());
    const auto isCovered = [&](double share) {
        return coversPosition(scene.pose.position + share * step, scene.margin);
    };
    if (coversPosition(scene.pose.position + step, scene.margin)) return 1;
    const double farthest = list_.contactMargin().along.norm() + 2 * list_.contactMargin().around;
    double inside = 0;
    double outside = std::min(1.0, farthest / step.norm());
    for (int i = 0; i < 10; ++i) {
        const double middle = (inside + outside) / 2;
        (isCovered(middle) ? inside : outside) = middle;
    }
    TACTOOTH_ASSERT(inside >= 0 && inside <= 1);
    return inside;
}

void NeighbourHorizon::beginMove(double goalShift, double goalRotation) {
    TACTOOTH_ASSERT(goalShift >= 0 && std::isfinite(goalShift));
    TACTOOTH_ASSERT(goalRotation >= 0 && std::isfinite(goalRotation));
    goalShift_ = goalShift;
    goalRotation_ = goalRotation;
    rebuilds_ = 0;
}

bool NeighbourHorizon::mayWait(const Pose& pose, bool isBudgetLimited) const {
    return isBudgetLimited && list_.isLong() && wait_.mayWait(isFresh(pose));
}

bool NeighbourHorizon::isExhausted(const Pose& pose, const Vec3& displacement, double turn,
                                   bool isBudgetLimited) const {
    TACTOOTH_ASSERT(list_.made());
    TACTOOTH_ASSERT(displacement.allFinite() && turn >= 0);
    constexpr double kLittle = 0.125;  // of the least contact margin: the displacement is not known to the last um
    if (isBudgetLimited && isFresh(pose)) return false;  // a new list would cover less than what is left
    if (rotationLeft(pose.rotation) < std::min(turn, goalRotation_)) return true;
    const double length = displacement.norm();
    const Vec3 end =
        pose.position + (length > 2 * goalShift_ ? Vec3(displacement * (2 * goalShift_ / length)) : displacement);
    return list_.deviation(end) + kLittle * list_.leastAround() > list_.contactMargin().around * kTrusted;
}

bool NeighbourHorizon::mayRebuild(double toolRadius) const {
    return rebuilds_ < (goalShift_ < kJump * toolRadius ? kMaxLists : kMaxListsOfJump);
}

void NeighbourHorizon::rebuild(const ProxyScene& scene, const Vec3& displacement, double turn) {
    TACTOOTH_ASSERT(scene.surface != nullptr);
    TACTOOTH_ASSERT(mayRebuild(scene.tool->radius()));
    TACTOOTH_ASSERT(displacement.allFinite() && turn >= 0);
    const double length = displacement.norm();
    const double growth = std::ldexp(1.0, std::max(0, ++rebuilds_ - kUnchangedLists));
    const double little = growth * list_.leastAround();
    const double stride = kStride * std::min(length, growth * goalShift_) + kAhead * little;
    const double spin = kStride * std::min(turn, growth * goalRotation_) + kAhead * NeighbourList::leastRotation();
    const Vec3 along = length > 0 ? Vec3(displacement * (stride / length)) : Vec3(Vec3::Zero());
    list_.make(*scene.surface, scene.pose, {along, little + kMaxDeviation * stride, spin});
    ++ownRebuilds_;
    wait_.listBuilt();
    TACTOOTH_ASSERT(list_.made());
}

void NeighbourHorizon::take(NeighbourList& near) {
    TACTOOTH_ASSERT(&near != &list_);
    std::swap(list_, near);
    wait_.listGiven();
}

}  // namespace tactooth
