// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

/// Told how much of a long work is done (0..1); false: stop.
using Progress = std::function<bool(double)>;

/// Layers inside a tooth of which only the surface is known.
struct LayerModel {
    std::vector<LayerMesh> layers;  ///< enamel (the whole surface), dentin, and pulp if there is room for one
    std::vector<ImportNote> how;
};

/// A model after textbook anatomy, no measurement. `outer`: closed, in the tooth frame with the neck at z = 0, mm.
///
/// The enamel is thickest over the biting surface and thins to nothing at the neck; its thickness goes with the crown's
/// width, 0.6 to 1.5 mm (front tooth to molar). The root is dentin to its surface. The pulp is a chamber in the neck's
/// height and a canal down the middle of each root, found as the places of the sections that lie deepest, at least
/// 0.5 mm below the surface; a surface with a hollow of its own keeps that as its pulp space. Fails with the sentence
/// "stopped" when told to stop.
[[nodiscard]] Expected<LayerModel> modelLayers(const TriangleMesh& outer, const Progress& progress = {},
                                               const MaterialRegistry& materials = builtinMaterials());

}  // namespace tactooth
