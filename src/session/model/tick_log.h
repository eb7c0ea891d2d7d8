// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "session/simulation/session_work.h"

namespace tactooth {

/// What the runners have reported: the ticks of the last step, the newest tick, and the events since the tooth came
/// or was put back. The times of events go on from one runner to the next.
class TickLog {
public:
    /// Another runner begins; its times start at zero. `start` is the newest tick until the runner has made one.
    void restart(const Tick& start);
    /// The list of events begins anew, at the time of the newest tick. `materials`: of the tooth. `before`: what was
    /// done with it before; its events and its time go on.
    void clearEvents(const MaterialRegistry& materials = builtinMaterials(), const SessionWork& before = {});
    /// Takes the ticks since the last call, oldest first, and leaves an empty buffer for the next ones. `loss`: of the
    /// tooth after the last of them.
    void record(std::vector<Tick>& ticks, const ToothLoss& loss);

    [[nodiscard]] const Tick& newest() const { return newest_; }
    /// Of the last `record`, oldest first.
    [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }
    [[nodiscard]] const CutEvents& events() const { return events_; }
    [[nodiscard]] CutEvents& events() { return events_; }
    /// Since the list of events began, s: the time scale of its events.
    [[nodiscard]] double seconds() const { return timeBefore_ + newest_.time; }
    /// When the runner began, on the same scale, s.
    [[nodiscard]] double simulatorBegan() const { return timeBefore_; }
    /// Since the first event that counts, s; 0 before it.
    [[nodiscard]] double workSeconds() const;

private:
    std::vector<Tick> ticks_;
    Tick newest_;
    CutEvents events_;
    double timeBefore_ = 0;  // of the earlier runners, since the list of events began, s
};

}  // namespace tactooth
