// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "patient/scan_import.h"

#include <algorithm>
#include <iterator>

#include "geometry/mesh_report.h"
#include "patient/joined_layers.h"
#include "patient/length_unit.h"

namespace tactooth {
namespace {

Vec3 middleOf(const TriangleMesh& mesh) { return boundingBox(mesh).center(); }

/// Does the work on one scan; the remarks gather on the way.
class Examination {
public:
    Examination(const Scan& scan, const ImportChoices& choices) : choices_(choices) {
        result_.name = scan.name;
        result_.outer = scan.outer;
        result_.layers = scan.layers;
        result_.remarks = scan.remarks;
    }

    Expected<ExaminedScan> run() && {
        if (result_.outer.empty() && result_.layers.empty()) return unexpected(result_.name + ": there is no surface.");
        takeUnit();
        for (LayerMesh& layer : result_.layers) {
            if (auto done = mend(layer.mesh, layer.name); !done) return Unexpected{done.error()};
        }
        if (result_.outer.empty()) {
            auto joined = joinLayers(result_.layers);
            if (!joined) return unexpected(result_.name + ": " + joined.error().message + ".");
            result_.outer = std::move(joined->outer);
            result_.remarks.push_back(std::move(joined->how));
        } else if (auto done = mend(result_.outer, "outer"); !done) {
            return Unexpected{done.error()};
        }
        standUp();
        return std::move(result_);
    }

private:
    void takeUnit() {
        Box3 box = boundingBox(result_.outer);
        for (const LayerMesh& layer : result_.layers) box.extend(boundingBox(layer.mesh));
        const double longest = box.sizes().maxCoeff();
        if (choices_.mmPerUnit) {
            result_.mmPerUnit = *choices_.mmPerUnit;
            result_.remarks.push_back({RemarkTopic::Units,
                                       "Scaled by %1, as chosen: the longest side is %2 mm.",
                                       {rounded(*choices_.mmPerUnit, 5), rounded(longest * *choices_.mmPerUnit, 1)}});
        } else if (longest > 0) {
            ScaleGuess guess = guessScale(longest);
            result_.mmPerUnit = guess.mmPerUnit;
            result_.remarks.push_back(std::move(guess.why));
        }
        scaleToMm(result_.outer, result_.mmPerUnit);
        for (LayerMesh& layer : result_.layers) scaleToMm(layer.mesh, result_.mmPerUnit);
    }

    void remark(const char* text, std::vector<std::string> values) {
        result_.remarks.push_back({RemarkTopic::Closedness, text, std::move(values)});
    }

    void tell(const RepairReport& done, const MeshReport& now, const std::string& what) {
        const auto number = [](std::size_t count) { return std::to_string(count); };
        if (done.droppedDegenerate + done.droppedDuplicates > 0) {
            remark("%1: %2 empty or doubled triangles were dropped.",
                   {what, number(done.droppedDegenerate + done.droppedDuplicates)});
        }
        if (done.droppedPieces > 0)
            remark("%1: %2 crumbs beside the surface were dropped.", {what, number(done.droppedPieces)});
        if (done.turnedTriangles > 0)
            remark("%1: %2 triangles were turned to look outward.", {what, number(done.turnedTriangles)});
        if (done.filledHoles > 0) {
            remark("%1: %2 holes were filled, the largest with a rim of %3 mm.",
                   {what, number(done.filledHoles), rounded(done.longestFilledRim, 2)});
        }
        if (!done.changedAnything())
            remark("%1: closed and sound as it came, %2 triangles.", {what, number(now.triangles)});
        if (now.shells.size() > 1) remark("%1: consists of %2 separate shells.", {what, number(now.shells.size())});
    }

    Expected<void> mend(TriangleMesh& mesh, const std::string& what) {
        RepairedMesh mended = repaired(mesh, {.holes = choices_.holes});
        const MeshReport now = reportOn(mended.mesh);
        if (mended.mesh.empty()) return unexpected(result_.name + ": the surface '" + what + "' has no area.");
        if (now.nonManifoldEdges > 0 && now.boundaryEdges > 0) {
            return unexpected(result_.name + ": " + std::to_string(now.nonManifoldEdges) + " edges of the surface '" +
                              what + "' have more than two triangles; mend it in a mesh program.");
        }
        if (now.boundaryEdges > 0) {
            return unexpected(result_.name + ": the surface '" + what + "' has " +
                              std::to_string(mended.report.openHoles) +
                              " holes that are too wide to be filled unasked (" + std::to_string(now.boundaryEdges) +
                              " open edges); ask for all holes to be filled, or close it in a mesh program.");
        }
        if (!now.watertight() && now.nonManifoldEdges == 0) {
            return unexpected(result_.name + ": the surface '" + what +
                              "' has no outside (it is twisted); mend it in a mesh program.");
        }
        tell(mended.report, now, what);
        mesh = std::move(mended.mesh);
        return {};
    }

    /// Toward the enamel, where it is known.
    [[nodiscard]] std::optional<Vec3> crownHint() const {
        const auto of = [&](MaterialId id) {
            return std::ranges::find(result_.layers, id, [](const LayerMesh& layer) { return layer.material; });
        };
        const auto enamel = of(MaterialId::Enamel), dentin = of(MaterialId::Dentin);
        if (enamel == result_.layers.end() || dentin == result_.layers.end()) return std::nullopt;
        const Vec3 way = middleOf(enamel->mesh) - middleOf(dentin->mesh);
        constexpr double kClear = 0.5;  // mm: enamel around all of the dentin tells nothing
        return way.norm() > kClear ? std::optional(way) : std::nullopt;
    }

    void standUp() {
        FrameHints hints = choices_.frame;
        if (!hints.crown) hints.crown = crownHint();
        FrameGuess guess = guessToothFrame(result_.outer, hints);
        result_.toothInFile = guess.toothInFile;
        std::ranges::move(guess.why, std::back_inserter(result_.remarks));
        const Pose fileInTooth = guess.toothInFile.inverse();
        result_.outer = transformed(result_.outer, fileInTooth);
        for (LayerMesh& layer : result_.layers) layer.mesh = transformed(layer.mesh, fileInTooth);
    }

    const ImportChoices& choices_;
    ExaminedScan result_;
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
    scan.layers.push_back({std::string(materialName(*material)), *material, std::move(mesh)});
    return true;
}

Expected<ExaminedScan> examineScan(const Scan& scan, const ImportChoices& choices) {
    return Examination(scan, choices).run();
}

Expected<ExaminedScan> finishScan(ExaminedScan scan, const ImportChoices& choices, const Progress& progress) {
    if (scan.layers.empty() && choices.modelsLayers) {
        auto model = modelLayers(scan.outer, progress);
        if (!model) return Unexpected{model.error()};
        scan.layers = std::move(model->layers);
        scan.layersAreModelled = scan.enamelIsOuter = true;
        std::ranges::move(model->how, std::back_inserter(scan.remarks));
    } else if (scan.layers.empty()) {
        scan.remarks.push_back({RemarkTopic::Layers, "The whole tooth is taken as enamel, as chosen."});
    }
    const bool hasEnamel =
        std::ranges::any_of(scan.layers, [](const LayerMesh& layer) { return layer.material == MaterialId::Enamel; });
    if (!scan.layers.empty() && !hasEnamel) {
        scan.layers.insert(scan.layers.begin(), {"enamel", MaterialId::Enamel, scan.outer});
        scan.enamelIsOuter = true;
        scan.remarks.push_back(
            {RemarkTopic::Layers, "No enamel is given: what no other layer holds is taken as enamel."});
    }
    const auto tooth = LayeredTooth::make(scan.outer, scan.layers);
    if (!tooth) return unexpected(scan.name + ": " + tooth.error().message + ".");
    return scan;
}

}  // namespace tactooth
