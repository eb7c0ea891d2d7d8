// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/mesh/mesh_repair.h"
#include "patient/layer_model.h"
#include "patient/tooth_frame.h"

namespace tactooth {

/// Surfaces of one tooth as a scanner's program wrote them, in whatever unit and position.
struct Scan {
    std::string name;                          ///< for messages
    TriangleMesh outer;                        ///< empty: made from the layers
    std::vector<LayerMesh> layers;             ///< empty: modelled
    std::vector<ImportNote> importNotes = {};  ///< on reading the files
    const MaterialRegistry* materials = &builtinMaterials();
};

/// Takes the layer of a material, or the outer surface where there is none. False if the scan has that surface already.
[[nodiscard]] bool addSurface(Scan& scan, const std::optional<MaterialId>& material, TriangleMesh mesh);

/// What a person says about a scan; what is left open is guessed.
struct ImportOptions {
    std::optional<double> mmPerUnit;
    FrameHints frame = {};
    HolesToFill holes = HolesToFill::Small;
    bool modelsLayers = true;  ///< else a scan without layers is of one material
};

/// A scan in mm in the tooth's frame, mended.
struct ExaminedScan {
    std::string name;
    TriangleMesh outer;
    std::vector<LayerMesh> layers;
    double mmPerUnit = 1;
    Pose toothInFile;  ///< the file's frame scaled to mm
    std::vector<ImportNote> importNotes;
    bool layersAreModelled = false;
    bool enamelIsOuter = false;  ///< the enamel is what the other layers leave of the outer surface
    const MaterialRegistry* materials = &builtinMaterials();
};

/// Mends, scales and turns. Fails with one sentence, which begins with the scan's name, if the surfaces are empty or
/// cannot be closed.
[[nodiscard]] Expected<ExaminedScan> examineScan(const Scan& scan, const ImportOptions& options);

/// Gives a scan without layers those of a model (if `options` want that), takes what no layer holds as enamel, and
/// looks whether it is a tooth that can be cut. Takes some seconds; fails with "stopped" when `progress` says stop.
[[nodiscard]] Expected<ExaminedScan> finishScan(ExaminedScan scan, const ImportOptions& options,
                                                const Progress& progress = {});

}  // namespace tactooth
