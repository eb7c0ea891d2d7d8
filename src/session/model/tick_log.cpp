// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/model/tick_log.h"

#include <algorithm>

namespace tactooth {

void TickLog::restart(const Tick& start) {
    timeBefore_ += newest_.time;
    newest_ = start;
}

void TickLog::clearEvents(const MaterialRegistry& materials, const SessionWork& before) {
    events_ = CutEvents(materials, before.events);
    timeBefore_ = before.seconds - newest_.time;
}

void TickLog::record(std::vector<Tick>& ticks, const ToothLoss& loss) {
    ticks_.swap(ticks);
    ticks.clear();
    if (!ticks_.empty()) newest_ = ticks_.back();
    for (const Tick& tick : ticks_) events_.update(timeBefore_ + tick.time, tick, loss);
}

double TickLog::workSeconds() const {
    const std::vector<CutEvent>& events = events_.all();
    const auto first = std::ranges::find(events, false, &CutEvent::isTakenBack);
    return first == events.end() ? 0 : seconds() - first->time;
}

}  // namespace tactooth
