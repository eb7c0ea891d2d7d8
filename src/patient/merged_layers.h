// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/io/import_note.h"
#include "geometry/util/expected.h"
#include "tooth/model/layered_tooth.h"

namespace tactooth {

/// The surface of all layers together.
struct MergedLayers {
    TriangleMesh outer;
    ImportNote how;
};

/// Makes the outer surface of a tooth whose closed layers are adjacent and fit nearly, such as those from a CT. It
/// welds vertices within a tolerance and removes faces that two layers have in common. What remains is the surface,
/// with the triangles of the layers. It tries tolerances from 0.001 to 0.05 mm. Layers that are nested, or fit worse,
/// are joined by their distances instead, with new triangles of 0.2 mm. Fails if that gives no closed surface either.
[[nodiscard]] Expected<MergedLayers> mergeLayers(const std::vector<LayerMesh>& layers);

}  // namespace tactooth
