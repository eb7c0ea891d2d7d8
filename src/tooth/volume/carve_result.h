// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tooth/volume/changed_brick.h"
#include "tooth/volume/material_volumes.h"

namespace tactooth {

struct CarveResult {
    MaterialVolumes removed{};
    std::vector<ChangedBrick> changed;  ///< in ascending order of the keys
};

/// The pieces that burs have cut off all around, after their removal.
struct DetachedPieces {
    std::vector<double> volumes;  ///< volume of each piece, mm^3, exact to about a voxel at its surface
    CarveResult carve;            ///< what was removed with them
};

}  // namespace tactooth
