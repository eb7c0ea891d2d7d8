// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"

namespace tactooth {

/// The surface of a tooth without the walls of voids in it.
struct ExteriorSurface {
    TriangleMesh exterior;    ///< the triangles that face the outside
    double pulpWallArea = 0;  ///< mm^2, of the others: the walls of a pulp space in the scan
};

/// Separates the walls of voids from the outside of a closed surface, also where a narrow canal leads out of the void:
/// a ball of 1.2 mm that rolls around the tooth comes close to all of the outside, up to 2.5 mm deep in fissures, and
/// to no wall of a void.
[[nodiscard]] ExteriorSurface exteriorSurface(const SurfacePart& surface);

}  // namespace tactooth
