// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/cut_command.h"

#include <fmt/core.h>

#include <array>
#include <optional>

#include "app/cli/runs/run_recording.h"
#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "collision/bvh/surface.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/files/folder.h"
#include "geometry/io/stl_writer.h"
#include "geometry/util/display_text.h"
#include "geometry/util/messages.h"
#include "session/cases/bur_by_name.h"
#include "session/cases/loaded_tooth.h"
#include "session/io/material_file.h"
#include "session/io/tick_csv.h"
#include "session/io/vdb_file.h"
#include "session/scripts/cut_run.h"
#include "session/simulation/cut_events.h"
#include "session/simulation/tooth_file.h"
#include "tooth/file/remaining_layers.h"

namespace tactooth {
namespace {

/// The table of the removed material: t, then the materials in the order of their roles (enamel, dentin, pulp, caries,
/// other), then all further materials.
class RemovedCsv {
public:
    [[nodiscard]] static Expected<RemovedCsv> create(const std::filesystem::path& path,
                                                     const MaterialRegistry& materials) {
        std::vector<std::string_view> columns = {"t"};
        for (const MaterialId id : materials.byRole()) columns.emplace_back(materials.nameOf(id));
        auto file = CsvWriter::create(path, columns);
        if (!file) return Unexpected{file.error()};
        return RemovedCsv(std::move(*file), materials);
    }

    void row(double time, const MaterialVolumes& removed) {
        row_.assign(1, time);
        for (const MaterialId id : materials_->byRole()) row_.push_back(removed[static_cast<std::size_t>(id)]);
        file_.row(row_);
    }
    [[nodiscard]] Expected<void> commit() { return file_.commit(); }

private:
    RemovedCsv(CsvWriter file, const MaterialRegistry& materials) : file_(std::move(file)), materials_(&materials) {}

    CsvWriter file_;
    const MaterialRegistry* materials_;
    std::vector<double> row_;
};

/// The output files of the command: all of them, or none.
class CutFiles {
public:
    /// Call it before any input is read, so that an obstacle to the files is reported at once.
    [[nodiscard]] Expected<void> open(const CutOptions& options) {
        for (const std::filesystem::path& input : {options.tooth, options.materials, options.tool, options.trajectory})
            set_.reads(input);
        for (const std::string& layer : options.layers) set_.reads(layer.substr(layer.find('=') + 1));
        for (const std::filesystem::path& output :
             {options.out, options.forces, options.removed, options.events, options.save, options.vdb}) {
            if (auto opened = set_.open(output); !opened) return opened;
        }
        if (options.layersOut.empty()) return {};
        return set_.makeFolder(options.layersOut);
    }

    /// Call it when the layers of the tooth are known.
    [[nodiscard]] Expected<void> begin(const CutOptions& options, const LayeredTooth& tooth) {
        watched_ = CutEvents(tooth.materials());
        if (!options.layersOut.empty()) {
            for (const std::string& layer : remainingLayerNames(tooth)) {
                if (auto opened = set_.open(layerFile(options.layersOut, layer)); !opened) return opened;
            }
        }
        if (!options.forces.empty()) {
            auto file = TickCsv::create(options.forces);
            if (!file) return Unexpected{file.error()};
            forces_.emplace(std::move(*file));
        }
        if (!options.removed.empty()) {
            auto file = RemovedCsv::create(options.removed, tooth.materials());
            if (!file) return Unexpected{file.error()};
            removed_.emplace(std::move(*file));
        }
        return {};
    }

    void row(double time, const Tick& tick, const ToothLoss& loss) {
        if (forces_) forces_->write(time, tick);
        if (removed_) removed_->row(time, loss.removed);
        watched_.update(time, tick, loss);
    }

    /// Writes everything that is known at the end.
    [[nodiscard]] Expected<void> finish(const CutOptions& options, const TriangleMesh& cut, const CutModel& piece,
                                        const Provenance& provenance) {
        if (auto done = writeStl(cut, options.out); !done) return done;
        if (forces_) {
            if (auto done = forces_->commit(); !done) return done;
        }
        if (removed_) {
            if (auto done = removed_->commit(); !done) return done;
        }
        if (!options.events.empty()) {
            if (auto done = writeFile(options.events, cutEventsCsv(watched_.all())); !done) return done;
        }
        if (!options.save.empty()) {
            if (auto done = saveTooth(piece, savedNow(provenance), options.save); !done) return done;
        }
        if (!options.vdb.empty()) {
            if (auto done = writeVdb(piece.volume(), savedNow(provenance), options.vdb); !done) return done;
        }
        if (!options.layersOut.empty()) {
            if (auto done = writeLayers(piece.volume(), options.layersOut); !done) return done;
        }
        return set_.commit();
    }

    [[nodiscard]] const FileTransaction& all() const { return set_; }

    void printLayers() const {
        for (const std::string& line : layerLines_) print("{}\n", line);
    }

private:
    [[nodiscard]] static std::filesystem::path layerFile(const std::filesystem::path& folder, const std::string& name) {
        return folder / (name + ".stl");
    }

    /// One STL file for each layer, with the layer's name.
    [[nodiscard]] Expected<void> writeLayers(const CutVolume& volume, const std::filesystem::path& folder) {
        for (const RemainingLayer& layer : remainingLayers(volume)) {
            const std::filesystem::path file = layerFile(folder, layer.name);
            if (layer.mesh.empty()) {
                layerLines_.push_back(fmt::format("nothing is left of layer '{}'", layer.name));
                continue;
            }
            if (auto written = writeStl(layer.mesh, file); !written) return written;
            layerLines_.push_back(fmt::format("{} triangles of layer '{}' written to {}", layer.mesh.triangles.size(),
                                              displayText(layer.name), displayName(file)));
        }
        return {};
    }

    FileTransaction set_;
    std::optional<TickCsv> forces_;
    std::optional<RemovedCsv> removed_;
    CutEvents watched_;
    std::vector<std::string> layerLines_;  // the report on the layer files, printed once they exist
};

Expected<ToothSource> toothSource(const CutOptions& options, const MaterialRegistry& materials) {
    ToothSource source{options.tooth, {}, options.material, options.materials.empty() ? nullptr : &materials};
    for (const std::string& text : options.layers) {
        auto layer = parseLayer(text, materials);
        if (!layer) return Unexpected{layer.error()};
        source.layers.push_back(std::move(*layer));
    }
    return source;
}

/// The bur that the options name, or else the bur of the case.
Expected<CustomBur> burOf(const CutOptions& options, const ToothPlacement& place,
                          std::vector<ImportNote>& importNotes) {
    if (!options.tool.empty()) return findOrReadBur(options.tool, &importNotes);
    if (place.bur) return *place.bur;
    return unexpected(msg::kNoBurGiven);
}

void printLoss(const ToothLoss& loss, const MaterialRegistry& materials) {
    for (const MaterialId id : materials.ids()) {
        const double removed = loss.removed[static_cast<std::size_t>(id)];
        if (removed > 0) print("removed {:>12}: {:8.3f} mm^3\n", materials.nameOf(id), removed);
    }
    if (loss.beside > 0) print("of it beside the tooth: {:.3f} mm^3\n", loss.beside);
}

}  // namespace

int runCut(const CutOptions& options) {
    if (!options.vdb.empty()) {
        if (const auto can = checkVdb(); !can) return reportError(can.error());
    }
    const auto known = materialsFrom(options.materials);
    if (!known) return reportError(known.error());
    const auto source = toothSource(options, **known);
    if (!source) return reportError(source.error());
    CutFiles files;
    if (const auto opened = files.open(options); !opened) return reportError(opened.error());
    RunRecording recording;
    if (const auto opened = recording.open(options.record, options.seal, &files.all()); !opened)
        return reportError(opened.error());
    const auto path = readTrajectory(options.trajectory);
    if (!path) return reportError(path.error());
    const auto tooth = loadModelOrCase(*source, options.workOn, options.voxel, CutOptions::kUsualVoxel);
    if (!tooth) return reportError(tooth.error());
    std::vector<ImportNote> importNotes = tooth->importNotes;
    auto bur = burOf(options, tooth->place, importNotes);
    if (!bur) return reportError(bur.error());
    printImportNotes(importNotes);
    const auto tool = makeCuttingTool(bur->surface, bur->sharpness);
    if (!tool) return reportError({msg::kNamedSentence, bur->name, tool.error()});
    CutModel& piece = *tooth->piece;
    const MaterialVolumes before = piece.removed();
    const MaterialTable materials(piece.tooth().materials());
    if (!options.vdb.empty()) {
        if (const auto fits = checkVdbSize(piece.tooth(), piece.volume().lattice().spacing()); !fits)
            return reportError(fits.error());
    }
    if (const auto begun = files.begin(options, piece.tooth()); !begun) return reportError(begun.error());

    if (const auto begun = recording.begin(piece, tooth->place.name); !begun) return reportError(begun.error());

    const auto visit = [&](double time, const Tick& tick, const ToothLoss& loss) { files.row(time, tick, loss); };
    const auto cutAll = [&] {
        const bool isRigid = options.feed == "rigid";
        HapticSettings settings;
        settings.materials = materials;
        settings.spindle = constantSpeed(options.speedRpm);
        Instrument instrument{std::make_shared<const ToolShape>(std::move(bur->surface)), *tool, bur->edge()};
        StepwiseSession session(tooth->piece,
                                isRigid ? rigidCutSetup(std::move(instrument), materials, options.speedRpm)
                                        : cutSetup(std::move(instrument), settings),
                                recording.sink());
        return isRigid ? cutKinematically(*path, options.speedRpm > 0, session, visit, recording.stop())
                       : cutWithRemovalLaw(*path, session, visit, recording.stop());
    };
    const Expected<void> done = cutAll();
    const Expected<void> recorded = recording.close(piece.hash());
    if (!done) return reportError(done.error());
    if (!recorded) return reportError(recorded.error());
    if (recording.stop().stop_requested()) return kExitOk;  // the signal ends the program
    const TaggedMesh cut = piece.exported();
    if (const auto written = files.finish(options, cut.mesh, piece, tooth->provenance); !written)
        return reportError(written.error());
    if (!options.vdb.empty()) print("voxels written to {}\n", displayName(options.vdb));
    files.printLayers();
    printLoss(piece.loss(), piece.tooth().materials());
    if (total(before) > 0) print("of which before:      {:8.3f} mm^3\n", total(before));
    print("{} triangles written to {}\n", cut.mesh.triangles.size(), displayName(options.out));
    return kExitOk;
}

}  // namespace tactooth
