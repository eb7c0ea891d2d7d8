// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/touch_run.h"

#include "session/io/finite_tick.h"

namespace tactooth {

Expected<void> runTouchPath(std::span<const TimedPose> trajectory, StepwiseSession& session,
                            const std::function<void(double, const Tick&)>& visit, const std::stop_token& stop) {
    double last = trajectory.empty() ? 0 : trajectory.front().time;
    for (const TimedPose& row : trajectory) {
        if (stop.stop_requested()) break;
        double micros = 0;
        Tick tick = timed(micros, [&] { return session.step({row.toolInTooth, 0, false}, row.time - last, row.time); });
        tick.diagnostics.micros = micros;
        last = row.time;
        if (auto finite = checkFinite(row.time, tick); !finite) return finite;
        visit(row.time, tick);
    }
    return {};
}

}  // namespace tactooth
