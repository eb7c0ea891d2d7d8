// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "collision/proxy/proxy_solver_iteration.h"

// Where two triangles touch at an edge or a corner, many planes part them, and the one at hand may forbid what they
// allow. A tool that has settled looks here for planes that let it go on.

namespace tactooth {
namespace {

constexpr double kThinnest = 0.25;     // of the margin: what a plane must leave that lets the tool go on
constexpr double kRelativeGap = 0.9;   // ... or of what the plane at hand leaves, if that is less
constexpr double kTiltMargin = 0.6;    // ... by leaning over an edge: more than a look asks of the pairs beside
constexpr double kTiltReach = 0.0625;  // a lean is worth its round up to a quarter of the distance that it could pass
constexpr double kWorthMargins = 20;   // a way on that is shorter is none ...
constexpr double kWorthGain = 0.1;     // ... nor is one that comes no nearer to the goal than by so many margins

/// The directions across which two triangles may touch: along the normals of either, and of each pair of edges.
struct ContactDirections {
    static constexpr int kOfPair = 2 * (2 + 9);
    static constexpr int kOverEdges = 2 * (9 + 9);
    std::array<Vec3, kOfPair + kMaxHeld + kOverEdges> unit;
    int count = 0;

    ContactDirections(const Triangle3& a, const Triangle3& b) {
        std::array<Vec3, 3> ofA, ofB;
        for (int i = 0; i < 3; ++i) ofA[i] = edgeOf(a, i), ofB[i] = edgeOf(b, i);
        add(ofA[0].cross(ofA[1]));
        add(ofB[0].cross(ofB[1]));
        for (const Vec3& edge : ofA) {
            for (const Vec3& other : ofB) add(edge.cross(other));
        }
    }

    /// And across planes that lean over an edge, so far that they leave `least` to a corner of the other triangle
    /// beside it. The corner is no farther from it than the root of `reach`.
    void addTilted(const Triangle3& tooth, const Triangle3& tool, double least, double reach) {
        for (int i = 0; i < 3; ++i) {
            const Vec3 ofTooth = edgeOf(tooth, i);
            const Vec3 ofTool = edgeOf(tool, i);
            for (int k = 0; k < 3; ++k) {
                tiltOver(ofTooth, tool[k] - tooth[i], least, reach);
                tiltOver(ofTool, tool[i] - tooth[k], least, reach);
            }
        }
    }

private:
    [[nodiscard]] static Vec3 edgeOf(const Triangle3& triangle, int i) { return triangle[(i + 1) % 3] - triangle[i]; }

    void add(const Vec3& direction) {
        const double length = direction.norm();
        if (!(length > 0)) return;
        unit[count++] = direction / length;
        unit[count++] = direction / -length;
    }

    void tiltOver(const Vec3& edge, const Vec3& fromToothToTool, double least, double reach) {
        if (!(fromToothToTool.cross(edge).squaredNorm() < reach * edge.squaredNorm())) return;
        const Vec3 across = fromToothToTool - fromToothToTool.dot(edge) / edge.squaredNorm() * edge;
        const double share = least / across.squaredNorm();
        if (!(least * share < 1)) return;  // nearer than that already
        const Vec3 up = share * across;
        const Vec3 aside = std::sqrt(1 - least * share) * edge.cross(across).normalized();
        unit[count++] = up + aside;
        unit[count++] = up - aside;
    }
};

}  // namespace

/// What holds a settled tool, or else stands in its way there, with the planes that let it through no further.
struct ProxySolver::ContactPlane {
    WatchedPair* watched = nullptr;
    Triangle3 tooth, tool;
    double gap = 0;    // that the plane at hand leaves between the two, mm
    double least = 0;  // that a plane must leave between the two, mm

    [[nodiscard]] HalfSpace spaceAcross(const Vec3& normal, double back, double margin) const {
        return {normal, std::min(0.0, margin - (lowestAlong(tool, normal) - back))};
    }
    /// The steps that the plane across a direction allows, if it parts the pair.
    [[nodiscard]] std::optional<HalfSpace> spaceAcross(const Vec3& normal, double margin) const {
        const double back = highestAlong(tooth, normal);
        if (lowestAlong(tool, normal) - back < least) return {};
        return spaceAcross(normal, back, margin);
    }
};

ProxySolver::ContactPlane ProxySolver::contactPlaneOf(WatchedPair& watched) const {
    ContactPlane hold{&watched, cornersOf(partOf(*surface_, watched.pair.part).mesh(), watched.pair.tooth),
                      tool_->cornersAt(pose_, watched.pair.tool), 0, 0};
    hold.gap = lowestAlong(hold.tool, watched.plane.normal) - watched.plane.offset;
    hold.least = std::min(kThinnest * margin_, kRelativeGap * hold.gap);
    return hold;
}

/// Looks among the other planes of each contact for one that lets the settled tool go on, and takes it. What else has
/// been seen to stand in the way here counts as well, and is kept in mind for the round to come.
bool ProxySolver::switchContactPlanes(const Pose& goal, Attempt& attempt) {
    storeWarmStart(attempt);
    std::array<ContactPlane, kMaxContactPlanes> holds;
    std::array<HalfSpace, kMaxContactPlanes> spaces;
    std::size_t count = 0;
    const auto add = [&](WatchedPair& watched) {
        holds[count] = contactPlaneOf(watched);
        spaces[count] = holds[count].spaceAcross(watched.plane.normal, watched.plane.offset, margin_);
        ++count;
    };
    for (int i = 0; i < heldCount_; ++i) {
        if (!hasPlane(held_[i])) return false;
        add(held_[i]);
    }
    for (int i = 0; i < attempt.warmStartCount; ++i) add(attempt.warmStart[i]);
    const Vec3 toGoal = goal.position - pose_.position;
    for (std::size_t i = 0; i < static_cast<std::size_t>(heldCount_); ++i) {
        if (switchPlane(i, std::span(holds).first(count), std::span(spaces).first(count), toGoal)) return true;
    }
    return false;
}

/// The pairs that a round met which has left the tool where it stood, beside those that hold it.
void ProxySolver::storeWarmStart(Attempt& attempt) const {
    attempt.warmStartCount = 0;
    const auto active = std::span(attempt.active).first(static_cast<std::size_t>(attempt.activeCount));
    for (int i = 0; i < attempt.planeCount && attempt.warmStartCount < kMaxWarmStart; ++i) {
        const bool isHeld = std::ranges::find(active, i) != active.end();
        if (!isHeld && attempt.watched[i].plane.stamp == poseStamp_)
            attempt.warmStart[attempt.warmStartCount++] = attempt.watched[i];
    }
}

/// Whether planes leave a way on that brings the tool nearer to the goal by more than one plane or the other of the
/// same pair tells: at an edge they may lead to and fro.
bool ProxySolver::allowsProgress(std::span<const HalfSpace> spaces, const Vec3& toGoal) const {
    const Qp3Result answer = solveQp3(spaces, toGoal, margin_ * kSolved);
    if (!answer.feasible || answer.point.norm() <= kWorthMargins * margin_) return false;
    // Squares: their difference is about twice the distance times what it becomes less.
    const double gain = toGoal.squaredNorm() - (toGoal - answer.point).squaredNorm();
    return gain > 2 * toGoal.norm() * kWorthGain * margin_;
}

/// switchContactPlanes for one contact; the first `heldCount_` of the holds are contacts. Where all of them share the
/// feature that touches (a face of the tool on a corner of the tooth) one plane may part them all, and only if all take
/// it can the tool go on.
bool ProxySolver::switchPlane(std::size_t contact, std::span<ContactPlane> holds, std::span<HalfSpace> spaces,
                              const Vec3& toGoal) {
    const ContactPlane& hold = holds[contact];
    const HalfSpace own = spaces[contact];
    ContactDirections directions(hold.tooth, hold.tool);
    for (int other = 0; other < heldCount_; ++other) {  // an edge that two of the tool's triangles share
        if (&held_[other] != hold.watched) directions.unit[directions.count++] = held_[other].plane.normal;
    }
    // At a distance d beside an edge that leads on, the tool stands at a minimum of d^2 / (2 depth): far less than the
    // margin. A plane that leans over the edge leans by the loss of gap over d; so does the way along it, which passes
    // the edge if d^2 < loss * depth.
    const double least = std::min(kTiltMargin * margin_, kRelativeGap * hold.gap);
    directions.addTilted(hold.tooth, hold.tool, least, kTiltReach * (hold.gap - least) * toGoal.norm());
    for (int i = 0; i < directions.count; ++i) {
        const Vec3& normal = directions.unit[i];
        if (normal.dot(own.normal) > kSamePlane) continue;
        const std::optional<HalfSpace> space = hold.spaceAcross(normal, margin_);
        if (!space) continue;
        spaces[contact] = *space;
        if (allowsProgress(spaces, toGoal)) {
            take(hold, normal);
            return true;
        }
        if (switchPlanesTogether(contact, holds, spaces, toGoal)) return true;
    }
    spaces[contact] = own;
    return false;
}

/// Whether the plane that a contact has got lets the tool go on if all others that it parts take it too. They do.
bool ProxySolver::switchPlanesTogether(std::size_t contact, std::span<ContactPlane> holds,
                                       std::span<const HalfSpace> spaces, const Vec3& toGoal) {
    std::array<HalfSpace, kMaxContactPlanes> together;
    std::array<bool, kMaxContactPlanes> takes{};
    const Vec3 normal = spaces[contact].normal;
    for (std::size_t i = 0; i < holds.size(); ++i) {
        const std::optional<HalfSpace> space = holds[i].spaceAcross(normal, margin_);
        takes[i] = space.has_value();
        together[i] = space.value_or(spaces[i]);
    }
    if (std::ranges::count(takes, true) < 2 || !allowsProgress(std::span(together).first(holds.size()), toGoal))
        return false;
    for (std::size_t i = 0; i < holds.size(); ++i) {
        if (takes[i]) take(holds[i], normal);
    }
    return true;
}

void ProxySolver::take(const ContactPlane& hold, const Vec3& normal) {
    hold.watched->plane = {normal, highestAlong(hold.tooth, normal), poseStamp_};
    planes_.store(partOf(*surface_, hold.watched->pair.part).id(), hold.watched->pair, hold.watched->plane);
}

}  // namespace tactooth
