// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/proxy/proxy_context.h"
#include "collision/proxy/sweep_check.h"

namespace tactooth {

/// The tests of a sweep check on single pairs and clusters, for one step. Lives as long as the check.
class PairCheck {
public:
    PairCheck(ProxyContext& context, const CandidateStep& step, SweepQuery& query)
        : context_(context), scene_(context.scene), step_(step), query_(query) {}

    /// Checks one pair. A plane of the pair's own that proves it safe is left in `own`. With a violation, `violator` is
    /// the pair with its plane; `guess` is where GJK starts for it.
    [[nodiscard]] Violation checkPair(const NearPair& pair, const Vec3& guess, const SeparatingPlane** own,
                                      WatchedPair& violator) {
        return isSafe(pair, own) ? Violation::None : violationOf(pair, guess, violator);
    }
    /// Checks the uncertain pairs of a cluster.
    [[nodiscard]] Violation checkCluster(std::size_t cluster, const ToolMotion& motion, WatchedPair& violator);

private:
    [[nodiscard]] bool isSafe(const NearPair& pair, const SeparatingPlane** own);
    [[nodiscard]] bool isSeparatedByRotatingPlane(const Triangle3& tooth, const SweptTool& swept);
    [[nodiscard]] Violation violationOf(const NearPair& pair, const Vec3& guess, WatchedPair& violator);
    void certify(std::size_t place, const SeparatingPlane& own, std::size_t cluster, const ToolMotion& motion,
                 std::uint32_t& uncertain);

    ProxyContext& context_;
    const ProxyScene& scene_;
    const CandidateStep& step_;
    SweepQuery& query_;
};

}  // namespace tactooth
