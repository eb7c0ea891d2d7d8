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

/// Makes the outer surface of a tooth whose closed layers lie side by side and fit but nearly, as those from a CT do:
/// vertices within a tolerance become one, faces that two layers have in common fall away, and what is left is the
/// surface, with the triangles of the layers. Tolerances from 0.001 to 0.05 mm are tried in turn. Layers that lie
/// within one another or do not fit that well are joined by their distances instead, with new triangles of 0.2 mm.
/// Fails if that gives no closed surface either.
[[nodiscard]] Expected<MergedLayers> mergeLayers(const std::vector<LayerMesh>& layers);

}  // namespace tactooth
