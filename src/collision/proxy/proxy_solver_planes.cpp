// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "collision/narrow/gjk.h"
#include "collision/proxy/proxy_solver_iteration.h"

// The planes that part pairs of triangles: how they are found, remembered and chosen, and which pairs a step would
// bring together. A swept triangle is the hull of its corners at both ends of the step (continuous collision by
// conservative bounds as in S. Redon, A. Kheddar, S. Coquillart, "Fast Continuous Collision Detection between Rigid
// Bodies", Computer Graphics Forum 21(3), 2002; differs: a plane for the whole way is sought instead of a time of
// impact).

namespace tactooth {
namespace {

constexpr std::uint64_t kGuessed = 1;    // stamp of a plane that GJK has not seen; poses are numbered from 2
constexpr double kStillNear = 0.995;     // of a gap below the margin: what staying put leaves of it, less rounding
constexpr double kTouchingMargins = 10;  // nearer than this, a triangle's own plane is looked at
constexpr double kRelativeGap = 0.9;     // of what GJK's plane leaves
constexpr double kNarrowMargins = 100;   // what single precision may not tell from touching
constexpr int kManyOfLeaf = 3;           // triangles of it in doubt: it is cheaper to ask for all at once

}  // namespace

/// A pair with the plane remembered for it, or with a direction for GJK to begin with.
WatchedPair ProxySolver::watch(const NearPair& pair, const Vec3& guess) const {
    const SeparatingPlane* known = planes_.find(partOf(*surface_, pair.part).id(), pair);
    return {pair, known != nullptr ? *known : SeparatingPlane{guess, 0, kGuessed}};
}

/// Takes the plane of one of the triangles themselves, if it parts them as well. Where the tool slides toward a concave
/// edge of the tooth, GJK's plane stands across the way, a margin in front of it; that of the triangle behind the edge
/// lets the tool slide on.
void ProxySolver::preferFace(const Triangle3& tooth, const Triangle3& tool, SeparatingPlane& plane) const {
    const double needed = kRelativeGap * std::min(margin_, lowestAlong(tool, plane.normal) - plane.offset);
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

/// Makes sure that a pair has a plane that was found at the present pose. False if nothing separates it.
bool ProxySolver::hasPlane(WatchedPair& watched) { return watched.plane.stamp == poseStamp_ || refreshPlane(watched); }

/// Finds the plane that separates the pair best at the present pose. False if nothing separates it.
bool ProxySolver::refreshPlane(WatchedPair& watched) {
    const SurfacePart& part = partOf(*surface_, watched.pair.part);
    const Triangle3 tooth = cornersOf(part.mesh(), watched.pair.tooth);
    const Triangle3 tool = tool_->cornersAt(pose_, watched.pair.tool);
    SeparatingPlane& plane = watched.plane;
    const GjkResult result =
        distanceBetween(tooth, tool, plane.normal.isZero() ? Vec3(tool[0] - tooth[0]) : plane.normal);
    ++distances_;
    work_ += cost::kDistance;
    if (!result.separated) return false;
    plane = {result.normal, highestAlong(tooth, result.normal), poseStamp_};
    if (result.distance < kTouchingMargins * margin_) preferFace(tooth, tool, plane);
    planes_.store(part.id(), watched.pair, plane);
    return true;
}

/// Width of the slab between the pair along its plane, with the tool at the pose given, mm.
double ProxySolver::gapAt(const WatchedPair& watched, const Mat3& rotation, const Vec3& position) const {
    const Vec3& normal = watched.plane.normal;
    const Vec3 inTool = rotation.transpose() * normal;
    return lowestAlong(tool_->corners(watched.pair.tool), inTool) + normal.dot(position) - watched.plane.offset;
}

/// The tool's triangle in the attempted step, with how far it reaches along the normals known so far.
ProxySolver::SweptTool& ProxySolver::sweep(std::uint32_t triangle, const Attempt& attempt, SweepQuery& query) const {
    SweptTool& swept = query.tool(triangle);
    if (swept.triangle != triangle) {
        swept.triangle = triangle;
        swept.measured = 0;
        const Triangle3 tool = tool_->corners(triangle);
        const Vec3 position = pose_.position + attempt.step;
        for (int corner = 0; corner < 3; ++corner) {
            swept.corners[corner] = attempt.startMatrix * tool[corner] + pose_.position;
            swept.corners[corner + 3] = attempt.matrix * tool[corner] + position;
        }
    }
    for (int& i = swept.measured; i < query.count; ++i) {
        swept.startLow[i] = swept.lowAtStart(query.normals[i]);
        swept.endLow[i] = swept.lowAtEnd(query.normals[i]);
    }
    return swept;
}

/// Whether the tool's triangle stays in front of what reaches no further than `toothTop` along a normal of the query,
/// during the whole attempted step.
bool ProxySolver::isSeparatedByActive(double toothTop, const SweptTool& swept, int normal) const {
    return swept.startLow[normal] > toothTop && swept.endLow[normal] - toothTop >= margin_ / 2;
}

/// Whether a plane is found that keeps the pair apart during the whole attempted step. Tried are those that the look
/// knows (what touches separates its neighbourhood too), the plane remembered, then GJK on the swept triangle of the
/// tool. A plane of the pair's own is remembered, and left in `own`.
bool ProxySolver::provenSafe(const NearPair& pair, const Attempt& attempt, SweepQuery& query,
                             const SeparatingPlane** own) {
    const SweptTool& swept = sweep(pair.tool, attempt, query);
    const double margin = margin_ / 2;
    const SurfacePart& part = partOf(*surface_, pair.part);
    const Triangle3 tooth = cornersOf(part.mesh(), pair.tooth);
    for (int i = 0; i < query.count; ++i) {
        if (isSeparatedByActive(highestAlong(tooth, query.normals[i]), swept, i)) return true;
    }
    const SeparatingPlane* known = planes_.find(part.id(), pair);
    *own = known;
    const auto isNarrow = [&](double gap) { return gap < kNarrowMargins * margin_; };
    if (known != nullptr && swept.lowAtStart(known->normal) > known->offset) {
        const double gap = swept.lowAtEnd(known->normal) - known->offset;
        if (gap >= margin && isNarrow(gap)) query.met(known->normal);
        if (gap >= margin) return true;
    }
    const Vec3 between = swept.corners[0] - tooth[0];
    // What is narrower is told as exactly as can be.
    const GjkResult result =
        separateConvex(tooth, swept.corners, known != nullptr ? known->normal : between, kNarrowMargins * margin_);
    ++distances_;
    work_ += cost::kDistance;
    if (result.gap < margin)
        return freedom_ == Freedom::TranslationAndRotation && separatedByRotatingPlane(tooth, swept);
    if (isNarrow(result.gap)) query.met(result.normal);
    *own = planes_.store(part.id(), pair, {result.normal, highestAlong(tooth, result.normal), kGuessed});
    return true;
}

/// Whether the attempted step would bring a pair together, of which no plane could prove that it would not.
ProxySolver::Violation ProxySolver::checkPair(const NearPair& pair, const Vec3& guess, const Attempt& attempt,
                                              WatchedPair& watched) {
    watched = watch(pair, guess);
    if (!hasPlane(watched)) return Violation::Overlapping;
    // A tool that stands nearer than the margin (a new surface under it, another margin) may stay as near.
    const double start = gapAt(watched, attempt.startMatrix, pose_.position);
    const double gap = gapAt(watched, attempt.matrix, pose_.position + attempt.step);
    return gap >= std::min(margin_ / 2, kStillNear * start) ? Violation::None : Violation::Found;
}

/// Looks first at the pairs that were in the way lately: nearly always they still are.
ProxySolver::Violation ProxySolver::recentViolation(const Attempt& attempt, SweepQuery& query, WatchedPair& violator) {
    for (std::size_t i = 0; i < recent_.size(); ++i) {
        const SeparatingPlane* own = nullptr;
        if (provenSafe(recent_[i], attempt, query, &own)) continue;
        const Violation violationFound = checkPair(recent_[i], Vec3::Zero(), attempt, violator);
        if (violationFound != Violation::None) return violationFound;
    }
    return Violation::None;
}

/// A pair that the attempted step would bring together: the first met. The search begins where the last one ended: what
/// came before was found safe under nearly the same step.
ProxySolver::Violation ProxySolver::violation(const Attempt& attempt, SweepQuery& query, WatchedPair& violator) {
    const Pose end{pose_.position + attempt.step, attempt.rotation};
    const auto held = std::span(query.normals).first(static_cast<std::size_t>(attempt.activeCount));
    const ToolMotion motion = list_.motion(pose_, end, margin_, held);
    const std::span<const std::uint32_t> packets = list_.within(motion);
    const Work opened = list_.takeWork();
    work_ += opened;
    if (lists_ <= 1) firstList_ += opened;
    if (list_.isFull()) return Violation::OutOfBudget;
    const auto begin = static_cast<std::size_t>(std::ranges::lower_bound(packets, lastViolation_) - packets.begin());
    for (std::size_t i = 0; i < packets.size(); ++i) {
        const std::uint32_t first = packets[(begin + i) % packets.size()];
        work_ += cost::kPacket;
        for (std::uint32_t near = list_.uncertainClusters(first, motion); near != 0; near &= near - 1) {
            const std::size_t cluster = first + static_cast<std::size_t>(std::countr_zero(near));
            const bool mayQuery = !isOutOfBudget() || stepScale_ <= kMinStepScale;
            const Violation violationFound =
                mayQuery ? violationIn(cluster, motion, attempt, query, violator) : Violation::OutOfBudget;
            if (violationFound == Violation::None) continue;
            lastViolation_ = first;
            return violationFound;
        }
    }
    return Violation::None;
}

ProxySolver::Violation ProxySolver::violationIn(std::size_t cluster, const ToolMotion& motion, const Attempt& attempt,
                                                SweepQuery& query, WatchedPair& violator) {
    work_ += cost::kCluster;
    if (isSeparatedByActive(cluster, attempt, query)) return Violation::None;
    std::uint32_t uncertain = list_.uncertainPairs(cluster, motion);
    if (std::popcount(uncertain) >= kManyOfLeaf) {
        measureLeaf(cluster, query);
        if (isSeparatedByActive(cluster, attempt, query)) return Violation::None;
    }
    for (; uncertain != 0; uncertain &= uncertain - 1) {
        work_ += cost::kPair;
        const std::size_t place = NeighbourList::placeOf(cluster, std::countr_zero(uncertain));
        const NearPair pair = list_[place];
        const SeparatingPlane* own = nullptr;
        if (provenSafe(pair, attempt, query, &own)) {
            if (own != nullptr) {
                list_.certify(place, own->normal, own->offset);
                if ((uncertain & (uncertain - 1)) != 0)  // what parts one pair often parts those beside it
                    uncertain = list_.separateBy(own->normal, cluster, uncertain & (uncertain - 1), motion) |
                                (uncertain & -uncertain);
            } else {
                measureLeaf(cluster, query);
            }
            continue;
        }
        const Violation violationFound = checkPair(pair, list_.direction(place), attempt, violator);
        if (violationFound != Violation::None) return violationFound;
    }
    return Violation::None;
}

/// Finds how far the leaf of a cluster reaches along the normals known so far, for the clusters to come.
void ProxySolver::measureLeaf(std::size_t cluster, SweepQuery& query) const {
    const std::uint32_t number = list_.leafOf(cluster);
    SweepQuery::Leaf& measured = query.leaf(number);
    if (measured.number != number) measured = {number, 0, {}};
    const int first = std::exchange(measured.measured, query.count);
    if (first == query.count) return;
    const auto top = std::span(measured.top).first(static_cast<std::size_t>(query.count));
    std::ranges::fill(top.subspan(static_cast<std::size_t>(first)), -std::numeric_limits<double>::infinity());
    const NearLeaf& leaf = list_.leaf(number);
    const TriangleMesh& mesh = partOf(*surface_, leaf.part).mesh();
    for (std::uint32_t rest = leaf.present; rest != 0; rest &= rest - 1) {
        for (int corner = 0; corner < 3; ++corner) {
            const Vec3 point = mesh.corner(leaf.triangle[std::countr_zero(rest)], corner);
            for (int i = first; i < query.count; ++i) top[i] = std::max(top[i], query.normals[i].dot(point));
        }
    }
}

/// Whether a plane of the look keeps a cluster apart whose leaf was measured in it.
bool ProxySolver::isSeparatedByActive(std::size_t cluster, const Attempt& attempt, SweepQuery& query) const {
    const std::uint32_t number = list_.leafOf(cluster);
    const SweepQuery::Leaf& measured = query.leaf(number);
    if (measured.number != number) return false;
    const SweptTool& swept = sweep(list_.toolOf(cluster), attempt, query);
    for (int i = 0; i < measured.measured; ++i) {
        if (isSeparatedByActive(measured.top[i], swept, i)) return true;
    }
    return false;
}

}  // namespace tactooth
