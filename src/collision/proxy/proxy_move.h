// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/proxy/candidate_step.h"
#include "collision/proxy/proxy_context.h"
#include "collision/proxy/rotation_constraints.h"
#include "collision/proxy/settled_state.h"
#include "collision/proxy/sweep_check.h"
#include "collision/proxy/translation_constraints.h"

namespace tactooth {

/// One move of a proxy toward a goal: iterations, each of which prepares a step, finds a safe one and accepts it.
/// `Constraints` is TranslationConstraints or RotationConstraints. Allocates nothing.
template <class Constraints>
class ProxyMove {
public:
    ProxyMove(ProxyContext& context, SweepCheck& sweep, SettledState& settled, const Pose& goal)
        : context_(context), sweep_(sweep), settled_(settled) {
        step_.goal = goal;
    }
    /// Runs the move. Call it once.
    [[nodiscard]] MoveResult run();

private:
    /// Solutions of the QP in one iteration after which the step is shortened, and at most. A rotation that does not
    /// converge needs many.
    static constexpr int kManySolutions = Constraints::Set::kCapacity + 1;
    static constexpr int kMaxSolutions = 8 * kManySolutions;

    // The phases.
    void begin();
    [[nodiscard]] bool prepareStep();
    [[nodiscard]] bool findSafeStep(Violation& found);
    void acceptStep();
    void end();

    [[nodiscard]] bool isCutShort() const;
    [[nodiscard]] bool ensureList(double& turn);
    void rotateLess();
    [[nodiscard]] bool constrain(const WatchedPair& violator, int solution);
    [[nodiscard]] bool retriesWithShorterList();
    void trySettle();

    ProxyContext& context_;
    SweepCheck& sweep_;
    SettledState& settled_;
    CandidateStep step_;
    Constraints constraints_;
    MoveResult result_;
    double trust_ = 0;           // longest step of the next iteration, mm
    int planeSwitches_ = 0;      // tried in this move
    bool hasRechecked_ = false;  // the contacts were found anew, without the planes that held the proxy
    bool hasStepped_ = false;
    bool mayWait_ = false;  // at the end of its list the proxy may wait for the next one
    bool isAhead_ = false;  // the proxy has left the list that it was given, and waits for the next one
};

extern template class ProxyMove<TranslationConstraints>;
extern template class ProxyMove<RotationConstraints>;

}  // namespace tactooth
