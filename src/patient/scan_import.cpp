// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/scan_import.h"

#include <algorithm>
#include <iterator>

#include "collision/solid/messages.h"
#include "collision/solid/solid.h"
#include "geometry/util/messages.h"
#include "patient/length_unit.h"
#include "patient/merged_layers.h"
#include "patient/messages.h"

namespace tactooth {
namespace {

constexpr const char* kOuter = "outer";  // the outer surface's name in messages

/// The word for a layer in an import note.
Message wordFor(const std::string& name, const MaterialRegistry& materials) {
    if (name == kOuter) return msg::kOuterSurface;
    const auto material = materials.find(name);
    return material ? Message::bilingual(name, materials[*material].titleJa) : Message::verbatim(name);
}

Vec3 middleOf(const TriangleMesh& mesh) { return boundingBox(mesh).center(); }

/// Examines one scan and collects the import notes.
class Examination {
public:
    Examination(const Scan& scan, const ImportOptions& options) : options_(options) {
        result_.name = scan.name;
        result_.outer = scan.outer;
        result_.layers = scan.layers;
        result_.importNotes = scan.importNotes;
        result_.materials = scan.materials;
    }

    Expected<ExaminedScan> run() && {
        if (result_.outer.empty() && result_.layers.empty()) return unexpected(msg::kNoSurface, result_.name);
        // Before the unit is guessed: a distant speck says nothing about the size of the tooth.
        for (LayerMesh& layer : result_.layers) mended_.push_back(mend(layer.mesh));
        if (!result_.outer.empty()) mended_.push_back(mend(result_.outer));
        takeUnit();
        for (std::size_t i = 0; i < result_.layers.size(); ++i) {
            LayerMesh& layer = result_.layers[i];
            if (auto done = makeSolid(layer.mesh, layer.name, mended_[i], false); !done)
                return Unexpected{done.error()};
        }
        if (result_.outer.empty()) {
            auto joined = mergeLayers(result_.layers);
            if (!joined) return unexpected(msg::kNamed, result_.name, joined.error());
            result_.outer = std::move(joined->outer);
            result_.importNotes.push_back(std::move(joined->how));
        } else if (auto done = makeSolid(result_.outer, kOuter, mended_.back(), true); !done) {
            return Unexpected{done.error()};
        }
        makeUpright();
        return std::move(result_);
    }

private:
    void takeUnit() {
        Box3 box = boundingBox(result_.outer);
        for (const LayerMesh& layer : result_.layers) box.extend(boundingBox(layer.mesh));
        const double longest = box.sizes().maxCoeff();
        if (options_.mmPerUnit) {
            result_.mmPerUnit = *options_.mmPerUnit;
            result_.importNotes.push_back(
                {ImportNoteTopic::Units,
                 {msg::kNoteScaled, rounded(*options_.mmPerUnit, 5), rounded(longest * *options_.mmPerUnit, 1)}});
        } else if (longest > 0) {
            ScaleGuess guess = guessScale(longest);
            result_.mmPerUnit = guess.mmPerUnit;
            result_.importNotes.push_back(std::move(guess.why));
        }
        scaleToMm(result_.outer, result_.mmPerUnit);
        for (LayerMesh& layer : result_.layers) scaleToMm(layer.mesh, result_.mmPerUnit);
    }

    template <class... Values>
    void importNote(const MessageText& text, const Values&... values) {
        result_.importNotes.push_back({ImportNoteTopic::Closedness, {text, values...}});
    }

    [[nodiscard]] RepairReport mend(TriangleMesh& mesh) const {
        RepairedMesh mended = repaired(mesh, {.holes = options_.holes});
        mesh = std::move(mended.mesh);
        return mended.report;
    }

    /// `done` is in the file's unit, `now` in mm.
    void addNotes(const RepairReport& done, const SolidReport& now, const std::string& name, std::size_t triangles) {
        const Message what = wordFor(name, *result_.materials);
        if (done.cracks.moved > 0) {
            importNote(msg::kNoteWelded, what, done.cracks.moved,
                       rounded(done.cracks.tolerance * result_.mmPerUnit, 6));
        }
        if (const std::size_t dropped = done.droppedDegenerate + done.droppedDuplicates; dropped > 0)
            importNote(msg::kNoteDegenerate, what, dropped);
        if (done.droppedPieces > 0) importNote(msg::kNoteSpecks, what, done.droppedPieces);
        if (done.flippedTriangles > 0) importNote(msg::kNoteTurnedOutward, what, done.flippedTriangles);
        if (done.filledHoles > 0) {
            importNote(msg::kNoteHolesFilled, what, done.filledHoles,
                       rounded(done.longestFilledRim * result_.mmPerUnit, 2));
        }
        std::vector<ImportNote> solid = notesOn(now, what);
        if (!done.changedAnything() && solid.empty()) importNote(msg::kNoteSound, what, triangles);
        std::ranges::move(solid, std::back_inserter(result_.importNotes));
        if (now.shells > 1) importNote(msg::kNoteShells, what, now.shells);
    }

    /// A sentence on why a repaired surface is not a solid.
    [[nodiscard]] Message refusal(const RepairReport& done, const SolidReport& now, const std::string& what) const {
        const std::string& name = result_.name;
        if (now.flaw == SolidFlaw::Open && done.openHoles > 0 && options_.holes != HolesToFill::All)
            return {msg::kHolesTooWide, name, what, done.openHoles, now.openEdges};
        if (now.flaw == SolidFlaw::Open) return {msg::kHolesNotClosed, name, what, now.openEdges};
        if (now.flaw == SolidFlaw::Overlapping && done.filledHoles > 0)
            return {msg::kFilledCrossing, name, what, rounded(now.overlap, 2), done.filledHoles};
        return {msg::kNamed, name, flawSentence(now, {msg::kTheSurfaceNamed, what})};
    }

    Expected<void> makeSolid(TriangleMesh& mesh, const std::string& what, const RepairReport& done, bool dropsSpecks) {
        ExaminedSolid solid = examineSolid(std::move(mesh), {.dropsSpecks = dropsSpecks});
        if (!solid.report.isSolid()) return unexpected(refusal(done, solid.report, what));
        mesh = std::move(solid.mesh);
        addNotes(done, solid.report, what, mesh.triangles.size());
        return {};
    }

    /// Direction to the enamel, if it is known.
    [[nodiscard]] std::optional<Vec3> crownHint() const {
        const auto of = [&](MaterialRole role) {
            return std::ranges::find_if(result_.layers, [&](const LayerMesh& layer) {
                return result_.materials->hasRole(layer.material, role);
            });
        };
        const auto enamel = of(MaterialRole::Enamel), dentin = of(MaterialRole::Dentin);
        if (enamel == result_.layers.end() || dentin == result_.layers.end()) return std::nullopt;
        const Vec3 displacement = middleOf(enamel->mesh) - middleOf(dentin->mesh);
        constexpr double kClear = 0.5;  // mm: enamel around all of the dentin says nothing
        return displacement.norm() > kClear ? std::optional(displacement) : std::nullopt;
    }

    void makeUpright() {
        FrameHints hints = options_.frame;
        if (!hints.crown) hints.crown = crownHint();
        FrameGuess guess = guessToothFrame(result_.outer, hints);
        result_.toothInFile = guess.toothInFile;
        std::ranges::move(guess.why, std::back_inserter(result_.importNotes));
        const Pose fileInTooth = guess.toothInFile.inverse();
        result_.outer = transformed(result_.outer, fileInTooth);
        for (LayerMesh& layer : result_.layers) layer.mesh = transformed(layer.mesh, fileInTooth);
    }

    const ImportOptions& options_;
    ExaminedScan result_;
    std::vector<RepairReport> mended_;  // of the layers, then of the outer surface
};

}  // namespace

bool addSurface(Scan& scan, const std::optional<MaterialId>& material, TriangleMesh mesh) {
    if (!material) {
        if (!scan.outer.empty()) return false;
        scan.outer = std::move(mesh);
        return true;
    }
    const auto isSame = [&](const LayerMesh& layer) { return layer.material == *material; };
    if (std::ranges::any_of(scan.layers, isSame)) return false;
    scan.layers.push_back({scan.materials->nameOf(*material), *material, std::move(mesh)});
    return true;
}

Expected<ExaminedScan> examineScan(const Scan& scan, const ImportOptions& options) {
    return Examination(scan, options).run();
}

Expected<ExaminedScan> finishScan(ExaminedScan scan, const ImportOptions& options, const Progress& progress) {
    if (scan.layers.empty() && options.modelsLayers) {
        auto model = modelLayers(scan.outer, progress, *scan.materials);
        if (!model) return Unexpected{model.error()};
        scan.layers = std::move(model->layers);
        scan.layersAreModelled = scan.enamelIsOuter = true;
        std::ranges::move(model->how, std::back_inserter(scan.importNotes));
    } else if (scan.layers.empty()) {
        scan.importNotes.push_back({ImportNoteTopic::Layers, msg::kNoteAllEnamel});
    }
    const bool hasEnamel = std::ranges::any_of(scan.layers, [&](const LayerMesh& layer) {
        return scan.materials->hasRole(layer.material, MaterialRole::Enamel);
    });
    if (!scan.layers.empty() && !hasEnamel) {
        const MaterialId enamel = scan.materials->withRole(MaterialRole::Enamel);
        scan.layers.insert(scan.layers.begin(), {scan.materials->nameOf(enamel), enamel, scan.outer});
        scan.enamelIsOuter = true;
        scan.importNotes.push_back({ImportNoteTopic::Layers, msg::kNoteNoEnamel});
    }
    const auto tooth = LayeredTooth::make(scan.outer, scan.layers, {}, {}, *scan.materials);
    if (!tooth) return unexpected(msg::kNamed, scan.name, tooth.error());
    return scan;
}

}  // namespace tactooth
