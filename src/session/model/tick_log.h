// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "session/simulation/cut_events.h"

namespace tactooth {

/// What the runners have reported: the ticks of the last step, the newest tick, and the events since the tooth came
/// or was put back. The times of events go on from one runner to the next.
class TickLog {
public:
    /// Another runner begins; its times start at zero. `start` is the newest tick until the runner has made one.
    void restart(const Tick& start);
    /// The list of events begins anew, at the time of the newest tick. `materials`: of the tooth.
    void clearEvents(const MaterialRegistry& materials = builtinMaterials());
    /// Takes the ticks since the last call, oldest first, and leaves an empty buffer for the next ones. `loss`: of the
    /// tooth after the last of them.
    void record(std::vector<Tick>& ticks, const ToothLoss& loss);

    [[nodiscard]] const Tick& newest() const { return newest_; }
    /// Of the last `record`, oldest first.
    [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }
    [[nodiscard]] const CutEvents& events() const { return events_; }
    /// Since the first event, s; 0 before it.
    [[nodiscard]] double workSeconds() const;

private:
    std::vector<Tick> ticks_;
    Tick newest_;
    CutEvents events_;
    double timeBefore_ = 0;  // of the earlier runners, since the list of events began, s
};

}  // namespace tactooth
