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

/// Surfaces of one tooth as a scanner's program wrote them, in any unit and position.
struct Scan {
    std::string name;                                         ///< for messages
    TriangleMesh outer;                                       ///< empty: made from the layers
    std::vector<LayerMesh> layers;                            ///< empty: modelled
    std::vector<ImportNote> importNotes = {};                 ///< from reading the files
    const MaterialRegistry* materials = &builtinMaterials();  ///< of the layers
};

/// Adds the layer of a material, or the outer surface if there is no material. False if the scan has that surface
/// already.
[[nodiscard]] bool addSurface(Scan& scan, const std::optional<MaterialId>& material, TriangleMesh mesh);

/// Settings of the user for a scan; what is empty is guessed.
struct ImportOptions {
    std::optional<double> mmPerUnit{};
    FrameHints frame = {};
    HolesToFill holes = HolesToFill::Small;
    bool modelsLayers = true;  ///< false: a scan without layers is of one material
};

/// A scan in mm in the tooth frame, repaired.
struct ExaminedScan {
    std::string name;
    TriangleMesh outer;
    std::vector<LayerMesh> layers;
    double mmPerUnit = 1;
    Pose toothInFile;  ///< the file's frame scaled to mm
    std::vector<ImportNote> importNotes;
    bool layersAreModelled = false;
    bool enamelIsOuter = false;  ///< the enamel is the part of the outer surface that no other layer holds
    const MaterialRegistry* materials = &builtinMaterials();  ///< of the layers
};

/// Repairs, scales and rotates a scan. Fails with one sentence, which begins with the scan's name, if the surfaces are
/// empty or cannot be closed.
[[nodiscard]] Expected<ExaminedScan> examineScan(const Scan& scan, const ImportOptions& options);

/// Adds a layer model to a scan without layers (if `options` want that), takes what no layer holds as enamel, and
/// checks that the tooth can be cut. Takes some seconds; fails with "stopped" if `progress` returns false.
[[nodiscard]] Expected<ExaminedScan> finishScan(ExaminedScan scan, const ImportOptions& options,
                                                const Progress& progress = {});

}  // namespace tactooth
