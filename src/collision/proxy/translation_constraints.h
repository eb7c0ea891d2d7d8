// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/proxy/candidate_step.h"
#include "collision/proxy/constraint_set.h"
#include "collision/proxy/proxy_context.h"

namespace tactooth {

/// The constraints of a step in position only (3 degrees of freedom), and the step nearest to the goal that they allow.
/// Same interface as RotationConstraints.
///
/// The unknown is the shift of the tool's origin, mm. The rotation of the step is given.
class TranslationConstraints {
public:
    static constexpr bool kRotates = false;
    using Set = ConstraintSet<3>;
    /// The most pairs that the next iteration is warm-started with.
    static constexpr int kMaxWarmStart = 8;

    [[nodiscard]] const Set& set() const { return set_; }

    /// The displacement of the tool's origin expected in this move, mm, as far as the contacts of the last move allow.
    /// `turn` is the chord of the rotation to the goal, and stays.
    [[nodiscard]] Vec3 predictShift(ProxyContext& context, const CandidateStep& step, double& turn) const;
    /// Starts an iteration with the contacts of the one before, and with the warm start.
    void restart(ProxyContext& context, const CandidateStep& step);
    /// Finds the step nearest to the goal under the constraints so far, shortened to its limits. False if there is
    /// none.
    [[nodiscard]] bool solve(const ProxyContext& context, CandidateStep& step);
    /// Adds a constraint that keeps a pair apart.
    void add(const ProxyContext& context, const CandidateStep& step, const WatchedPair& watched);
    /// Whether the active planes allow no motion toward the goal. A tool that stays where it is brings no pair
    /// together, so such a step needs no sweep check.
    [[nodiscard]] bool isStationary(const ProxyContext& context, const CandidateStep& step) const;
    /// Stores the active pairs in the context, and writes them as contacts at the present pose.
    void storeContacts(ProxyContext& context, MoveResult& result) const;

    /// Looks for other planes of the contacts that let a settled tool move on; see PlaneSwitch. True if there are some.
    /// The inactive pairs that the last iteration met warm-start the next one.
    [[nodiscard]] bool switchPlanes(ProxyContext& context, const Pose& goal);
    void clearWarmStart() { warmStartCount_ = 0; }
    /// The pairs of the warm start.
    [[nodiscard]] std::span<WatchedPair> warmStart() {
        return {warmStart_.data(), static_cast<std::size_t>(warmStartCount_)};
    }

private:
    void storeWarmStart(const ProxyScene& scene);

    Set set_;
    int warmStartCount_ = 0;
    std::array<WatchedPair, kMaxWarmStart> warmStart_;
};

}  // namespace tactooth
