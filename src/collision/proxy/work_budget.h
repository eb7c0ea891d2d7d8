// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "collision/neighbours/work_cost.h"
#include "geometry/util/assert.h"

namespace tactooth {

/// Counts the work of each move and limits it, for a loop that must keep its time. Work is counted, not timed, so equal
/// runs stay equal.
///
/// A move that exhausts its allowance stops where it is. The next move then gets twice the budget, so an expensive
/// situation ends after a few moves. A move that was stopped before its first step starves: the next move tries a
/// shorter first step, which makes fewer pairs uncertain. At the shortest first step the work is done whatever it
/// costs, so the proxy never stands still for long.
class WorkBudget {
public:
    /// The smallest factor on the usual first step.
    static constexpr double kMinStepScale = 1.0 / 64;
    /// The largest allowance of one move, in budgets.
    static constexpr Work kMaxAllowance = 2;

    /// Sets the budget of each move. A new value also resets the allowance of the next move.
    void setLimit(Work limit) {
        TACTOOTH_ASSERT(limit >= 0);
        TACTOOTH_ASSERT(limit == kUnlimitedWork || limit <= kUnlimitedWork / kMaxAllowance);
        if (limit != limit_) limit_ = allowed_ = limit;
    }
    [[nodiscard]] bool isLimited() const { return limit_ < kUnlimitedWork; }

    void beginMove() {
        work_ = firstList_ = 0;
        distances_ = 0;
    }
    void add(Work work) {
        TACTOOTH_ASSERT(work >= 0);
        work_ += work;
    }
    /// Counts GJK runs whose cost is part of another count.
    void countDistances(int count) {
        TACTOOTH_ASSERT(count > 0);
        distances_ += count;
    }
    /// Counts one GJK run with its cost.
    void addDistance() {
        ++distances_;
        work_ += cost::kDistance;
    }
    /// Adds the work of building a neighbour list. The first list of a move does not count against the allowance: a
    /// move that must build one shall still make progress.
    void addListWork(Work work, bool isFirstList) {
        TACTOOTH_ASSERT(work >= 0);
        work_ += work;
        if (isFirstList) firstList_ += work;
    }

    /// Whether the move has used up its allowance.
    [[nodiscard]] bool isExhausted() const { return work_ - firstList_ > allowed_; }
    /// Whether the search of the present iteration may continue: within the allowance, or at the shortest first step.
    [[nodiscard]] bool mayContinue() const { return !isExhausted() || stepScale_ <= kMinStepScale; }
    /// Whether the last move was stopped before its first step.
    [[nodiscard]] bool isStarved() const { return isStarved_; }
    /// Factor on the usual length of the first step, from kMinStepScale to 1.
    [[nodiscard]] double stepScale() const { return stepScale_; }

    /// Sets the allowance and the first step of the next move. `wasStopped`: this move ended for want of budget or
    /// list.
    void endMove(bool wasStopped, bool hasStepped) {
        const bool isOut = wasStopped && isExhausted();
        isStarved_ = isOut && !hasStepped;
        stepScale_ = isStarved_ ? std::max(stepScale_ / 4, kMinStepScale) : std::min(2 * stepScale_, 1.0);
        allowed_ = isOut ? std::min(2 * allowed_, kMaxAllowance * limit_) : limit_;
        TACTOOTH_ASSERT(allowed_ >= limit_ && stepScale_ >= kMinStepScale && stepScale_ <= 1);
    }
    /// Ends starvation: the proxy was put elsewhere. The allowance stays.
    void endStarvation() {
        isStarved_ = false;
        stepScale_ = 1;
    }

    /// Work of this move so far.
    [[nodiscard]] Work work() const { return work_; }
    /// GJK runs of this move so far.
    [[nodiscard]] int distances() const { return distances_; }

private:
    Work limit_ = kUnlimitedWork;
    Work allowed_ = kUnlimitedWork;  // in this move
    Work work_ = 0;
    Work firstList_ = 0;  // part of work_ that went into the first list of the move
    int distances_ = 0;
    bool isStarved_ = false;
    double stepScale_ = 1;
};

}  // namespace tactooth
