// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/feel_command.h"

#include <algorithm>

#include "app/cli/runs/run_recording.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "haptics/latency_histogram.h"
#include "haptics/load_surface.h"
#include "session/cases/bur_by_name.h"
#include "session/cases/open_case.h"
#include "session/io/material_file.h"
#include "session/io/tick_csv.h"
#include "session/scripts/touch_run.h"

namespace tactooth {
namespace {

/// The surface that the tool touches, and the numbers of its materials.
struct TouchedTooth {
    std::shared_ptr<const Surface> surface;
    MaterialTable materials;
};

/// Returns the whole case in the frame of one of its teeth, or a surface, which may be open.
Expected<TouchedTooth> toothOf(const FeelOptions& options, const MaterialRegistry& materials,
                               std::vector<ImportNote>& importNotes) {
    if (!isCase(options.tooth)) {
        auto surface = loadSurface(options.tooth, &importNotes);
        if (!surface) return Unexpected{surface.error()};
        return TouchedTooth{std::move(*surface), MaterialTable(materials)};
    }
    const auto opened = openCase(options.tooth, options.workOn, options.materials.empty() ? nullptr : &materials);
    if (!opened) return Unexpected{opened.error()};
    auto surface = std::make_shared<Surface>();
    surface->base = opened->teeth->outer();
    return TouchedTooth{std::move(surface), MaterialTable(opened->teeth->materials())};
}

/// The surface as it is, which may be open: nothing cuts it.
std::shared_ptr<CutModel> modelOf(const TouchedTooth& touched) {
    constexpr double kVoxel = 0.05;  // mm: of a volume that is never used
    return std::make_shared<CutModel>(
        std::make_shared<const LayeredTooth>(
            LayeredTooth::touchOnly(touched.surface->base, touched.surface->closed, touched.materials.registry())),
        kVoxel);
}

}  // namespace

int runFeel(const FeelOptions& options) {
    FileTransaction files;
    for (const auto& input : {options.trajectory, options.tooth, options.tool, options.materials}) files.reads(input);
    if (const auto opened = files.open(options.out); !opened) return reportError(opened.error());
    RunRecording recording;
    if (const auto opened = recording.open(options.record, options.seal, &files); !opened)
        return reportError(opened.error());
    const auto trajectory = readTrajectory(options.trajectory);
    if (!trajectory) return reportError(trajectory.error());
    std::vector<ImportNote> importNotes;
    const auto materials = materialsFrom(options.materials);
    if (!materials) return reportError(materials.error());
    const auto tooth = toothOf(options, **materials, importNotes);
    if (!tooth) return reportError(tooth.error());
    const auto tool = findOrLoadTool(options.tool, &importNotes);
    if (!tool) return reportError(tool.error());
    printImportNotes(importNotes);
    auto file = TickCsv::create(options.out);
    if (!file) return reportError(file.error());

    HapticSettings settings;
    settings.materials = tooth->materials;
    settings.mode = options.mode == "penalty" ? ContactMode::Penalty : ContactMode::Proxy;
    settings.freedom = options.freedom == 6 ? Freedom::TranslationAndRotation : Freedom::Translation;
    settings.force = {options.stiffness, options.damping, options.friction};
    const auto model = modelOf(*tooth);
    if (const auto begun = recording.begin(*model, displayFileName(options.tooth)); !begun)
        return reportError(begun.error());
    StepwiseSession session(model, {touchingTool(*tool), settings, Placement::AtOnce}, recording.sink());
    LatencyHistogram micros;
    double maxForce = 0;
    const auto visit = [&](double time, const Tick& tick) {
        file->write(time, tick);
        micros.add(tick.diagnostics.micros);
        maxForce = std::max(maxForce, tick.force.wrench.force.norm());
    };
    const auto finished = runTouchPath(*trajectory, session, visit, recording.stop());
    const auto recorded = recording.close(model->hash());
    if (!finished) return reportError(finished.error());
    if (!recorded) return reportError(recorded.error());
    if (recording.stop().stop_requested()) return kExitOk;  // the signal ends the program
    if (const auto done = file->commit(); !done) return reportError(done.error());
    if (const auto done = files.commit(); !done) return reportError(done.error());
    print("{} ticks written to {}\n", trajectory->size(), displayName(options.out));
    print("largest force {:.3f} N; time per tick p50 {:.1f}, p99 {:.1f}, max {:.1f} us\n", maxForce,
          micros.quantile(0.5), micros.quantile(0.99), micros.largest());
    return kExitOk;
}

}  // namespace tactooth
