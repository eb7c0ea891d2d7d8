// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/pair_check.h"

#include <algorithm>
#include <bit>

#include "collision/narrow/gjk.h"

// Continuous collision detection by conservative bounds: S. Redon, A. Kheddar, S. Coquillart, "Fast Continuous
// Collision Detection between Rigid Bodies", Computer Graphics Forum 21(3), 2002. Differs from the paper: a swept
// triangle is the hull of its corners at both ends of the step, and the check looks for a plane that separates it
// during the whole step instead of a time of impact.

namespace tactooth {
namespace {

constexpr double kStillNear = 0.995;    // of a gap below the margin: what staying put leaves of it, less rounding
constexpr double kNarrowMargins = 100;  // a gap below so many margins is one that single precision may miss
constexpr int kManyOfLeaf = 3;          // uncertain pairs of a leaf: it is cheaper to test them all at once

}  // namespace

/// Whether a plane whose normal rotates during the step separates the tool's triangle from the tooth's. The normal goes
/// linearly from n0, which separates the two at the start, to n1, which separates them at the end. A tool that rocks on
/// an edge of the tooth sweeps through that edge as far as the hull of its corners can tell, but not through this
/// plane.
///
/// The corners q of the tool go linearly from q0 to q1. Their distance from a corner p of the tooth along the normal is
/// then a polynomial of degree two in time. It is positive if its three Bernstein coefficients are: n0 (q0 - p),
/// n1 (q1 - p) and n0 (q1 - p) + n1 (q0 - p).
bool PairCheck::isSeparatedByRotatingPlane(const Triangle3& tooth, const SweptTool& swept) {
    const auto start = std::span<const Vec3>(swept.corners).first(3);
    const auto end = std::span<const Vec3>(swept.corners).last(3);
    const GjkResult first = distanceBetween(tooth, start, start[0] - tooth[0]);
    if (!first.separated) return false;
    const GjkResult last = distanceBetween(tooth, end, first.normal);
    context_.budget.countDistances(2);
    if (last.gap < scene_.margin / 2) return false;
    for (const Vec3& p : tooth) {
        for (int i = 0; i < 3; ++i) {
            if (first.normal.dot(end[i] - p) + last.normal.dot(start[i] - p) < 0) return false;
        }
    }
    return true;
}

/// Whether some plane separates the pair during the whole step. Tries the planes of the query (what touches separates
/// its neighbourhood too), the remembered plane, then GJK on the swept triangle of the tool. Stores a plane of the
/// pair's own.
bool PairCheck::isSafe(const NearPair& pair, const SeparatingPlane** own) {
    const SweptTool& swept = query_.sweep(scene_, step_, pair.tool);
    const double margin = scene_.margin / 2;
    const SurfacePart& part = scene_.part(pair);
    const Triangle3 tooth = cornersOf(part.mesh(), pair.tooth);
    const std::span<const Vec3> normals = query_.normals();
    for (int i = 0; i < static_cast<int>(normals.size()); ++i) {
        if (SweepQuery::separates(highestAlong(tooth, normals[i]), swept, i, scene_.margin)) return true;
    }
    const SeparatingPlane* known = context_.planes.find(part.id(), pair);
    *own = known;
    const auto isNarrow = [&](double gap) { return gap < kNarrowMargins * scene_.margin; };
    if (known != nullptr && swept.lowAtStart(known->normal) > known->offset) {
        const double gap = swept.lowAtEnd(known->normal) - known->offset;
        if (gap >= margin && isNarrow(gap)) query_.addNarrow(known->normal);
        if (gap >= margin) return true;
    }
    const Vec3 between = swept.corners[0] - tooth[0];
    // A narrower gap is found as exactly as GJK can.
    const GjkResult result = separateConvex(tooth, swept.corners, known != nullptr ? known->normal : between,
                                            kNarrowMargins * scene_.margin);
    context_.budget.addDistance();
    if (result.gap < margin) return scene_.rotates() && isSeparatedByRotatingPlane(tooth, swept);
    if (isNarrow(result.gap)) query_.addNarrow(result.normal);
    *own = context_.planes.storeOfStep(part.id(), pair, result.normal, highestAlong(tooth, result.normal));
    return true;
}

/// Whether the step would bring together a pair that no plane has proven safe.
Violation PairCheck::violationOf(const NearPair& pair, const Vec3& guess, WatchedPair& violator) {
    violator = context_.planes.watch(scene_, pair, guess);
    if (!context_.ensurePlane(violator)) return Violation::Overlapping;
    // A tool that stands nearer than the margin (after a change of surface or margin) may stay as near.
    const double start = gapAt(*scene_.tool, violator, step_.startMatrix, scene_.pose.position);
    const double gap = gapAt(*scene_.tool, violator, step_.matrix, scene_.pose.position + step_.shift);
    return gap >= std::min(scene_.margin / 2, kStillNear * start) ? Violation::None : Violation::Found;
}

/// Gives the list the plane of a safe pair. What separates one pair often separates those beside it: such pairs leave
/// `uncertain`, whose lowest bit is the pair itself.
void PairCheck::certify(std::size_t place, const SeparatingPlane& own, std::size_t cluster, const ToolMotion& motion,
                        std::uint32_t& uncertain) {
    NeighbourList& list = context_.horizon.list();
    list.certify(place, own.normal, own.offset);
    const std::uint32_t others = uncertain & (uncertain - 1);
    if (others != 0) uncertain = list.separateBy(own.normal, cluster, others, motion) | (uncertain & -uncertain);
}

Violation PairCheck::checkCluster(std::size_t cluster, const ToolMotion& motion, WatchedPair& violator) {
    NeighbourList& list = context_.horizon.list();
    TACTOOTH_ASSERT(cluster < list.clusters());
    context_.budget.add(cost::kCluster);
    if (query_.separatesCluster(scene_, step_, list, cluster)) return Violation::None;
    std::uint32_t uncertain = list.uncertainPairs(cluster, motion);
    if (std::popcount(uncertain) >= kManyOfLeaf) {
        query_.measureLeaf(scene_, list, cluster);
        if (query_.separatesCluster(scene_, step_, list, cluster)) return Violation::None;
    }
    for (; uncertain != 0; uncertain &= uncertain - 1) {
        context_.budget.add(cost::kPair);
        const std::size_t place = NeighbourList::placeOf(cluster, std::countr_zero(uncertain));
        const NearPair pair = list[place];
        const SeparatingPlane* own = nullptr;
        if (!isSafe(pair, &own)) {
            const Violation found = violationOf(pair, list.direction(place), violator);
            if (found != Violation::None) return found;
        } else if (own != nullptr) {
            certify(place, *own, cluster, motion, uncertain);
        } else {
            query_.measureLeaf(scene_, list, cluster);
        }
    }
    return Violation::None;
}

}  // namespace tactooth
