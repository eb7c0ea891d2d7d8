// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/proxy/move_result.h"
#include "collision/proxy/proxy_scene.h"

namespace tactooth {

/// What a proxy remembers of its last move: the goal, the pairs that held it, and the result if the proxy has settled.
///
/// A settled proxy stays where it is, bit for bit and without work, until its goal or surface changes.
class SettledState {
public:
    /// A proxy that the same pairs hold move after move is checked without their planes once in so many moves.
    static constexpr int kRecheckInterval = 8;

    /// Whether a move to `goal` would find again what the last move found.
    [[nodiscard]] bool answers(const Pose& goal) const {
        return isSettled_ && goal.position == goal_.position && goal.rotation.coeffs() == goal_.rotation.coeffs();
    }
    /// The result of a settled proxy, without iterations, GJK runs and work.
    [[nodiscard]] const MoveResult& result() const {
        TACTOOTH_ASSERT(isSettled_);
        return result_;
    }

    /// The pose from which the displacement of the goal is measured: the last goal, or `pose` if the proxy lags behind
    /// it.
    [[nodiscard]] const Pose& origin(const Pose& pose) const { return isLagging_ ? pose : goal_; }
    void beginMove(const Pose& goal) { goal_ = goal; }
    /// Whether the pairs that hold the proxy are those that held it at the end of the last move.
    [[nodiscard]] bool isUnchanged(const ActiveContacts& contacts) const;
    /// Whether they are the same and may be kept without a recheck in this move.
    [[nodiscard]] bool isKnown(const ActiveContacts& contacts) const {
        return isUnchanged(contacts) && unchangedMoves_ % kRecheckInterval != kRecheckInterval - 1;
    }
    /// Remembers the end of a move.
    void endMove(const MoveResult& result, const ActiveContacts& contacts);

    /// Forgets the pairs and the result, since the surface has changed.
    void forgetContacts() {
        heldCount_ = 0;
        isSettled_ = false;
    }
    /// Starts from a pose at which the proxy was placed.
    void placeAt(const Pose& pose) {
        forgetContacts();
        goal_ = pose;
        isLagging_ = false;
    }
    /// Makes the next move compute its result, also for the same goal.
    void unsettle() { isSettled_ = false; }

private:
    Pose goal_;
    bool isLagging_ = false;  // the last move ran out of iterations
    bool isSettled_ = false;
    int heldCount_ = 0;
    int unchangedMoves_ = 0;  // successive moves that ended with the same pairs
    std::array<NearPair, kMaxHeld> held_{};
    MoveResult result_;
};

}  // namespace tactooth
