// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/touch_simulation.h"

#include <algorithm>

#include "experiments/quantile.h"
#include "experiments/thread_clock.h"
#include "haptics/tool_proxy.h"

namespace tactooth {
namespace {

constexpr double kBurRadius = 0.7;  // mm, of the standard bur
constexpr double kTick = ToolProxy::kTick;

}  // namespace

HapticSimulation enamelSimulation(const std::shared_ptr<const ToolShape>& bur,
                                  const std::shared_ptr<const Surface>& surface) {
    HapticSettings settings;
    return {bur, kBurRadius, surface, settings};
}

std::vector<Tick> touchPath(const std::shared_ptr<const ToolShape>& bur, const std::shared_ptr<const Surface>& surface,
                            std::span<const Pose> devicePath, int repeat) {
    std::vector<Tick> ticks(devicePath.size());
    for (int run = 0; run < repeat; ++run) {
        HapticSimulation simulation = enamelSimulation(bur, surface);
        for (std::size_t i = 0; i < devicePath.size(); ++i) {
            const double before = run == 0 ? 0 : ticks[i].diagnostics.micros;
            const double start = threadMicros();
            ticks[i] = simulation.step({devicePath[i], 0, false}, kTick);
            const double micros = threadMicros() - start;
            ticks[i].diagnostics.micros = run == 0 ? micros : std::min(before, micros);
        }
    }
    return ticks;
}

ForceTiming forceMicros(std::span<const Tick> ticks) {
    std::vector<double> micros;
    for (const Tick& tick : ticks) {
        if (tick.contact.triangles > 0) micros.push_back(tick.diagnostics.micros);
    }
    return {quantile(micros, 0.5), quantile(micros, 0.99)};
}

}  // namespace tactooth
