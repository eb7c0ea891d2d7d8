// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tooth/volume/changed_brick.h"
#include "tooth/volume/material_volumes.h"

namespace tactooth {

/// What a carve has removed, and the bricks in which it has moved the boundary.
struct CarveResult {
    MaterialVolumes removed{};          ///< by material, mm^3
    std::vector<ChangedBrick> changed;  ///< in ascending order of the keys
};

/// The detached pieces that were removed.
struct DetachedPieces {
    std::vector<double> volumes;  ///< volume of each piece, mm^3, exact to about a voxel at its surface
    CarveResult carve;            ///< what was removed with them
};

}  // namespace tactooth
