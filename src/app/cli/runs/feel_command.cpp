// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/feel_command.h"

#include <algorithm>

#include "app/common/exit_code.h"
#include "app/cli/terminal/output.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_set.h"
#include "haptics/latency_histogram.h"
#include "haptics/load_surface.h"
#include "session/cases/open_case.h"
#include "session/scripts/feel_run.h"
#include "session/io/material_file.h"
#include "session/io/tick_csv.h"

namespace tactooth {
namespace {

/// What is felt, and its materials' numbers.
struct FeltTooth {
    std::shared_ptr<const Surface> surface;
    std::optional<MaterialTable> materials;
};

/// All of a case in the frame of one of its teeth, or a surface, which may be open.
Expected<FeltTooth> toothOf(const FeelOptions& options, std::vector<Remark>& remarks) {
    if (!isCase(options.tooth)) {
        auto surface = loadSurface(options.tooth, &remarks);
        if (!surface) return Unexpected{surface.error()};
        return FeltTooth{std::move(*surface), {}};
    }
    const auto opened = openCase(options.tooth, options.workOn);
    if (!opened) return Unexpected{opened.error()};
    auto surface = std::make_shared<Surface>();
    surface->base = opened->teeth->outer();
    return FeltTooth{std::move(surface), opened->materials};
}

}  // namespace

int runFeel(const FeelOptions& options) {
    FileSet files;
    for (const auto& input : {options.trajectory, options.tooth, options.tool, options.materials}) files.reads(input);
    if (const auto opened = files.open(options.out); !opened) return refuse(opened.error());
    const auto trajectory = readTrajectory(options.trajectory);
    if (!trajectory) return refuse(trajectory.error());
    std::vector<Remark> remarks;
    const auto tooth = toothOf(options, remarks);
    if (!tooth) return refuse(tooth.error());
    const auto tool = loadTool(options.tool, &remarks);
    if (!tool) return refuse(tool.error());
    printRemarks(remarks);
    const auto materials =
        options.materials.empty() && tooth->materials ? *tooth->materials : materialsFrom(options.materials);
    if (!materials) return refuse(materials.error());
    auto file = TickCsv::create(options.out);
    if (!file) return refuse(file.error());

    HapticSettings settings;
    settings.materials = *materials;
    settings.mode = options.mode == "penalty" ? ContactMode::Penalty : ContactMode::Proxy;
    settings.freedom = options.freedom == 6 ? Freedom::ShiftAndTurn : Freedom::Shift;
    settings.force = {options.stiffness, options.damping, options.friction};
    HapticSimulation simulation(*tool, (*tool)->radius(), tooth->surface, settings);
    LatencyHistogram micros;
    double strongest = 0;
    const auto felt = feelAlong(*trajectory, simulation, [&](double time, const Tick& tick) {
        file->write(time, tick);
        micros.add(tick.micros);
        strongest = std::max(strongest, tick.wrench.force.norm());
    });
    if (!felt) return refuse(felt.error());
    if (const auto done = file->commit(); !done) return refuse(done.error());
    if (const auto done = files.commit(); !done) return refuse(done.error());
    say("{} ticks written to {}\n", trajectory->size(), shownName(options.out));
    say("largest force {:.3f} N; time per tick p50 {:.1f}, p99 {:.1f}, max {:.1f} us\n", strongest,
        micros.quantile(0.5), micros.quantile(0.99), micros.largest());
    return kExitOk;
}

}  // namespace tactooth
