// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/scripts/touch_run.h"

#include "session/io/finite_tick.h"

namespace tactooth {

Expected<void> runTouchPath(std::span<const TimedPose> trajectory, HapticSimulation& simulation,
                            const std::function<void(double, const Tick&)>& visit) {
    double last = trajectory.empty() ? 0 : trajectory.front().time;
    for (const TimedPose& row : trajectory) {
        double micros = 0;
        Tick tick = timed(micros, [&] { return simulation.step({row.toolInTooth, 0, false}, row.time - last); });
        tick.micros = micros;
        last = row.time;
        if (auto finite = checkFinite(row.time, tick); !finite) return finite;
        visit(row.time, tick);
    }
    return {};
}

}  // namespace tactooth
