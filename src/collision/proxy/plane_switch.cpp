// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/plane_switch.h"

#include <algorithm>

// Own method, without a published source: the planes of a contact are chosen among all separating planes by the
// progress that they allow toward the goal.

namespace tactooth {
namespace {

constexpr double kThinnest = 0.25;     // of the margin: what a plane must leave that lets the tool move on
constexpr double kRelativeGap = 0.9;   // ... or of what the plane at hand leaves, if that is less
constexpr double kTiltMargin = 0.6;    // ... if it is tilted over an edge: more than a check asks of other pairs
constexpr double kTiltReach = 0.0625;  // a tilt is tried up to a quarter of the distance that it could pass
constexpr double kWorthMargins = 20;   // a shorter displacement is none ...
constexpr double kWorthGain = 0.1;     // ... nor is one that comes no nearer to the goal than by so many margins

}  // namespace

HalfSpace PlaneSwitch::Candidate::spaceOf(const Vec3& normal, double back, double margin) const {
    return {normal, std::min(0.0, margin - (lowestAlong(tool, normal) - back))};
}

std::optional<HalfSpace> PlaneSwitch::Candidate::separatingSpace(const Vec3& normal, double margin) const {
    const double back = highestAlong(tooth, normal);
    if (lowestAlong(tool, normal) - back < least) return {};
    return spaceOf(normal, back, margin);
}

void PlaneSwitch::addPair(WatchedPair& watched) {
    TACTOOTH_ASSERT(count_ < kCapacity);
    TACTOOTH_ASSERT(watched.plane.stamp == context_.scene.poseStamp);
    const ProxyScene& scene = context_.scene;
    Candidate& added = candidates_[count_];
    added = {&watched, scene.toothTriangle(watched.pair), scene.toolTriangle(watched.pair), 0, 0};
    added.gap = lowestAlong(added.tool, watched.plane.normal) - watched.plane.offset;
    added.least = std::min(kThinnest * scene.margin, kRelativeGap * added.gap);
    spaces_[count_] = added.spaceOf(watched.plane.normal, watched.plane.offset, scene.margin);
    ++count_;
}

bool PlaneSwitch::run() {
    TACTOOTH_ASSERT(contacts_ <= static_cast<std::size_t>(kMaxHeld));
    for (std::size_t i = 0; i < contacts_; ++i) {
        if (switchPlane(i)) return true;
    }
    return false;
}

/// Whether half-spaces leave a displacement that brings the tool nearer to the goal by more than two planes of the same
/// pair differ by: at an edge these may lead to and fro.
bool PlaneSwitch::allowsProgress(std::span<const HalfSpace> spaces) const {
    const double margin = context_.scene.margin;
    const Qp3Result answer = solveQp3(spaces, toGoal_, margin * kSolveTolerance);
    if (!answer.feasible || answer.point.norm() <= kWorthMargins * margin) return false;
    // Squares: their difference is about twice the distance times what it becomes less.
    const double gain = toGoal_.squaredNorm() - (toGoal_ - answer.point).squaredNorm();
    return gain > 2 * toGoal_.norm() * kWorthGain * margin;
}

/// Tries other planes for one contact, alone and together with the pairs that they separate as well.
bool PlaneSwitch::switchPlane(std::size_t contact) {
    const double margin = context_.scene.margin;
    const Candidate& own = candidates_[contact];
    const HalfSpace ownSpace = spaces_[contact];
    ContactDirections directions(own.tooth, own.tool);
    for (std::size_t other = 0; other < contacts_; ++other) {  // an edge that two of the tool's triangles share
        if (other != contact) directions.add(candidates_[other].watched->plane.normal);
    }
    // At a distance d beside an edge that leads on, the tool stands at a minimum of d^2 / (2 depth): far less than the
    // margin. A plane tilted over the edge leans by the loss of gap over d. So does the displacement along the plane,
    // which passes the edge if d^2 < loss * depth.
    const double least = std::min(kTiltMargin * margin, kRelativeGap * own.gap);
    directions.addTilted(own.tooth, own.tool, least, kTiltReach * (own.gap - least) * toGoal_.norm());
    for (int i = 0; i < directions.count(); ++i) {
        const Vec3& normal = directions[i];
        if (normal.dot(ownSpace.normal) > kSamePlane) continue;
        const std::optional<HalfSpace> space = own.separatingSpace(normal, margin);
        if (!space) continue;
        spaces_[contact] = *space;
        if (allowsProgress(std::span(spaces_).first(count_))) {
            take(own, normal);
            return true;
        }
        if (switchTogether(contact)) return true;
    }
    spaces_[contact] = ownSpace;
    return false;
}

/// Tries the plane of a contact for all pairs that it separates. Where several contacts share the feature that touches
/// (a face of the tool on a corner of the tooth), the tool can move on only if all of them take the same plane.
bool PlaneSwitch::switchTogether(std::size_t contact) {
    std::array<HalfSpace, kCapacity> together;
    std::array<bool, kCapacity> takes{};
    const Vec3 normal = spaces_[contact].normal;
    for (std::size_t i = 0; i < count_; ++i) {
        const std::optional<HalfSpace> space = candidates_[i].separatingSpace(normal, context_.scene.margin);
        takes[i] = space.has_value();
        together[i] = space.value_or(spaces_[i]);
    }
    if (std::ranges::count(takes, true) < 2 || !allowsProgress(std::span(together).first(count_))) return false;
    for (std::size_t i = 0; i < count_; ++i) {
        if (takes[i]) take(candidates_[i], normal);
    }
    return true;
}

void PlaneSwitch::take(const Candidate& candidate, const Vec3& normal) {
    context_.planes.replace(context_.scene, candidate.tooth, normal, *candidate.watched);
}

}  // namespace tactooth
