// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/proxy/sweep_check.h"

#include <algorithm>
#include <bit>

#include "collision/proxy/pair_check.h"

namespace tactooth {

Violation SweepCheck::check(ProxyContext& context, const CandidateStep& step, SweepQuery& query,
                            WatchedPair& violator) {
    TACTOOTH_ASSERT(step.shift.allFinite());
    TACTOOTH_ASSERT(context.horizon.list().made());
    const Violation recent = checkRecent(context, step, query, violator);
    return recent != Violation::None ? recent : checkList(context, step, query, violator);
}

/// Checks the pairs that blocked the last steps. Usually they still do.
Violation SweepCheck::checkRecent(ProxyContext& context, const CandidateStep& step, SweepQuery& query,
                                  WatchedPair& violator) const {
    PairCheck pairs(context, step, query);
    for (std::size_t i = 0; i < recent_.size(); ++i) {
        const SeparatingPlane* own = nullptr;
        const Violation found = pairs.checkPair(recent_[i], Vec3::Zero(), &own, violator);
        if (found != Violation::None) return found;
    }
    return Violation::None;
}

/// Checks the clusters of the neighbour list. Begins where the last check found a violation: the clusters before were
/// found safe under nearly the same step.
Violation SweepCheck::checkList(ProxyContext& context, const CandidateStep& step, SweepQuery& query,
                                WatchedPair& violator) {
    PairCheck pairs(context, step, query);
    NeighbourList& list = context.horizon.list();
    const Pose& start = context.scene.pose;
    const ToolMotion motion = list.motion(start, step.end(start), context.scene.margin, query.activeNormals());
    const std::span<const std::uint32_t> packets = list.within(motion);
    context.budget.addListWork(list.takeWork(), context.horizon.rebuilds() <= 1);
    if (list.isFull()) return Violation::OutOfBudget;
    const auto begin = static_cast<std::size_t>(std::ranges::lower_bound(packets, lastViolation_) - packets.begin());
    for (std::size_t i = 0; i < packets.size(); ++i) {
        const std::uint32_t first = packets[(begin + i) % packets.size()];
        context.budget.add(cost::kPacket);
        for (std::uint32_t near = list.uncertainClusters(first, motion); near != 0; near &= near - 1) {
            const std::size_t cluster = first + static_cast<std::size_t>(std::countr_zero(near));
            const Violation found =
                context.budget.mayContinue() ? pairs.checkCluster(cluster, motion, violator) : Violation::OutOfBudget;
            if (found == Violation::None) continue;
            lastViolation_ = first;
            return found;
        }
    }
    return Violation::None;
}

}  // namespace tactooth
