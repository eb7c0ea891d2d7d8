// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/proxy/proxy_context.h"
#include "collision/proxy/sweep_query.h"

namespace tactooth {

/// What a sweep check found about a step.
enum class Violation {
    None,         ///< the step brings no pair together
    Found,        ///< the step would bring a pair together
    Overlapping,  ///< a pair overlaps at the start of the step
    OutOfBudget,  ///< the check ended early: the allowance is used up, or the neighbour list is full
};

/// Finds a pair that a step would bring together, in the whole motion from start to end.
///
/// A pair is safe if some plane separates it during the whole step. The check first tries the slabs of the neighbour
/// list, eight clusters at a time; then the normals of the query; then the remembered plane of the pair; then it runs
/// GJK on the hull of the tool's triangle at both ends of the step.
class SweepCheck {
public:
    /// Checks a step. `query` must be new for each step. With Found, `violator` is the pair and its plane.
    [[nodiscard]] Violation check(ProxyContext& context, const CandidateStep& step, SweepQuery& query,
                                  WatchedPair& violator);
    /// Notes a pair that blocked a step: later checks begin with it.
    void addRecent(const NearPair& pair) { recent_.add(pair); }
    /// Forgets which pairs blocked steps.
    void clearRecent() { recent_.clear(); }
    /// Starts the next search at the first cluster.
    void restartSearch() { lastViolation_ = 0; }

private:
    [[nodiscard]] Violation checkRecent(ProxyContext& context, const CandidateStep& step, SweepQuery& query,
                                        WatchedPair& violator) const;
    [[nodiscard]] Violation checkList(ProxyContext& context, const CandidateStep& step, SweepQuery& query,
                                      WatchedPair& violator);

    RecentPairs recent_;
    std::uint32_t lastViolation_ = 0;  // first of the eight clusters in which the last search found a violation
};

}  // namespace tactooth
