// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/feel_command.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/cli/exit_code.h"
#include "haptics/latency_histogram.h"
#include "haptics/load_surface.h"
#include "session/feel_run.h"
#include "session/material_file.h"
#include "session/tick_csv.h"

namespace tactooth {

int runFeel(const FeelOptions& options) {
    const auto trajectory = readTrajectory(options.trajectory);
    if (!trajectory) return refuse(trajectory.error());
    const auto tooth = loadSurface(options.tooth);
    if (!tooth) return refuse(tooth.error());
    const auto tool = loadTool(options.tool);
    if (!tool) return refuse(tool.error());
    const auto materials = materialsFrom(options.materials);
    if (!materials) return refuse(materials.error());
    auto file = TickCsv::create(options.out);
    if (!file) return refuse(file.error());

    HapticSettings settings;
    settings.materials = *materials;
    settings.mode = options.mode == "penalty" ? ContactMode::Penalty : ContactMode::Proxy;
    settings.freedom = options.freedom == 6 ? Freedom::ShiftAndTurn : Freedom::Shift;
    settings.force = {options.stiffness, options.damping, options.friction};
    HapticSimulation simulation(*tool, (*tool)->radius(), *tooth, settings);
    LatencyHistogram micros;
    double strongest = 0;
    feelAlong(*trajectory, simulation, [&](double time, const Tick& tick) {
        file->write(time, tick);
        micros.add(tick.micros);
        strongest = std::max(strongest, tick.wrench.force.norm());
    });
    if (const auto done = file->commit(); !done) return refuse(done.error());
    fmt::print("{} ticks written to {}\n", trajectory->size(), options.out.string());
    fmt::print("largest force {:.3f} N; time per tick p50 {:.1f}, p99 {:.1f}, max {:.1f} us\n", strongest,
               micros.quantile(0.5), micros.quantile(0.99), micros.largest());
    return kExitOk;
}

}  // namespace tactooth
