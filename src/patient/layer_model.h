// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

/// Called with the fraction of a long task that is done (0..1); returns false to stop it.
using Progress = std::function<bool(double)>;

/// Estimated layers inside a tooth of which only the surface is known.
struct LayerModel {
    std::vector<LayerMesh> layers;  ///< enamel (the whole surface), dentin, and pulp if there is room for one
    std::vector<ImportNote> how;
};

/// A model from textbook anatomy, not a measurement. `outer`: closed, in the tooth frame with the neck at z = 0, mm.
///
/// The enamel is thickest over the occlusal surface and ends at the neck; its thickness follows the width of the crown,
/// 0.6 to 1.5 mm (anterior tooth to molar). The root is dentin to its surface. The pulp is a chamber at the height of
/// the neck and a canal along the middle of each root, through the deepest points of the sections, at least 0.5 mm
/// below the surface. A surface with a void keeps that as its pulp space. The layers get materials of `materials` by
/// their roles. Fails with the sentence "stopped" if `progress` returns false.
[[nodiscard]] Expected<LayerModel> modelLayers(const TriangleMesh& outer, const Progress& progress = {},
                                               const MaterialRegistry& materials = builtinMaterials());

}  // namespace tactooth
