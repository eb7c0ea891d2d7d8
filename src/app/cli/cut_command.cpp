// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cut_command.h"

#include <fmt/core.h>

#include <array>
#include <optional>

#include "app/cli/exit_code.h"
#include "collision/surface.h"
#include "geometry/atomic_file.h"
#include "geometry/folder.h"
#include "geometry/stl_writer.h"
#include "session/cases/placed_tooth.h"
#include "session/cut_events.h"
#include "session/cut_run.h"
#include "session/material_file.h"
#include "session/tick_csv.h"
#include "session/tooth_file.h"
#include "session/vdb_file.h"
#include "tooth/layer_remains.h"

namespace tactooth {
namespace {

constexpr double kUsualVoxel = 0.025;  // mm: walls true to a micrometre, and still hours of cutting in 600 MB

constexpr std::array<std::string_view, 6> kRemovedColumns = {"t", "enamel", "dentin", "pulp", "caries", "other"};

std::array<double, kRemovedColumns.size()> removedRow(double time, const MaterialVolumes& removed) {
    const auto of = [&](MaterialId id) { return removed[static_cast<std::size_t>(id)]; };
    return {time,
            of(MaterialId::Enamel),
            of(MaterialId::Dentin),
            of(MaterialId::Pulp),
            of(MaterialId::Caries),
            of(MaterialId::Restoration) + of(MaterialId::Other)};
}

/// The files that the command leaves behind: all of them, or none.
class CutFiles {
public:
    [[nodiscard]] Expected<void> open(const CutOptions& options) {
        if (auto file = AtomicFile::create(options.out)) {
            surface_.emplace(std::move(*file));
        } else {
            return Unexpected{file.error()};
        }
        if (!options.forces.empty()) {
            auto file = TickCsv::create(options.forces);
            if (!file) return Unexpected{file.error()};
            forces_.emplace(std::move(*file));
        }
        if (!options.removed.empty()) {
            auto file = CsvWriter::create(options.removed, kRemovedColumns);
            if (!file) return Unexpected{file.error()};
            removed_.emplace(std::move(*file));
        }
        if (!options.events.empty()) {
            auto file = AtomicFile::create(options.events);
            if (!file) return Unexpected{file.error()};
            events_.emplace(std::move(*file));
        }
        return {};
    }

    void row(double time, const Tick& tick, const ToothLoss& loss) {
        if (forces_) forces_->write(time, tick);
        if (removed_) removed_->row(removedRow(time, loss.removed));
        watched_.watch(time, tick, loss);
    }

    [[nodiscard]] Expected<void> finish(const TriangleMesh& mesh) {
        surface_->write(stlBytes(mesh, StlFormat::Binary));
        if (auto done = surface_->commit(); !done) return done;
        if (forces_) {
            if (auto done = forces_->commit(); !done) return done;
        }
        if (removed_) {
            if (auto done = removed_->commit(); !done) return done;
        }
        if (!events_) return {};
        events_->write(cutEventsCsv(watched_.all()));
        return events_->commit();
    }

private:
    std::optional<AtomicFile> surface_;
    std::optional<TickCsv> forces_;
    std::optional<CsvWriter> removed_;
    std::optional<AtomicFile> events_;
    CutEvents watched_;
};

Expected<ToothSource> toothSource(const CutOptions& options) {
    ToothSource source{options.tooth, {}, options.material};
    for (const std::string& text : options.layers) {
        auto layer = parseLayer(text);
        if (!layer) return Unexpected{layer.error()};
        source.layers.push_back(std::move(*layer));
    }
    return source;
}

/// One STL file a layer, named after it, in a folder that is made if it is not there.
Expected<void> writeLayers(const CutVolume& volume, const std::filesystem::path& folder) {
    if (auto done = makeFolder(folder); !done) return done;
    for (const LayerRemains& layer : remainsOfLayers(volume)) {
        const std::filesystem::path file = folder / (layer.name + ".stl");
        if (layer.mesh.empty()) {
            fmt::print("nothing is left of layer '{}'\n", layer.name);
            continue;
        }
        if (auto written = writeStl(layer.mesh, file); !written) return unexpected(written.error().message);
        fmt::print("{} triangles of layer '{}' written to {}\n", layer.mesh.triangles.size(), layer.name,
                   file.string());
    }
    return {};
}

/// The bur that is named, else the one that the case brings.
Expected<OwnBur> burOf(const CutOptions& options, const ToothPlace& place, std::vector<Remark>& remarks) {
    if (!options.tool.empty()) return readOwnBur(options.tool, &remarks);
    if (place.bur) return *place.bur;
    return unexpected("there is no bur: give --tool, or a case that brings one.");
}

void printLoss(const ToothLoss& loss) {
    for (std::size_t i = 0; i < kMaterialCount; ++i) {
        if (loss.removed[i] > 0)
            fmt::print("removed {:>12}: {:8.3f} mm^3\n", materialName(static_cast<MaterialId>(i)), loss.removed[i]);
    }
    if (loss.beside > 0) fmt::print("of it beside the tooth: {:.3f} mm^3\n", loss.beside);
}

}  // namespace

int runCut(const CutOptions& options) {
    if (!options.vdb.empty()) {
        if (const auto can = checkVdb(); !can) return refuse(can.error());
    }
    const auto source = toothSource(options);
    if (!source) return refuse(source.error());
    const auto path = readTrajectory(options.trajectory);
    if (!path) return refuse(path.error());
    const auto tooth = loadPlacedWork(*source, options.workOn, options.voxel, kUsualVoxel);
    if (!tooth) return refuse(tooth.error());
    std::vector<Remark> remarks = tooth->remarks;
    auto bur = burOf(options, tooth->place, remarks);
    if (!bur) return refuse(bur.error());
    printRemarks(remarks);
    const auto tool = makeCuttingTool(bur->surface, bur->sharpness);
    if (!tool) return refuse({bur->name + ": " + tool.error().message});
    WorkPiece& piece = *tooth->piece;
    const MaterialVolumes before = piece.removed();
    const auto materials = options.materials.empty() && tooth->place.materials ? *tooth->place.materials
                                                                               : materialsFrom(options.materials);
    if (!materials) return refuse(materials.error());
    CutFiles files;
    if (const auto opened = files.open(options); !opened) return refuse(opened.error());

    const auto visit = [&](double time, const Tick& tick, const ToothLoss& loss) { files.row(time, tick, loss); };
    if (options.feed == "rigid") {
        cutRigidly(*path, *tool, options.speedRpm, *materials, piece, visit);
    } else {
        HapticSettings settings;
        settings.materials = *materials;
        settings.spindle = constantSpeed(options.speedRpm);
        HapticSimulation simulation(std::make_shared<const ToolShape>(std::move(bur->surface)),
                                    tool->envelope.maxRadius(), piece.surface(), settings);
        cutByLaw(*path, *tool, *materials, simulation, piece, visit);
    }
    const TaggedMesh cut = piece.exported();
    if (const auto done = files.finish(cut.mesh); !done) return refuse(done.error());
    if (!options.save.empty()) {
        const auto saved = saveTooth(piece, savedNow(tooth->provenance), options.save);
        if (!saved) return refuse(saved.error());
    }
    if (!options.vdb.empty()) {
        const auto written = writeVdb(piece.volume(), savedNow(tooth->provenance), options.vdb);
        if (!written) return refuse(written.error());
        fmt::print("voxels written to {}\n", options.vdb.string());
    }
    if (!options.layersOut.empty()) {
        if (const auto written = writeLayers(piece.volume(), options.layersOut); !written)
            return refuse(written.error());
    }
    printLoss(piece.loss());
    if (total(before) > 0) fmt::print("of which before:      {:8.3f} mm^3\n", total(before));
    fmt::print("{} triangles written to {}\n", cut.mesh.triangles.size(), options.out.string());
    return kExitOk;
}

}  // namespace tactooth
