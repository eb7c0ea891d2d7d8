// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "collision/bvh/surface.h"

namespace tactooth {

/// A tooth's surface without the walls of hollows within it.
struct ExteriorSurface {
    TriangleMesh exterior;    ///< the triangles that look at the outside
    double pulpWallArea = 0;  ///< mm^2, of the others: the walls of a pulp space that the scanner has seen
};

/// Tells the walls of hollows from the outside of a closed surface, also where a narrow canal leads out of the hollow:
/// a ball of 1.2 mm that rolls around the tooth gets near all of the outside, into fissures as far as 2.5 mm, and near
/// no wall of a hollow.
[[nodiscard]] ExteriorSurface exteriorSurface(const SurfacePart& surface);

}  // namespace tactooth
