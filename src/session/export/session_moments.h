// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session/recording/session_replay.h"
#include "session/simulation/cut_events.h"

namespace tactooth {

/// Something of a session that a person wants to know.
struct SessionMoment {
    double time = 0;                 ///< s since the session began
    std::string what;                ///< "bur", "cut begun", "cut ended", "undo", "reset", or a cutEventName
    std::optional<Vec3> place = {};  ///< the bur's tip in the tooth's frame, mm
    /// Volume that was removed by a cut (positive) or put back by an undo or reset (negative), mm^3.
    std::optional<double> removed = {};
};

/// Finds the moments of a session while it is replayed. A cut begins when a spinning bur touches the tooth, and ends
/// when it has been lifted for the time after which the next cut can be undone alone.
class SessionMoments {
public:
    /// `replay` outlives this object and has not been played yet.
    explicit SessionMoments(const SessionReplay& replay);

    // For SessionReplay::playUntil.
    void onEvent(double time, const SessionEvent& event);
    void onTick(double time, const Tick& tick);
    /// The session is over.
    void finish();

    /// By rising time, once the session is over.
    [[nodiscard]] const std::vector<SessionMoment>& all() const { return all_; }

private:
    struct Cut {
        double lastContact = 0;  // s
        double removedBefore = 0;
        Vec3 place = Vec3::Zero();
    };
    void endCut();
    [[nodiscard]] double removed() const { return total(replay_->model().removed()); }

    const SessionReplay* replay_;
    CutEvents events_;
    std::vector<SessionMoment> all_;
    std::optional<Cut> cut_;
    double removedAtEdit_ = 0;  // mm^3, at the last tick
};

}  // namespace tactooth
